#include "core/grid/geometry.h"

#include "core/base/denormals.h"
#include "core/base/error.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace dirt {
namespace {

/// World to grid frame before the scale: × and + in a fixed order (G7).
glm::vec3 unscaled(const GridFrame& frame, glm::vec3 world) {
    const glm::vec3 p = world - frame.eye;
    return frame.directionToGrid(p);
}

/// An infinity or NaN where there is one.
float largestCoordinate(const Mesh& mesh, const GridFrame& frame) {
    float largest = 0.0f;
    for (const Corners& corners : mesh.triangles)
        for (uint32_t corner : corners) {
            const glm::vec3 p = unscaled(frame, mesh.positions[corner]);
            for (int i = 0; i < 3; ++i) {
                if (!std::isfinite(p[i])) return p[i];
                largest = std::max(largest, std::fabs(p[i]));
            }
        }
    return largest;
}

} // namespace

glm::vec3 GridFrame::directionToGrid(glm::vec3 p) const {
    if (mode == ViewMode::full) return p;
    return {(right.x * p.x + right.y * p.y) + right.z * p.z,
            (down.x * p.x + down.y * p.y) + down.z * p.z,
            (forward.x * p.x + forward.y * p.y) + forward.z * p.z};
}

glm::vec3 GridFrame::toGrid(glm::vec3 world) const {
    const glm::vec3 p = unscaled(*this, world);
    return flushed(p * scale);
}

CameraBasis cameraBasis(const Camera& camera) {
    glm::dvec3 forward = glm::dvec3(camera.target) - glm::dvec3(camera.eye);
    const double distance = glm::length(forward);
    forward = distance > 0.0 ? forward / distance : glm::dvec3(0, 0, -1);
    glm::dvec3 right = glm::cross(forward, glm::dvec3(camera.up));
    // Looking along the up vector: any other one will do.
    if (glm::length(right) < 1e-9 * glm::length(glm::dvec3(camera.up)) || right == glm::dvec3(0))
        right = glm::cross(forward,
                           std::fabs(forward.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1));
    right = glm::normalize(right);
    const glm::dvec3 down = glm::cross(forward, right);
    return {glm::vec3(right), glm::vec3(down), glm::vec3(forward)};
}

GridFrame makeUnscaledFrame(const Camera& camera, ViewMode mode) {
    GridFrame frame;
    frame.eye = camera.eye;
    frame.mode = mode;
    if (mode == ViewMode::single) {
        const CameraBasis basis = cameraBasis(camera);
        frame.right = basis.right;
        frame.down = basis.down;
        frame.forward = basis.forward;
    }
    return frame;
}

float scaleFor(float largest) {
    if (!std::isfinite(largest))
        throw InputError("the scene does not fit into float32 as seen from the eye");
    if (largest == 0.0f) return 1.0f;
    int exponent = 0;
    std::frexp(largest, &exponent); // largest = m 2^exponent, m in [0.5, 1)
    return std::ldexp(1.0f, std::clamp(1 - exponent, -126, 126));
}

FrameGeometry makeFrameGeometry(const Mesh& mesh, const Camera& camera, ViewMode mode) {
    FrameGeometry geometry;
    GridFrame& frame = geometry.frame;
    frame = makeUnscaledFrame(camera, mode);
    frame.scale = scaleFor(largestCoordinate(mesh, frame));

    geometry.triangles.reserve(mesh.triangles.size());
    for (const Corners& corners : mesh.triangles)
        geometry.triangles.push_back({frame.toGrid(mesh.positions[corners[0]]),
                                      frame.toGrid(mesh.positions[corners[1]]),
                                      frame.toGrid(mesh.positions[corners[2]])});
    return geometry;
}

} // namespace dirt
