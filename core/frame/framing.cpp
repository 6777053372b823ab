#include "core/frame/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

namespace dirt {

namespace {

constexpr double kSafeArea = 0.9; ///< of width and height

/// How far points reach beyond one side of the picture: the largest side - slope * depth. An eye
/// has them in view if its own value is no less.
struct Reach {
    double low = std::numeric_limits<double>::lowest();  ///< beyond the side of -slope
    double high = std::numeric_limits<double>::lowest(); ///< of +slope

    void add(double side, double depth, double slope) {
        low = std::max(low, -side - slope * depth);
        high = std::max(high, side - slope * depth);
    }
    /// Where the two sides meet.
    double middle() const { return 0.5 * (high - low); }
    /// The largest depth of an eye at \p side that has all in view.
    double depthAt(double side, double slope) const {
        return std::min(side - high, -side - low) / slope;
    }
};

} // namespace

Framing::Framing(glm::dvec3 direction, glm::vec3 up, float verticalFov, float aspect) {
    Camera camera;
    camera.target = glm::vec3(glm::normalize(direction));
    camera.up = up;
    const CameraBasis basis = cameraBasis(camera);
    right = basis.right;
    down = basis.down;
    forward = basis.forward;
    tall = std::tan(verticalFov * std::numbers::pi / 360.0);
    wide = tall * aspect;
}

bool Framing::contains(glm::dvec3 point, glm::dvec3 eye) const {
    const glm::dvec3 way = point - eye;
    const double depth = glm::dot(way, forward);
    return depth > 0.0 && std::abs(glm::dot(way, right)) <= wide * depth &&
           std::abs(glm::dot(way, down)) <= tall * depth;
}

glm::dvec3 Framing::eyeFor(std::span<const glm::dvec3> points,
                           std::optional<glm::dvec3> target) const {
    const double slopeX = kSafeArea * wide, slopeY = kSafeArea * tall;
    Reach reachX, reachY;
    double nearest = std::numeric_limits<double>::max();
    for (const glm::dvec3& p : points) {
        const double depth = glm::dot(p, forward);
        reachX.add(glm::dot(p, right), depth, slopeX);
        reachY.add(glm::dot(p, down), depth, slopeY);
        nearest = std::min(nearest, depth);
    }
    const double x = target ? glm::dot(*target, right) : reachX.middle();
    const double y = target ? glm::dot(*target, down) : reachY.middle();
    double depth = std::min(reachX.depthAt(x, slopeX), reachY.depthAt(y, slopeY));
    if (target) depth = std::min(depth, glm::dot(*target, forward));
    if (depth >= nearest) depth = nearest - 1.0;
    return x * right + y * down + depth * forward;
}

} // namespace dirt
