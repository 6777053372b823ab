#include "app/cli/structure_options.h"

#include <algorithm>
#include <cstdio>

namespace dirt {

namespace {

std::string vectorOption(const char* name, glm::vec3 v) {
    char text[128];
    std::snprintf(text, sizeof text, " %s %.9g,%.9g,%.9g", name, v.x, v.y, v.z);
    return text;
}

/// Whether one of the backends honours the options of the grid; else they would be refused.
bool usesGrid(const CommonOptions& options) {
    const std::vector<BackendKind> backends =
        options.backends.empty() ? std::vector<BackendKind>{options.backend} : options.backends;
    return std::any_of(backends.begin(), backends.end(),
                       [](BackendKind kind) { return kind != BackendKind::embree; });
}

} // namespace

std::string pointOption(const Scene& scene, glm::vec3 point) {
    // 17 digits give a double again, 9 a float.
    const int digits = scene.origin == glm::dvec3(0.0) ? 9 : 17;
    const glm::dvec3 p = scene.inFiles(point);
    char text[128];
    std::snprintf(text, sizeof text, "%.*g,%.*g,%.*g", digits, p.x, digits, p.y, digits, p.z);
    return text;
}

std::string structureOptions(const Input& input, const CommonOptions& common) {
    const GridSettings& grid = input.settings.grid;
    const Camera& camera = input.scene.camera;
    const auto option = [](const char* name, int value) {
        return std::string(" ") + name + " " + std::to_string(value);
    };
    std::string options = common.device >= 0 ? option("--device", common.device) : "";
    options += input.frame > 0 ? option("--frame", input.frame) : "";
    options += grid.mode == ViewMode::full ? " --view full" : " --view single";
    options += " --size " + std::to_string(grid.width) + "x" + std::to_string(grid.height);
    if (usesGrid(common)) {
        if (grid.viewSize > 0) options += option("--view-size", grid.viewSize);
        options += option("--tile", grid.tile) + option("--bins", grid.bins);
        if (grid.maxMip >= 0) options += option("--max-mip", grid.maxMip);
        if (grid.traversal == Traversal::linear) options += " --traversal linear";
        if (grid.precision == Precision::fast) options += " --precision fast";
    }
    options += " --eye " + pointOption(input.scene, camera.eye) + " --target " +
               pointOption(input.scene, camera.target) + vectorOption("--up", camera.up);
    char fov[32];
    std::snprintf(fov, sizeof fov, " --fov %.9g", camera.verticalFov);
    return options + fov;
}

} // namespace dirt
