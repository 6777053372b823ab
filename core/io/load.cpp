#include "core/io/load.h"

#include "core/base/error.h"
#include "core/frame/move_scene.h"
#include "core/io/find_file.h"
#include "core/io/partial_scenes.h"
#include "core/io/place_models.h"
#include "core/io/scene_origin.h"

#include <algorithm>
#include <functional>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace dirt {

namespace {

namespace fs = std::filesystem;

fs::path findObject(const SceneFile& source, const SceneFile::Object& object) {
    const fs::path folder = source.file.parent_path();
    for (const std::string& directory : source.directories)
        if (const auto found = findFile(folder, directory + "/" + object.file)) return *found;
    if (const auto found = findFile(folder, object.file)) return *found;
    failAt(source.file, object.line, "object file " + inQuotes(object.file) + " not found");
}

/// Option --materials would have no effect.
void checkMaterials(const std::vector<Model>& models) {
    const auto isObj = [](const Model& m) { return std::holds_alternative<ObjFile>(m.file); };
    if (std::none_of(models.begin(), models.end(), isObj))
        throw InputError("--materials: has no effect without an OBJ file");
}

/// A scene of those models of \p list that are there, added to what \p head says. What it takes and
/// what is noticed does not count.
LoadedScene partOf(LoadedScene head, std::span<const Placed> list,
                   std::span<const SceneBuilder::Use> uses, const std::vector<bool>& there,
                   const MemoryBudget& memory) {
    std::vector<Placed> listThere;
    std::vector<SceneBuilder::Use> usesThere;
    for (size_t i = 0; i < list.size(); ++i) {
        if (!there[i]) continue;
        listThere.push_back(list[i]);
        usesThere.push_back(uses[i]);
    }
    const MemoryBudget left = memory.hasLimit() ? MemoryBudget(memory.left()) : memory;
    LoadReport unheard;
    SceneBuilder builder(head.scene, unheard, left);
    builder.leaveOutTextures();
    placeModels(listThere, usesThere, left, builder, unheard, head);
    return head;
}

/// Reads each file once, on threads, and places what it holds as often as it is named. \p complete:
/// what is left to do for a part of the scene when its models are placed.
void loadModels(std::vector<Placed> list, const LoadOptions& options, LoadReport& report,
                LoadedScene& loaded, const std::function<void(LoadedScene&)>& complete = {}) {
    std::vector<fs::path> files;
    std::map<fs::path, size_t> places;
    for (Placed& placed : list) {
        if (places.try_emplace(placed.file, files.size()).second) files.push_back(placed.file);
        if (options.materials) placed.materials = {MaterialChoice::By::option, *options.materials};
    }
    std::vector<Model> models(files.size());
    std::vector<SceneBuilder::Use> uses;
    for (const Placed& placed : list)
        uses.push_back({&models[places[placed.file]], placed.materials});

    SerialExecutor serial;
    Executor& executor = options.executor ? *options.executor : serial;
    PartialScenes parts(options.partial, files.size(), [&](const std::vector<bool>& isRead) {
        std::vector<bool> there;
        for (const Placed& placed : list) there.push_back(isRead[places.at(placed.file)]);
        LoadedScene part = partOf(loaded, list, uses, there, options.memory);
        complete(part);
        return part;
    });
    const LoadProgress progress = parts.after(options.progress);
    readAll(files.size(), executor, progress, [&](size_t i) {
        models[i] = readModel(files[i], options.cache, options.memory);
        parts.add(i);
    });
    if (options.materials) checkMaterials(models);
    SceneBuilder builder(loaded.scene, report, options.memory);
    builder.readTexturesAhead(uses, executor, progress);
    placeModels(list, uses, options.memory, builder, report, loaded);
}

/// A model by itself. Other programs' materials are meant for GGX; glTF says so.
void loadModel(const fs::path& file, const LoadOptions& options, LoadReport& report,
               LoadedScene& loaded) {
    LoadOptions own = options;
    own.partial = {};
    loadModels({Placed{file}}, own, report, loaded);
    const bool isDemo = std::any_of(
        loaded.materialFiles.begin(), loaded.materialFiles.end(),
        [](const MaterialFile& taken) { return taken.convention == MaterialConvention::demo; });
    if (!isDemo) loaded.scene.microfacetModel = MicrofacetModel::ggx;
}

/// Looks through the first camera of the model files, where no scene file says better.
void chooseModelCamera(LoadedScene& loaded) {
    for (ModelCamera& camera : loaded.cameras)
        if (camera.halfHeight) camera.camera = fromAfar(camera, loaded.scene.mesh);
    if (loaded.hasCamera || loaded.cameras.empty()) return;
    loaded.scene.camera = loaded.cameras.front().camera;
    loaded.modelCamera = 0;
    loaded.hasCamera = true;
}

/// What is left to do when all of a scene is in its place.
void finish(const fs::path& file, LoadedScene& loaded) {
    Mesh& mesh = loaded.scene.mesh;
    if (!mesh.colors.empty()) mesh.colors.resize(mesh.positions.size(), glm::vec3(1.0f));
    loaded.hasLight = !loaded.scene.lights.empty();
    SerialExecutor serial;
    moveScene(loaded.scene, 0, serial);
    loaded.scene.name = printable(file.stem().string());
}

void loadSceneFile(const fs::path& file, const LoadOptions& options, LoadReport& report,
                   LoadedScene& loaded) {
    const SceneFile source = readSceneFile(file, report, options.memory);
    Scene& scene = loaded.scene;
    scene.camera = source.camera;
    scene.background = source.background;
    scene.microfacetModel = source.microfacetModel;
    scene.toneMapping = source.toneMapping;
    if (source.light) scene.lights.push_back(*source.light);
    loaded.settings = source.settings;
    loaded.hasCamera = source.hasCamera;
    scene.animation = source.animation;
    std::vector<Placed> list;
    std::map<std::string, fs::path> found;
    for (const SceneFile::Object& object : source.objects) {
        fs::path& place = found[object.file];
        if (place.empty()) place = findObject(source, object);
        list.push_back({place, object.toSpace, object.space, object.doubleSided,
                        MaterialChoice::inSceneFile(source.materials, object.materials)});
    }
    LoadOptions own = options;
    own.cache = options.cache && source.cache;
    if (!source.showParts || !source.hasCamera) own.partial = {};
    loadModels(std::move(list), own, report, loaded, [&](LoadedScene& part) {
        moveToOrigin(source, part.scene);
        finish(file, part);
    });
    moveToOrigin(source, scene);
}

/// Why there may be none.
std::string firstSkipped(const LoadReport& report) {
    for (const Warning& warning : report.warnings())
        if (warning.kind == WarningKind::skippedGeometry) return " (" + warning.text + ")";
    return "";
}

} // namespace

LoadedScene loadScene(const fs::path& file, const LoadOptions& options) {
    const FolderListings listings;
    LoadedScene loaded;
    LoadReport report(options.strict);
    if (isModelFile(file))
        loadModel(file, options, report, loaded);
    else if (lowerCaseExtension(file) == ".scene")
        loadSceneFile(file, options, report, loaded);
    else
        failAt(file, 0, "is no .scene, .obj, .gltf or .glb file");
    if (loaded.scene.mesh.triangles.empty())
        failAt(file, 0, "holds no triangles" + firstSkipped(report));
    chooseModelCamera(loaded);
    finish(file, loaded);
    loaded.warnings = report.warnings();
    loaded.ignored = report.ignored();
    loaded.caches = report.caches();
    return loaded;
}

} // namespace dirt
