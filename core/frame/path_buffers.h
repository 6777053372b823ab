#pragma once

#include "core/path/surface.h"
#include "core/trace/ray.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

/// The state of all paths of one sample, one per image pixel. What is needed per pixel is indexed
/// by pixel; what is needed per ray by the position in the list of alive paths.
struct PathBuffers {
    std::vector<glm::vec3> radiance;   ///< per pixel: what the sample has gathered
    std::vector<glm::vec3> throughput; ///< per pixel: weight of what its ray finds

    /// Alive paths of the current event, in increasing order of pixel.
    std::vector<uint32_t> pixels; ///< owner
    std::vector<Ray> rays;
    std::vector<Hit> hits;             ///< hit buffer
    std::vector<SurfacePoint> points;  ///< shading buffer: G[k] of this event's hit
    std::vector<glm::vec3> directions; ///< of the next event's rays

    /// Shadow rays of the current event.
    std::vector<uint32_t> shadowPaths; ///< index of the alive path
    std::vector<Ray> shadowRays;       ///< from the point to the light at t = 1
    std::vector<float> shadowMaxT;
    std::vector<uint8_t> occluded;
    std::vector<glm::vec3> direct; ///< per alive path: radiance if the light is not occluded

    /// Room for all pixels of an image.
    void resize(size_t pixelCount);

    /// Bytes held.
    size_t bytes() const;
};

} // namespace dirt
