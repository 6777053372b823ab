#include "core/io/load.h"

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

fs::path findObject(const SceneFile& source, const SceneFile::Object& object) {
    const fs::path folder = source.file.parent_path();
    for (const std::string& directory : source.directories)
        if (const auto found = findFile(folder, directory + "/" + object.file)) return *found;
    if (const auto found = findFile(folder, object.file)) return *found;
    failAt(source.file, object.line, "object file " + inQuotes(object.file) + " not found");
}

void loadSceneFile(const fs::path& file, SceneBuilder& builder, LoadReport& report,
                   LoadedScene& loaded) {
    const SceneFile source = readSceneFile(file, report);
    Scene& scene = loaded.scene;
    scene.camera = source.camera;
    scene.background = source.background;
    scene.toneMapping = source.toneMapping;
    if (source.light) scene.lights.push_back(*source.light);
    loaded.settings = source.settings;
    loaded.hasCamera = source.hasCamera;
    loaded.hasLight = source.light.has_value();
    for (const SceneFile::Object& object : source.objects)
        builder.addObj(findObject(source, object), object.toWorld);
}

} // namespace

LoadedScene loadScene(const fs::path& file, const LoadOptions& options) {
    LoadedScene loaded;
    LoadReport report(options.strict);
    SceneBuilder builder(loaded.scene, report);
    const std::string extension = lowerCaseExtension(file);
    if (extension == ".obj")
        builder.addObj(file, glm::dmat4(1.0));
    else if (extension == ".scene")
        loadSceneFile(file, builder, report, loaded);
    else
        failAt(file, 0, "is neither a .scene nor a .obj file");
    if (loaded.scene.mesh.triangles.empty()) failAt(file, 0, "holds no triangles");

    loaded.scene.name = printable(file.stem().string());
    loaded.warnings = report.warnings();
    loaded.ignored = report.ignored();
    return loaded;
}

} // namespace dirt
