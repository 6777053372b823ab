#include "core/explain/explained_ray.h"

#include <cstdio>

namespace dirt {

std::vector<ExplainedRay> raysOf(const PathAccount& account, const EventAccount& event) {
    std::vector<ExplainedRay> rays;
    const auto trail = [&](const Ray& ray) -> std::optional<RayTrail> {
        if (!account.grid) return {};
        return closestTrail(*account.grid, account.geometry, ray);
    };
    if (event.ray.direction != glm::vec3(0.0f)) {
        const Ray ray{event.ray.origin, event.ray.direction, event.ray.skip};
        rays.push_back({event.event == 0 ? "primary" : "indirect", ray, {}, trail(ray)});
    }
    if (!event.shadowRay) return rays;
    const auto& [ray, maxT] = *event.shadowRay;
    rays.push_back({"shadow", ray, maxT, {}});
    if (account.grid) rays.back().trail = anyTrail(*account.grid, account.geometry, ray, maxT);
    return rays;
}

std::string disagreement(const EventAccount& event, const ExplainedRay& ray) {
    if (!ray.trail) return "";
    if (ray.maxT) {
        if (ray.trail->blocked == !event.lit) return "";
        return std::string("the backend says that the light ") +
               (event.lit ? "reaches" : "does not reach") + " the point";
    }
    const Hit& hit = ray.trail->hit;
    if (event.rasterized) {
        if (event.point.primitive == hit.primitive) return "";
        return "rasterization sees primitive " + std::to_string(event.point.primitive) +
               ", the ray hits " + std::to_string(hit.primitive);
    }
    if (event.hit.primitive == hit.primitive && (!hit.found() || event.hit.t == hit.t)) return "";
    char text[160];
    std::snprintf(text, sizeof text, "the backend hits %u at t %.9g, the definition %u at %.9g",
                  event.hit.primitive, (double) event.hit.t, hit.primitive, (double) hit.t);
    return text;
}

} // namespace dirt
