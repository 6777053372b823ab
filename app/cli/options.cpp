#include "app/cli/options.h"

#include "app/cli/memory_limit.h"
#include "app/cli/option_scope.h"
#include "app/cli/option_values.h"
#include "core/base/error.h"
#include "core/grid/view.h"
#include "core/scene/animation.h"

#include <glm/geometric.hpp>

namespace dirt {

namespace {

constexpr int kMaxSize = 65536;

void addStructureOptions(Command command, CommonOptions& o) {
    addChoice(command, "--backend", {"cpu", "gl", "embree"}, "what finds the hits (default: cpu)",
              [&o](size_t i) { o.backend = (BackendKind) i; });
    addInteger(
        command, "--device", 0, 63,
        "of --backend gl, as dirt info --devices counts them (default: the first that works)",
        [&o](int64_t n) { o.device = (int) n; });
    addChoice(command, "--view", {"full", "single"},
              "six views around the eye, or only the camera's (default: full)",
              [&o](size_t i) { o.view = i == 0 ? ViewMode::full : ViewMode::single; });
    addInteger(command, "--tile", 1, kLargestTile, "pixels along a tile (default: by cost)",
               [&o](int64_t n) { o.tile = (int) n; });
    addInteger(command, "--bins", 1, kMostBins, "depth bins of a tile (default: by cost)",
               [&o](int64_t n) { o.bins = (int) n; });
    addInteger(command, "--view-size", 1, kMaxSize,
               "pixels along a cube face (default: the image's height)",
               [&o](int64_t n) { o.viewSize = (int) n; });
    addInteger(command, "--max-mip", 0, kHighestLevel,
               "highest level of the depth pyramid that is used (default: all)",
               [&o](int64_t n) { o.maxMip = (int) n; });
    addChoice(command, "--traversal", {"hierarchical", "linear"},
              "through the depth pyramid, or tile by tile (default: hierarchical)", [&o](size_t i) {
                  o.traversal = i == 0 ? Traversal::hierarchical : Traversal::linear;
              });
    addChoice(command, "--primary", {"raster", "traced"},
              "how the first surface is found (default: raster)",
              [&o](size_t i) { o.primary = i == 0 ? Primary::raster : Primary::traced; });
    addChoice(command, "--fetch", {"raster", "direct"},
              "how material data is found: by rasterizing against the hits, or by primitive id "
              "(default: raster)",
              [&o](size_t i) { o.fetch = i == 0 ? Fetch::raster : Fetch::direct; });
    addChoice(command, "--visibility", {"traced", "shadowmap"},
              "how it is found whether the light reaches a point (default: traced)",
              [&o](size_t i) { o.visibility = (LightVisibility) i; });
    addChoice(command, "--shading", {"full", "packed"},
              "what surface points are kept in: 80 bytes, or rounded in 32 at most (default: full)",
              [&o](size_t i) { o.shading = i == 0 ? Shading::full : Shading::packed; });
    addChoice(command, "--precision", {"exact", "fast"},
              "hits by exact signs, or by a plain float test that loses some (default: exact)",
              [&o](size_t i) { o.precision = i == 0 ? Precision::exact : Precision::fast; });
}

void addImageOptions(Command command, CommonOptions& o) {
    addSize(command, "--size", kMaxSize, "image size (default: 1024x512)",
            [&o](int width, int height) {
                o.size = ImageSize{width, height};
            });
    addInteger(command, "--spp", 1, 1 << 24, "samples per pixel (default: 16)",
               [&o](int64_t n) { o.samples = (int) n; });
    addInteger(command, "--bounces", 1, kMostBounces,
               "path length, 1: direct light only (default: 3)",
               [&o](int64_t n) { o.bounces = (int) n; });
    addChoice(command, "--ray-type", {"default", "diffuse", "glossy", "specular", "visibility"},
              "what indirect rays take surfaces for; visibility: how open the surroundings are",
              [&o](size_t i) { o.rayType = (RayType) i; });
    addInteger(command, "--seed", 0, 0xffffffffll, "of the random numbers (default: 0)",
               [&o](int64_t n) { o.seed = (uint32_t) n; });
    command.addText("--camera", o.camera,
                    "of a glTF file: which one, counted from 0, or its name (default: the first)");
    addVector(command, "--eye", "where the camera stands", [&o](glm::dvec3 v) { o.eye = v; });
    addVector(command, "--target", "what it looks at", [&o](glm::dvec3 v) { o.target = v; });
    addVector(command, "--up", "which way is up", [&o](glm::dvec3 v) { o.up = v; });
    addNumber(command, "--fov", 0.0f, 180.0f, "vertical field of view, degrees",
              [&o](float degrees) { o.verticalFov = degrees; });
    addInteger(command, "--frame", 0, kMaxFrame, "of an animated scene (default: 0)",
               [&o](int64_t n) { o.frame = (int) n; });
}

} // namespace

const char* nameOf(BackendKind kind) {
    constexpr const char* kNames[] = {"cpu", "gl", "embree"};
    return kNames[(size_t) kind];
}

void addCommonOptions(Command command, CommonOptions& o) {
    command.addText("SCENE", o.scene, "a .scene, .obj, .gltf or .glb file").required();
    addSettingsOptions(command, o);
}

void addSettingsOptions(Command command, CommonOptions& o) {
    addImageOptions(command, o);
    addStructureOptions(command, o);
    addInteger(command, "--threads", 1, 1024, "worker threads (default: all cores)",
               [&o](int64_t n) { o.threads = (unsigned) n; });
    addBytes(
        command, "--memory",
        "memory that a scene may take: its files, and a frame (default: half of what there is)",
        [&o](uint64_t bytes) { o.memory = bytes; });
    command.addFlag("--quiet", o.quiet, "print nothing but errors on standard error");
    command.addFlag("--no-cache", o.noCache, "neither read nor leave caches of models (NAME.sbin)");
    command.addFlag("--strict", o.strict, "take what the scene lacks as an error");
    addChoice(
        command, "--materials", {"demo", "wavefront"},
        "what the numbers of MTL files mean (default: demo for a .scene file's, wavefront for "
        "an .obj file's)",
        [&o](size_t i) { o.materials = (MaterialConvention) i; });
    limitOptions(command, o);
}

RenderSettings mergeSettings(RenderSettings settings, const CommonOptions& o) {
    GridSettings& grid = settings.grid;
    grid.mode = o.view.value_or(grid.mode);
    if (o.size) {
        grid.width = o.size->width;
        grid.height = o.size->height;
    }
    grid.viewSize = o.viewSize.value_or(grid.viewSize);
    grid.tile = o.tile.value_or(grid.tile);
    grid.bins = o.bins.value_or(grid.bins);
    grid.maxMip = o.maxMip.value_or(grid.maxMip);
    grid.traversal = o.traversal.value_or(grid.traversal);
    grid.precision = o.precision.value_or(grid.precision);
    settings.primary = o.primary.value_or(settings.primary);
    settings.fetch = o.fetch.value_or(settings.fetch);
    settings.visibility = o.visibility.value_or(settings.visibility);
    settings.shading = o.shading.value_or(settings.shading);
    settings.samples = o.samples.value_or(settings.samples);
    settings.bounces = o.bounces.value_or(settings.bounces);
    settings.rayType = o.rayType.value_or(settings.rayType);
    if (settings.rayType == RayType::visibility) settings.bounces = 2;
    settings.seed = o.seed.value_or(settings.seed);
    checkMemory(grid, sceneMemory(o));
    return settings;
}

void checkCameraOptions(const CommonOptions& o) {
    if (o.eye && o.eye == o.target) throw InputError("--eye and --target are the same point");
    if (o.camera && (o.eye || o.target))
        throw InputError("--camera says where to stand, and so do --eye and --target");
    if (o.up == glm::vec3(0.0f)) throw InputError("--up is zero");
}

Camera mergeCamera(const Scene& scene, const CommonOptions& o) {
    Camera camera = scene.camera;
    if (o.eye) camera.eye = scene.fromFiles(*o.eye);
    if (o.target) camera.target = scene.fromFiles(*o.target);
    camera.up = o.up.value_or(camera.up);
    camera.verticalFov = o.verticalFov.value_or(camera.verticalFov);

    const glm::dvec3 forward = glm::dvec3(camera.target) - glm::dvec3(camera.eye);
    const glm::dvec3 right = glm::cross(forward, glm::dvec3(camera.up));
    if (forward == glm::dvec3(0.0)) throw InputError("camera: eye and target are the same point");
    if (right == glm::dvec3(0.0)) throw InputError("camera: it looks along its up direction");
    return camera;
}

} // namespace dirt
