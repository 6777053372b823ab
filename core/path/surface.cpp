#include "core/path/surface.h"

#include "shaders/shared/sampling.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace dirt {

namespace {

/// Normal of a triangle with an area. In double, since in float a sliver's would be noise: edges
/// and products lose next to nothing there.
glm::vec3 triangleNormal(const Triangle& triangle) {
    const glm::dvec3 a(triangle.a);
    const glm::dvec3 n = glm::cross(glm::dvec3(triangle.b) - a, glm::dvec3(triangle.c) - a);
    const double largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    if (!(largest > 0.0)) return {0.0f, 0.0f, 1.0f};
    return unitVector(glm::vec3(n / largest));
}

template <typename Vector>
Vector interpolate(const std::vector<Vector>& values, const Corners& corners,
                   const SurfacePoint& at) {
    return values[corners[0]] * (1.0f - at.u - at.v) + values[corners[1]] * at.u +
           values[corners[2]] * at.v;
}

bool present(const Corners& corners) {
    return corners[0] != kNoIndex && corners[1] != kNoIndex && corners[2] != kNoIndex;
}

glm::vec3 facing(glm::vec3 normal, glm::vec3 towards) {
    return dotProduct(normal, towards) < 0.0f ? -normal : normal;
}

glm::vec3 shadingNormal(const Scene& scene, const GridFrame& frame, const SurfacePoint& point) {
    const glm::vec3 geometric = point.geometricNormal;
    if (scene.mesh.normals.empty()) return geometric;
    const Corners& corners = scene.mesh.normalIndices[point.primitive];
    if (!present(corners)) return geometric;
    const glm::vec3 n = frame.directionToGrid(interpolate(scene.mesh.normals, corners, point));
    // Unit normals cancel only where they are opposite; NaN fails the comparison as well.
    if (!(dotProduct(n, n) > 1e-12f)) return geometric;
    return facing(unitVector(n), geometric);
}

glm::vec3 diffuseReflectance(const Scene& scene, const Material& material,
                             const SurfacePoint& point) {
    if (material.diffuseMap == kNoTexture || scene.mesh.texcoords.empty()) return material.diffuse;
    const Corners& corners = scene.mesh.texcoordIndices[point.primitive];
    if (!present(corners)) return material.diffuse;
    return scene.textures[material.diffuseMap].sample(
        interpolate(scene.mesh.texcoords, corners, point));
}

} // namespace

SurfacePoint fetchSurface(const Scene& scene, const FrameGeometry& geometry, glm::vec3 direction,
                          uint32_t primitive, float u, float v) {
    const Triangle& triangle = geometry.triangles[primitive];
    const Material& material = scene.materials[scene.mesh.materials[primitive]];

    SurfacePoint point;
    point.primitive = primitive;
    point.u = u;
    point.v = v;
    point.position = triangle.a * (1.0f - u - v) + triangle.b * u + triangle.c * v;
    point.geometricNormal = facing(triangleNormal(triangle), -direction);
    point.shadingNormal = shadingNormal(scene, geometry.frame, point);
    point.diffuse = diffuseReflectance(scene, material, point);
    point.emission = material.emission;
    return point;
}

} // namespace dirt
