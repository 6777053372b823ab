#include "core/path/fetch_surface.h"

#include "core/scene/attributes.h"
#include "shaders/shared/glossy_reflection.h"
#include "shaders/shared/surface.h"

namespace dirt {

namespace {

/// \p normal, turned by the material's normal map or heights.
glm::vec3 turned(const Scene& scene, const Material& material, const Triangle& triangle,
                 uint32_t primitive, glm::vec2 texcoord, glm::vec3 normal) {
    const auto& texcoords = scene.mesh.texcoords;
    const Corners& corners = scene.mesh.texcoordIndices[primitive];
    const glm::vec2 a = texcoords[corners[0]];
    const glm::vec2 de = texcoords[corners[1]] - a, df = texcoords[corners[2]] - a;
    const glm::vec3 e = triangle.b - triangle.a, f = triangle.c - triangle.a;
    if (material.normalMap != kNoTexture) {
        const Texture& map = scene.textures[material.normalMap];
        const glm::vec3 local = normalOfTexel(map.sample(texcoord), material.normalScale);
        return mappedNormal(normal, e, f, map.sampling().imageDifference(de),
                            map.sampling().imageDifference(df), local);
    }
    const ScalarTexture& map = scene.scalarTextures[material.bumpMap];
    const glm::vec2 slopes = map.slopes(texcoord) * material.bumpScale;
    return bumpedNormal(normal, e, f, map.sampling().imageDifference(de),
                        map.sampling().imageDifference(df), slopes);
}

} // namespace

SurfacePoint fetchSurface(const Scene& scene, const FrameGeometry& geometry, glm::vec3 direction,
                          uint32_t primitive, float u, float v) {
    const Triangle& triangle = geometry.triangles[primitive];
    const Mesh& mesh = scene.mesh;
    const Material& material = scene.materials[mesh.materials[primitive]];

    SurfacePoint point;
    point.primitive = primitive;
    point.u = u;
    point.v = v;
    point.position = interpolate(triangle.a, triangle.b, triangle.c, u, v);
    const glm::vec3 outward = triangleNormal(triangle.a, triangle.b, triangle.c);
    point.geometricNormal = facing(outward, -direction);
    point.shadingNormal = point.geometricNormal;
    const bool smooth = !mesh.normals.empty() && isPresent(mesh.normalIndices[primitive]);
    glm::vec3 normal = outward;
    if (smooth) {
        normal = geometry.frame.directionToGrid(
            interpolateAt(mesh.normals, mesh.normalIndices[primitive], u, v));
        point.shadingNormal = shadingNormalFrom(normal, point.geometricNormal);
    }
    point.diffuse = material.diffuse;
    point.emission = material.emission;
    float reflectance = material.reflectance, roughness = material.roughness;
    float metallic = material.metallic;
    if (material.isTextured()) {
        if (const auto texcoord = texcoordAt(mesh, primitive, u, v)) {
            if (material.diffuseMap != kNoTexture)
                point.diffuse = scene.textures[material.diffuseMap].sample(*texcoord) *
                                material.diffuseMapFactor;
            if (material.emissionMap != kNoTexture)
                point.emission *= scene.textures[material.emissionMap].sample(*texcoord);
            if (material.reflectanceMap != kNoTexture)
                reflectance *= scene.scalarTextures[material.reflectanceMap].sample(*texcoord);
            if (material.roughnessMap != kNoTexture)
                roughness = mappedRoughness(
                    roughness, scene.scalarTextures[material.roughnessMap].sample(*texcoord));
            if (material.metallicMap != kNoTexture)
                metallic = mappedMetallic(
                    metallic, scene.scalarTextures[material.metallicMap].sample(*texcoord));
            if ((material.bumpMap & material.normalMap) != kNoTexture) {
                // They stand on the side of the surface's own normal, whichever is seen.
                const glm::vec3 base = shadingNormalFrom(normal, normal);
                normal = turned(scene, material, triangle, primitive, *texcoord, base);
                point.shadingNormal = shadingNormalFrom(normal, point.geometricNormal);
            }
        }
    }
    if (!mesh.colors.empty())
        point.diffuse *= interpolateAt(mesh.colors, mesh.triangles[primitive], u, v);
    point.diffuse = boundedReflectance(point.diffuse);
    point.emission = boundedEmission(point.emission);
    if (material.metallicMap != kNoTexture) reflectance = metalReflectance(reflectance, metallic);
    if (reflectance > 0.0f) {
        point.roughness = roughness;
        point.gloss = packGloss(reflectance < 1.0f ? reflectance : 1.0f, metallic);
    }
    return point;
}

} // namespace dirt
