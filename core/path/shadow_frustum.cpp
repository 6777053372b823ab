#include "core/path/shadow_frustum.h"

#include "core/base/error.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numbers>
#include <string>

#include <glm/geometric.hpp>

namespace dirt {
namespace {

/// Full angle, degrees. At this one texels of the rim are 130 times as dense as those of the
/// middle, and beyond it the frustum has no end.
constexpr float kWidest = 170.0f;

/// The largest depth of a vertex along the light's axis, world space.
double farthestVertex(const Spotlight& light, const Mesh& mesh) {
    const glm::dvec3 position(light.position);
    const glm::dvec3 axis = glm::normalize(glm::dvec3(light.target) - position);
    double farthest = 0.0;
    for (const glm::vec3& p : mesh.positions)
        farthest = std::max(farthest, glm::dot(glm::dvec3(p) - position, axis));
    return farthest;
}

} // namespace

void checkShadowMap(const Spotlight& light) {
    if (light.aperture <= kWidest) return;
    throw InputError("a shadow map holds a light of 170 degrees at most, and this one's aperture "
                     "is " +
                     std::to_string((int) light.aperture) + " (--visibility traced holds any)");
}

ShadowMap makeShadowMap(const Scene& scene, const GridFrame& frame) {
    const Spotlight& light = scene.lights.front();
    checkShadowMap(light);
    ShadowMap map;
    map.resolution = (uint) light.resolution;
    map.extent = (float) std::tan(light.aperture * (std::numbers::pi / 360.0));
    map.step = 2.0f * map.extent / (float) light.resolution;
    const bool ends = light.farRange > 0.0f;
    const double end = ends ? light.farRange : farthestVertex(light, scene.mesh);
    const double range = std::max(end - light.nearRange, 0.0);
    map.nearest = light.nearRange * frame.scale;
    map.farthest = ends ? light.farRange * frame.scale : FLT_MAX;
    map.bias = (float) (light.constantBias * range * frame.scale);
    map.softness = light.softShadowSize * frame.scale;
    return map;
}

} // namespace dirt
