#include "app/cli/image_metadata.h"

#include <cstdio>

namespace dirt {

namespace {

/// As the options that place it.
std::string textOf(const Camera& camera) {
    char text[256];
    const glm::vec3 eye = camera.eye, target = camera.target, up = camera.up;
    std::snprintf(text, sizeof text,
                  "--eye=%.9g,%.9g,%.9g --target=%.9g,%.9g,%.9g --up=%.9g,%.9g,%.9g --fov=%.9g",
                  eye.x, eye.y, eye.z, target.x, target.y, target.z, up.x, up.y, up.z,
                  camera.verticalFov);
    return text;
}

} // namespace

ImageMetadata metadataOf(const Input& input, const RenderSettings& settings, int samples) {
    const bool full = settings.grid.mode == ViewMode::full;
    ImageMetadata metadata = {{"dirt:scene", input.scene.name},
                              {"dirt:camera", textOf(input.scene.camera)},
                              {"dirt:samples", std::to_string(samples)},
                              {"dirt:bounces", std::to_string(settings.bounces)},
                              {"dirt:seed", std::to_string(settings.seed)},
                              {"dirt:view", full ? "full" : "single"}};
    if (!input.scene.animation.empty())
        metadata.emplace_back("dirt:frame", std::to_string(input.frame));
    return metadata;
}

} // namespace dirt
