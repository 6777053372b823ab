#include "core/frame/viewpoints.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>

namespace dirt {

namespace {

constexpr int kHeadings = 12; ///< directions tried at one place
constexpr int kSpots = 4;     ///< places along each horizontal axis, besides the middle

/// Corners looked at for the quantiles: beyond this many they hardly move.
constexpr size_t kQuantileCorners = 30'000;

/// The values in the middle of each of kSpots equal parts of the sorted \p values.
std::vector<double> quantiles(std::vector<double> values) {
    std::vector<double> result;
    for (size_t i = 0; i < kSpots && !values.empty(); ++i) {
        const size_t rank = values.size() * (2 * i + 1) / (2 * kSpots);
        const auto nth = values.begin() + (std::ptrdiff_t) rank;
        std::nth_element(values.begin(), nth, values.end());
        result.push_back(*nth);
    }
    return result;
}

/// Directions all around, \p slope downwards.
std::vector<glm::dvec3> headings(const SceneExtent& extent, double slope) {
    std::vector<glm::dvec3> result;
    for (int i = 0; i < kHeadings; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / kHeadings;
        result.push_back(glm::normalize(std::cos(angle) * extent.forward +
                                        std::sin(angle) * extent.right - slope * extent.up));
    }
    return result;
}

/// How far before the box's centre an eye must be to have all corners of the box in view.
double distanceToFit(const SceneExtent& extent, glm::dvec3 direction, const CameraHints& hints) {
    const double tall = std::tan(hints.verticalFov * std::numbers::pi / 360.0);
    const double wide = tall * hints.aspect;
    const glm::dvec3 right = glm::normalize(glm::cross(direction, extent.up));
    const glm::dvec3 up = glm::cross(right, direction);
    double distance = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 sign{corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5,
                              corner & 4 ? 0.5 : -0.5};
        const glm::dvec3 p = extent.world(sign * (extent.high - extent.low));
        const double needed =
            std::max(std::abs(glm::dot(p, right)) / wide, std::abs(glm::dot(p, up)) / tall);
        distance = std::max(distance, needed - glm::dot(p, direction));
    }
    if (distance > 0.0) return distance;
    return std::max(1.0, glm::length(extent.centre())); // the box is a point
}

} // namespace

SceneExtent extentOf(const Mesh& mesh, glm::vec3 upward) {
    SceneExtent extent;
    const glm::dvec3 up = glm::normalize(glm::dvec3(upward));
    // The first axis that is not near up, so that Y up has X to the right.
    const glm::dvec3 axis = std::abs(up.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    extent.up = up;
    extent.forward = glm::normalize(glm::cross(up, axis));
    extent.right = glm::cross(extent.forward, up);

    std::vector<double> alongRight, alongForward;
    const size_t stride = 1 + 3 * mesh.triangles.size() / kQuantileCorners;
    size_t corner = 0;
    for (const Corners& corners : mesh.triangles)
        for (uint32_t index : corners) {
            const glm::dvec3 p = mesh.positions[index];
            const glm::dvec3 q{glm::dot(p, extent.right), glm::dot(p, extent.up),
                               glm::dot(p, extent.forward)};
            extent.low = glm::min(extent.low, q);
            extent.high = glm::max(extent.high, q);
            if (corner++ % stride != 0) continue;
            alongRight.push_back(q.x);
            alongForward.push_back(q.z);
        }
    extent.spotsRight = quantiles(std::move(alongRight));
    extent.spotsRight.push_back(extent.centre().x);
    extent.spotsForward = quantiles(std::move(alongForward));
    extent.spotsForward.push_back(extent.centre().z);
    return extent;
}

std::vector<Viewpoint> viewpoints(const SceneExtent& extent, const CameraHints& hints) {
    std::vector<Viewpoint> places;
    const auto add = [&](glm::dvec3 eye, std::vector<glm::dvec3> directions, bool inside) {
        if (hints.target) {
            const glm::dvec3 way = glm::dvec3(*hints.target) - eye;
            if (way == glm::dvec3(0.0)) return;
            directions = {glm::normalize(way)};
            inside = false; // one direction says nothing about the place
        }
        places.push_back({eye, std::move(directions), inside});
    };
    if (hints.eye) {
        add(*hints.eye, headings(extent, 0.08), false);
        return places;
    }
    for (double x : extent.spotsRight)
        for (double z : extent.spotsForward)
            for (double y : {0.2, 0.45}) {
                const double height = extent.low.y + y * (extent.high.y - extent.low.y);
                add(extent.world({x, height, z}), headings(extent, 0.08), true);
            }
    for (double slope : {0.35, 0.08})
        for (glm::dvec3 direction : headings(extent, slope)) {
            const double distance = distanceToFit(extent, direction, hints);
            add(extent.world(extent.centre()) - distance * direction, {direction}, false);
        }
    return places;
}

} // namespace dirt
