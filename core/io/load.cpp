#include "core/io/load.h"

#include "core/frame/move_scene.h"
#include "core/io/find_file.h"
#include "core/io/scene_builder.h"

#include <optional>

namespace dirt {

namespace {

namespace fs = std::filesystem;

std::string lowerCaseExtension(const fs::path& file) {
    std::string extension = file.extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = (char) (c - 'A' + 'a');
    return extension;
}

bool isModel(const std::string& extension) {
    return extension == ".obj" || extension == ".gltf" || extension == ".glb";
}

/// What is not glTF by its name is OBJ.
void addModel(const fs::path& file, const glm::dmat4& toWorld, SceneBuilder& builder) {
    const std::string extension = lowerCaseExtension(file);
    if (extension == ".gltf" || extension == ".glb")
        builder.addGltf(file, toWorld);
    else
        builder.addObj(file, toWorld);
}

fs::path findObject(const SceneFile& source, const SceneFile::Object& object) {
    const fs::path folder = source.file.parent_path();
    for (const std::string& directory : source.directories)
        if (const auto found = findFile(folder, directory + "/" + object.file)) return *found;
    if (const auto found = findFile(folder, object.file)) return *found;
    failAt(source.file, object.line, "object file " + inQuotes(object.file) + " not found");
}

/// Takes note of all positions and normals of \p mesh from the given ones on as what moves with a
/// space.
void addMovingPart(const Mesh& mesh, uint32_t space, size_t firstPosition, size_t firstNormal,
                   Animation& animation) {
    MovingPart& part = animation.parts.emplace_back();
    part.space = space;
    part.firstPosition = firstPosition;
    part.firstNormal = firstNormal;
    part.positions.assign(mesh.positions.begin() + (ptrdiff_t) firstPosition, mesh.positions.end());
    part.normals.assign(mesh.normals.begin() + (ptrdiff_t) firstNormal, mesh.normals.end());
}

void loadSceneFile(const fs::path& file, const LoadOptions& options, LoadReport& report,
                   LoadedScene& loaded) {
    const SceneFile source = readSceneFile(file, report);
    SceneBuilder builder(loaded.scene, report, options.cache && source.cache);
    Scene& scene = loaded.scene;
    scene.camera = source.camera;
    scene.background = source.background;
    scene.microfacetModel = source.microfacetModel;
    scene.toneMapping = source.toneMapping;
    if (source.light) scene.lights.push_back(*source.light);
    loaded.settings = source.settings;
    loaded.hasCamera = source.hasCamera;
    loaded.hasLight = source.light.has_value();
    scene.animation = source.animation;
    for (const SceneFile::Object& object : source.objects) {
        const size_t positions = scene.mesh.positions.size(), normals = scene.mesh.normals.size();
        addModel(findObject(source, object), object.toSpace, builder);
        if (object.space != MovingSpace::kWorld)
            addMovingPart(scene.mesh, object.space, positions, normals, scene.animation);
    }
}

} // namespace

LoadedScene loadScene(const fs::path& file, const LoadOptions& options) {
    LoadedScene loaded;
    LoadReport report(options.strict);
    const std::string extension = lowerCaseExtension(file);
    if (isModel(extension)) {
        SceneBuilder builder(loaded.scene, report, options.cache);
        addModel(file, glm::dmat4(1.0), builder);
    } else if (extension == ".scene") {
        loadSceneFile(file, options, report, loaded);
    } else {
        failAt(file, 0, "is no .scene, .obj, .gltf or .glb file");
    }
    if (loaded.scene.mesh.triangles.empty()) failAt(file, 0, "holds no triangles");

    SerialExecutor serial;
    moveScene(loaded.scene, 0, serial);
    loaded.scene.name = printable(file.stem().string());
    loaded.warnings = report.warnings();
    loaded.ignored = report.ignored();
    return loaded;
}

} // namespace dirt
