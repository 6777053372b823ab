#include "app/cli/image_metadata.h"

#include "app/cli/again.h"

#include <cstdio>

namespace dirt {

namespace {

/// As the options that place it.
std::string textOf(const Scene& scene) {
    char text[128];
    const glm::vec3 up = scene.camera.up;
    std::snprintf(text, sizeof text, " --up=%.9g,%.9g,%.9g --fov=%.9g", up.x, up.y, up.z,
                  scene.camera.verticalFov);
    return "--eye=" + pointOption(scene.origin, scene.camera.eye) +
           " --target=" + pointOption(scene.origin, scene.camera.target) + text;
}

} // namespace

ImageMetadata metadataOf(const Input& input, const RenderSettings& settings, int samples) {
    const bool full = settings.grid.mode == ViewMode::full;
    ImageMetadata metadata = {{"dirt:scene", input.scene.name},
                              {"dirt:camera", textOf(input.scene)},
                              {"dirt:samples", std::to_string(samples)},
                              {"dirt:bounces", std::to_string(settings.bounces)},
                              {"dirt:seed", std::to_string(settings.seed)},
                              {"dirt:view", full ? "full" : "single"}};
    if (!input.scene.animation.empty())
        metadata.emplace_back("dirt:frame", std::to_string(input.frame));
    return metadata;
}

} // namespace dirt
