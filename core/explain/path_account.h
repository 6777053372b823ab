#pragma once

#include "core/frame/backend.h"
#include "core/frame/passes.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

/// What one path event did for a pixel, as the backend's buffers have it. Radiance is what it adds
/// to the sample: the surface's or the background's, weighed by all that the path has lost before.
struct EventAccount {
    int event = 0;
    bool rasterized = false; ///< no ray was traced: DirectVisibility found the point
    PathRay ray;             ///< in the grid frame; of direction zero where the path has ended
    Hit hit;                 ///< of Trace
    SurfacePoint point;      ///< G[k+1]; not found where nothing was hit
    std::optional<ShadowRay> shadowRay;
    bool lit = false;          ///< nothing is between the point and the light
    glm::vec3 emitted{0.0f};   ///< by the surface; or the background
    glm::vec3 reflected{0.0f}; ///< of the light: the rest of what is added
    glm::vec3 added{0.0f};     ///< by the event's Shade
    glm::vec3 gathered{0.0f};  ///< by the sample, after it
};

/// One sample of one pixel.
struct PathAccount {
    size_t pixel = 0; ///< row-major
    uint32_t sample = 0;
    std::vector<EventAccount> events; ///< until the path ends
    glm::vec3 radiance{0.0f};         ///< of the sample: the sum of what they added
    FrameGeometry geometry;
    std::optional<Grid> grid; ///< where the backend's structure is one
};

/// Renders one sample of the whole image with \p backend and takes down what happened to one pixel,
/// until its path ends. \p scene must outlive the account, whose geometry may ask it for cut-outs.
PathAccount accountOf(const Scene& scene, RenderSettings settings, Backend& backend, size_t pixel,
                      uint32_t sample, const std::function<bool()>& stop = {});

} // namespace dirt
