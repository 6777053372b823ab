#include "core/path/surface.h"

#include "shaders/shared/surface.h"

#include <vector>

namespace dirt {

namespace {

bool present(const Corners& corners) {
    return corners[0] != kNoIndex && corners[1] != kNoIndex && corners[2] != kNoIndex;
}

template <typename Vector>
Vector interpolateAt(const SurfacePoint& point, const std::vector<Vector>& values,
                     const Corners& corners) {
    return interpolate(values[corners[0]], values[corners[1]], values[corners[2]], point.u,
                       point.v);
}

glm::vec3 shadingNormal(const Scene& scene, const GridFrame& frame, const SurfacePoint& point) {
    if (scene.mesh.normals.empty()) return point.geometricNormal;
    const Corners& corners = scene.mesh.normalIndices[point.primitive];
    if (!present(corners)) return point.geometricNormal;
    const glm::vec3 normal = interpolateAt(point, scene.mesh.normals, corners);
    return shadingNormalFrom(frame.directionToGrid(normal), point.geometricNormal);
}

glm::vec3 diffuseReflectance(const Scene& scene, const Material& material,
                             const SurfacePoint& point) {
    if (material.diffuseMap == kNoTexture || scene.mesh.texcoords.empty()) return material.diffuse;
    const Corners& corners = scene.mesh.texcoordIndices[point.primitive];
    if (!present(corners)) return material.diffuse;
    return scene.textures[material.diffuseMap].sample(
        interpolateAt(point, scene.mesh.texcoords, corners));
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
    point.position = interpolate(triangle.a, triangle.b, triangle.c, u, v);
    point.geometricNormal = facing(triangleNormal(triangle.a, triangle.b, triangle.c), -direction);
    point.shadingNormal = shadingNormal(scene, geometry.frame, point);
    point.diffuse = diffuseReflectance(scene, material, point);
    point.emission = material.emission;
    return point;
}

} // namespace dirt
