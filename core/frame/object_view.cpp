#include "core/frame/object_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <glm/geometric.hpp>

namespace dirt {

namespace {

constexpr std::array kTurns{0, 1, -1, 2, -2, 3, -3, 4};        ///< eighths of a circle
constexpr std::array kRises{kSlightly, 1.0, -kSlightly, -1.0}; ///< for each step along

/// What is shown of a model.
struct Shown {
    double area = 0.0;    ///< in the picture
    size_t materials = 0; ///< at least partly

    bool isHalfOf(const Shown& most) const {
        return area >= 0.5 * most.area && 2 * materials >= most.materials;
    }
};

/// Of its outside alone, or of both sides, where the outside is seen at all.
Shown shownIn(const SurfaceView& view, glm::dvec3 direction, Side outside, bool bothSides,
              std::span<const SurfaceSample> samples) {
    double areas[2] = {0.0, 0.0}; // inside, outside
    std::set<uint32_t> materials[2];
    for (size_t s = 0; s < samples.size(); ++s) {
        if (view[s] == Side::hidden) continue;
        const size_t side = view[s] == outside ? 1 : 0;
        areas[side] += std::abs(glm::dot(samples[s].normal, direction));
        materials[side].insert(samples[s].material);
    }
    if (!bothSides || areas[1] == 0.0) return {areas[1], materials[1].size()};
    materials[1].merge(materials[0]);
    return {areas[0] + areas[1], materials[1].size()};
}

/// What any of \p views shows at most.
Shown mostOf(std::span<const Shown> views) {
    Shown most;
    for (const Shown& view : views) {
        most.area = std::max(most.area, view.area);
        most.materials = std::max(most.materials, view.materials);
    }
    return most;
}

/// Which of \p views shows most.
size_t bestOf(std::span<const Shown> views) {
    const auto worth = [](const Shown& view) { return view.area * (double) view.materials; };
    const auto best =
        std::max_element(views.begin(), views.end(),
                         [&](const Shown& a, const Shown& b) { return worth(a) < worth(b); });
    return (size_t) (best - views.begin());
}

/// The first of \p views that shows half of what any of them shows; else that which shows most.
size_t firstOf(std::span<const Shown> views) {
    const Shown most = mostOf(views);
    const auto found = std::find_if(views.begin(), views.end(),
                                    [&](const Shown& view) { return view.isHalfOf(most); });
    return found != views.end() ? (size_t) (found - views.begin()) : bestOf(views);
}

} // namespace

Horizon::Horizon(glm::vec3 upward) {
    up = glm::normalize(glm::dvec3(upward));
    // The first axis that is not near up.
    const glm::dvec3 axis = std::abs(up.x) < 0.8 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    forward = glm::normalize(glm::cross(up, axis));
    right = glm::cross(forward, up);
}

glm::dvec3 Horizon::heading(double turn) const {
    return std::cos(turn) * forward + std::sin(turn) * right;
}

glm::dvec3 objectDirection(const Horizon& horizon, const ModelKind& kind,
                           std::span<const SurfaceSample> samples, Tracer& tracer) {
    const Side outside = kind.insideOut ? Side::back : Side::front;
    const auto shown = [&](const std::vector<glm::dvec3>& backwards, bool bothSides) {
        const std::vector<SurfaceView> views = viewsFrom(backwards, samples, tracer);
        std::vector<Shown> result;
        for (size_t v = 0; v < views.size(); ++v)
            result.push_back(shownIn(views[v], backwards[v], outside, bothSides, samples));
        return result;
    };
    std::vector<glm::dvec3> level, risen; // towards the eye
    for (int turn : kTurns) level.push_back(-horizon.heading(turn * std::numbers::pi / 4.0));
    const std::vector<Shown> around = shown(level, false);
    const Shown most = mostOf(around);
    const bool isFront = around[0].isHalfOf(most) && 2 * around[0].materials != most.materials;
    const glm::dvec3 side = level[isFront ? 0 : bestOf(around)];
    for (double rise : kRises) risen.push_back(glm::normalize(rise * horizon.up + side));
    const size_t height = firstOf(shown(risen, false));
    if (kRises[height] > 0.0) return -risen[height];
    const size_t ofBoth = firstOf(shown(risen, true));
    return -risen[kRises[ofBoth] > 0.0 ? ofBoth : height];
}

} // namespace dirt
