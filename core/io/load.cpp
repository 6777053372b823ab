#include "core/io/load.h"

#include "core/base/error.h"
#include "core/frame/move_scene.h"
#include "core/io/find_file.h"
#include "core/io/mesh_size.h"
#include "core/io/scene_builder.h"
#include "core/io/scene_origin.h"

#include <algorithm>
#include <map>
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

/// Takes note of all positions and normals of \p mesh from the given ones on as what moves with a
/// space, in which \p origin is taken off them.
void addMovingPart(const Mesh& mesh, uint32_t space, const glm::dvec3& origin, size_t firstPosition,
                   size_t firstNormal, Animation& animation) {
    MovingPart& part = animation.parts.emplace_back();
    part.space = space;
    part.origin = origin;
    part.firstPosition = firstPosition;
    part.firstNormal = firstNormal;
    part.positions.assign(mesh.positions.begin() + (ptrdiff_t) firstPosition, mesh.positions.end());
    part.normals.assign(mesh.normals.begin() + (ptrdiff_t) firstNormal, mesh.normals.end());
}

/// A model file that is to be placed.
struct Placed {
    fs::path file;
    glm::dmat4 toSpace{1.0};
    uint32_t space = MovingSpace::kWorld;
    bool doubleSided = true;
    MaterialChoice materials = {};
};

/// Option --materials, which overrides all.
void chooseMaterials(MaterialConvention convention, const std::vector<Model>& models,
                     std::vector<Placed>& list) {
    const auto isObj = [](const Model& m) { return std::holds_alternative<ObjFile>(m.file); };
    if (std::none_of(models.begin(), models.end(), isObj))
        throw InputError("--materials: has no effect without an OBJ file");
    for (Placed& placed : list) placed.materials = {MaterialChoice::By::option, convention};
}

/// Triangles of a file, as often as they are placed.
struct Rounded {
    uint64_t lost = 0; ///< without area in float32
    uint64_t triangles = 0;
};

void warnOfRounding(const fs::path& file, const Rounded& rounded, LoadReport& report) {
    if (rounded.lost > 0)
        report.warn(WarningKind::precision, file, 0,
                    std::to_string(rounded.lost) + " of " + std::to_string(rounded.triangles) +
                        " triangles are too small for float32 at their coordinates: they lose "
                        "their area");
}

/// Takes the memory of all that is placed, before any is, and makes room for it.
void makeRoom(const std::vector<Placed>& list, const std::vector<SceneBuilder::Use>& uses,
              const MemoryBudget& budget, Mesh& mesh) {
    MeshSize sum;
    for (size_t i = 0; i < list.size(); ++i) {
        const MeshSize size = placedSize(*uses[i].model);
        const bool moves = list[i].space != MovingSpace::kWorld;
        const uint64_t copied = moves ? size.positions + size.normals : 0;
        budget.spend(size.bytes() + copied * sizeof(glm::vec3), list[i].file,
                     "each of " + std::to_string(size.triangles) +
                         " triangles, as often as it is "
                         "placed,");
        sum += size;
    }
    reserve(sum, mesh);
}

/// Reads each file once, on threads, and places what it holds as often as it is named.
void placeModels(std::vector<Placed> list, bool cache, const LoadOptions& options,
                 LoadReport& report, LoadedScene& loaded) {
    Scene& scene = loaded.scene;
    std::vector<fs::path> files;
    std::map<fs::path, size_t> places;
    for (const Placed& placed : list)
        if (places.try_emplace(placed.file, files.size()).second) files.push_back(placed.file);

    SerialExecutor serial;
    Executor& executor = options.executor ? *options.executor : serial;
    std::vector<Model> models(files.size());
    readAll(files.size(), executor, options.progress,
            [&](size_t i) { models[i] = readModel(files[i], cache, options.memory); });
    if (options.materials) chooseMaterials(*options.materials, models, list);
    std::vector<SceneBuilder::Use> uses;
    for (const Placed& placed : list)
        uses.push_back({&models[places[placed.file]], placed.materials});
    SceneBuilder builder(scene, report, options.memory);
    builder.readTexturesAhead(uses, executor, options.progress);
    makeRoom(list, uses, options.memory, scene.mesh);
    OriginFinder origins(scene.animation);
    for (size_t i = 0; i < list.size(); ++i)
        origins.add(*uses[i].model, list[i].toSpace, list[i].space);
    scene.origin = origins.ofWorld();
    std::map<fs::path, Rounded> perFile;
    for (size_t i = 0; i < list.size(); ++i) {
        const Placed& placed = list[i];
        const size_t positions = scene.mesh.positions.size(), normals = scene.mesh.normals.size();
        const glm::dvec3 origin = origins.ofSpace(i);
        const size_t triangles = scene.mesh.triangles.size();
        Rounded& rounded = perFile[placed.file];
        rounded.lost +=
            builder.add(uses[i], relativeTo(origin, placed.toSpace), placed.doubleSided);
        rounded.triangles += scene.mesh.triangles.size() - triangles;
        if (placed.space != MovingSpace::kWorld)
            addMovingPart(scene.mesh, placed.space, origin, positions, normals, scene.animation);
        else
            placeModelViews(*uses[i].model, relativeTo(origin, placed.toSpace), report,
                            loaded.cameras, scene.lights);
    }
    for (const fs::path& file : files) warnOfRounding(file, perFile[file], report);
    loaded.materialFiles = builder.materialFiles();
}

/// A model by itself. Other programs' materials are meant for GGX; glTF says so.
void loadModel(const fs::path& file, const LoadOptions& options, LoadReport& report,
               LoadedScene& loaded) {
    placeModels({Placed{file}}, options.cache, options, report, loaded);
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
    placeModels(std::move(list), options.cache && source.cache, options, report, loaded);
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
    loaded.hasLight = !loaded.scene.lights.empty();

    Mesh& mesh = loaded.scene.mesh;
    if (!mesh.colors.empty()) mesh.colors.resize(mesh.positions.size(), glm::vec3(1.0f));
    SerialExecutor serial;
    moveScene(loaded.scene, 0, serial);
    loaded.scene.name = printable(file.stem().string());
    loaded.warnings = report.warnings();
    loaded.ignored = report.ignored();
    loaded.caches = report.caches();
    return loaded;
}

} // namespace dirt
