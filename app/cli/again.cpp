#include "app/cli/again.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace dirt {

namespace {

std::string vectorOption(const char* name, glm::vec3 v) {
    char text[128];
    std::snprintf(text, sizeof text, " %s %.9g,%.9g,%.9g", name, v.x, v.y, v.z);
    return text;
}

std::string option(const char* name, int value) {
    return std::string(" ") + name + " " + std::to_string(value);
}

template <class Is>
bool anyBackend(const CommonOptions& options, const Is& is) {
    const std::vector<BackendKind> backends =
        options.backends.empty() ? std::vector<BackendKind>{options.backend} : options.backends;
    return std::any_of(backends.begin(), backends.end(), is);
}

/// Whether one of the backends honours the options of the grid; else they would be refused.
bool usesGrid(const CommonOptions& options) {
    return anyBackend(options, [](BackendKind kind) { return kind != BackendKind::embree; });
}

bool usesGl(const CommonOptions& options) {
    return anyBackend(options, [](BackendKind kind) { return kind == BackendKind::gl; });
}

} // namespace

std::string shellWord(const std::string& text) {
    constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                        "0123456789_-+=.,:/@%";
    if (!text.empty() && text.find_first_not_of(kPlain) == text.npos) return text;
    std::string quoted = "'";
    for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
    return quoted + "'";
}

std::string commandStart(const std::string& command, const std::string& scene) {
    const char* shaders = std::getenv("DIRT_SHADERS");
    return (shaders ? "DIRT_SHADERS=" + shellWord(shaders) + " " : "") + "dirt " + command + " " +
           shellWord(scene);
}

std::string pointOption(const glm::dvec3& origin, glm::vec3 point) {
    // 17 digits give a double again, 9 a float.
    const int digits = origin == glm::dvec3(0.0) ? 9 : 17;
    const glm::dvec3 p = origin + glm::dvec3(point);
    char text[128];
    std::snprintf(text, sizeof text, "%.*g,%.*g,%.*g", digits, p.x, digits, p.y, digits, p.z);
    return text;
}

std::string cameraOptions(const glm::dvec3& origin, const Camera& camera) {
    char fov[32];
    std::snprintf(fov, sizeof fov, " --fov %.9g", camera.verticalFov);
    return " --eye " + pointOption(origin, camera.eye) + " --target " +
           pointOption(origin, camera.target) + vectorOption("--up", camera.up) + fov;
}

std::string structureOptions(const Input& input, const CommonOptions& common) {
    const GridSettings& grid = input.settings.grid;
    const Camera& camera = input.scene.camera;
    std::string options =
        usesGl(common) && common.device >= 0 ? option("--device", common.device) : "";
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
    options += cameraOptions(input.scene.origin, camera);
    if (common.memory) options += " --memory " + std::to_string(*common.memory);
    if (common.threads > 0) options += option("--threads", (int) common.threads);
    if (common.noCache) options += " --no-cache";
    if (common.strict) options += " --strict";
    return options;
}

std::string pathOptions(const Input& input, const CommonOptions& common) {
    const RenderSettings& settings = input.settings;
    constexpr const char* kRayTypes[] = {"default", "diffuse", "glossy", "specular", "visibility"};
    std::string options;
    if (usesGrid(common)) {
        options += settings.primary == Primary::raster ? " --primary raster" : " --primary traced";
        options += settings.fetch == Fetch::raster ? " --fetch raster" : " --fetch direct";
    }
    options += settings.visibility == LightVisibility::traced ? " --visibility traced"
                                                              : " --visibility shadowmap";
    if (settings.shading == Shading::packed) options += " --shading packed";
    // Refused where there are no indirect rays.
    if (settings.rayType == RayType::visibility || settings.bounces > 1)
        options += std::string(" --ray-type ") + kRayTypes[(size_t) settings.rayType];
    if (settings.rayType != RayType::visibility) options += option("--bounces", settings.bounces);
    options += " --seed " + std::to_string(settings.seed);
    if (common.materials) options += " --materials " + std::string(nameOf(*common.materials));
    return options;
}

} // namespace dirt
