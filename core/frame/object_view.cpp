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

/// What is shown of the outside of a model.
struct Shown {
    double area = 0.0;    ///< in the picture
    size_t materials = 0; ///< at least partly

    bool isEnough(const Shown& most) const {
        return area >= 0.5 * most.area && 2 * materials >= most.materials;
    }
};

Shown shownIn(const SurfaceView& view, glm::dvec3 direction, Side outside,
              std::span<const SurfaceSample> samples) {
    Shown shown;
    std::set<uint32_t> materials;
    for (size_t s = 0; s < samples.size(); ++s) {
        if (view[s] != outside) continue;
        shown.area += std::abs(glm::dot(samples[s].normal, direction));
        materials.insert(samples[s].material);
    }
    shown.materials = materials.size();
    return shown;
}

/// The first of \p views that shows enough of what any of them shows; else, or if it has to be
/// the first, that which shows most.
size_t choose(std::span<const Shown> views, bool onlyFirst) {
    Shown most;
    for (const Shown& view : views) {
        most.area = std::max(most.area, view.area);
        most.materials = std::max(most.materials, view.materials);
    }
    const size_t eligible = onlyFirst ? 1 : views.size();
    for (size_t i = 0; i < eligible; ++i)
        if (views[i].isEnough(most)) return i;
    const auto worth = [](const Shown& view) { return view.area * (double) view.materials; };
    const auto best =
        std::max_element(views.begin(), views.end(),
                         [&](const Shown& a, const Shown& b) { return worth(a) < worth(b); });
    return (size_t) (best - views.begin());
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
    const auto choice = [&](const std::vector<glm::dvec3>& backwards, bool onlyFirst) {
        const std::vector<SurfaceView> views = viewsFrom(backwards, samples, tracer);
        std::vector<Shown> shown;
        for (size_t v = 0; v < views.size(); ++v)
            shown.push_back(shownIn(views[v], backwards[v], outside, samples));
        return backwards[choose(shown, onlyFirst)]; // towards the eye
    };
    std::vector<glm::dvec3> level, risen;
    for (int turn : kTurns) level.push_back(-horizon.heading(turn * std::numbers::pi / 4.0));
    const glm::dvec3 side = choice(level, true);
    for (double rise : kRises) risen.push_back(glm::normalize(rise * horizon.up + side));
    return -choice(risen, false);
}

} // namespace dirt
