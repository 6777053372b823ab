// How a surface point reflects where a scene has gloss; without it, reflection.h suffices.
#ifndef DIRT_SHARED_GLOSSY_REFLECTION_H
#define DIRT_SHARED_GLOSSY_REFLECTION_H

#include "shaders/shared/bsdf.h"
#include "shaders/shared/reflection.h"
#include "shaders/shared/surface.h"

DIRT_SHARED_BEGIN

/// The least cosine between the normal of the microfacets and the direction to the viewer.
const float kLeastCosine = 0.0009765625f; // 2^-10

/// Direction from a point of the grid frame to the eye, which is its origin.
DIRT_FUNCTION vec3 directionToEye(vec3 position) {
    return directionOf(-position);
}

DIRT_FUNCTION Lobes lobesOf(SurfacePoint point, uint model) {
    DIRT_PRECISE float reflectance = float(point.gloss & 0xffffu) / 65535.0f;
    DIRT_PRECISE float metallic = float(point.gloss >> 16u) / 65535.0f;
    return makeLobes(point.diffuse, reflectance, metallic, point.roughness, model);
}

/// The shading normal, tilted where an interpolated one turns away from the viewer, \p v, who sees
/// the surface nevertheless.
DIRT_FUNCTION vec3 tiltedTowards(vec3 v, SurfacePoint point) {
    float cosine = dotProduct(point.shadingNormal, v);
    if (cosine >= kLeastCosine) return point.shadingNormal;
    DIRT_PRECISE vec3 tilted = point.shadingNormal + v * (kLeastCosine - cosine);
    // Both lie on one side of the surface, so the sum vanishes at its horizon only.
    if (!(dotProduct(tilted, tilted) > 1e-12f)) return point.geometricNormal;
    return unitVector(tilted);
}

/// The same, bent where it would mirror \p v into the surface: what is mirrored is lifted to the
/// height of kLeastCosine twice, and the normal stands half way to it. Its cosine to \p v is then
/// the half of the length of their sum, at least half of the sum of their heights, and so
/// kLeastCosine but for rounding. A normal of the triangle itself mirrors to where the viewer is,
/// and stays.
DIRT_FUNCTION vec3 normalSeenFrom(SurfacePoint point, vec3 v) {
    vec3 normal = tiltedTowards(v, point);
    DIRT_PRECISE vec3 mirrored = normal * (2.0f * dotProduct(normal, v)) - v;
    float height = dotProduct(point.geometricNormal, mirrored);
    float viewer = dotProduct(point.geometricNormal, v);
    const float least = 2.0f * kLeastCosine;
    if (height >= least || height >= 0.5f * viewer) return normal;
    DIRT_PRECISE vec3 lifted = mirrored + point.geometricNormal * (least - height);
    DIRT_PRECISE vec3 both = v + unitVector(lifted);
    return unitVector(both);
}

/// A local frame and the direction to the viewer in it.
struct LocalFrame {
    vec3 tangent;
    vec3 bitangent;
    vec3 normal;
    vec3 v;
};

DIRT_FUNCTION LocalFrame localFrame(SurfacePoint point, vec3 v) {
    LocalFrame local;
    local.normal = normalSeenFrom(point, v);
    orthonormalBasis(local.normal, local.tangent, local.bitangent);
    local.v = vec3(dotProduct(local.tangent, v), dotProduct(local.bitangent, v),
                   dotProduct(local.normal, v));
    return local;
}

/// Radiance that \p point reflects of an unoccluded light towards \p v, of unit length.
DIRT_FUNCTION vec3 reflectedRadiance(SurfacePoint point, uint model, vec3 v, LightSample light) {
    if (!isGlossy(point)) return reflectedRadiance(point, light);
    LocalFrame local = localFrame(point, v);
    vec3 l = vec3(dotProduct(local.tangent, light.direction),
                  dotProduct(local.bitangent, light.direction),
                  dotProduct(local.normal, light.direction));
    bool inFront = dotProduct(point.geometricNormal, light.direction) > 0.0f && l.z > 0.0f;
    if (!inFront || !(local.v.z > 0.0f)) return vec3(0.0f);
    DIRT_PRECISE vec3 radiance =
        bsdfTimesCosine(lobesOf(point, model), local.v, l) * light.irradiance;
    return radiance;
}

/// How a path that is seen from \p v, of unit length, goes on. Numbers as in sampleBsdf.
DIRT_FUNCTION Scattering scatter(SurfacePoint point, uint model, vec3 v, float lobe, float u1,
                                 float u2, float u3) {
    if (!isGlossy(point)) return scatter(point, u1, u2);
    LocalFrame local = localFrame(point, v);
    if (!(local.v.z > 0.0f)) return noScattering();
    Scattering result = sampleBsdf(lobesOf(point, model), local.v, lobe, u1, u2, u3);
    DIRT_PRECISE vec3 direction = local.tangent * result.direction.x +
                                  local.bitangent * result.direction.y +
                                  local.normal * result.direction.z;
    if (!(dotProduct(point.geometricNormal, direction) > 0.0f)) return noScattering();
    result.direction = direction;
    return result;
}

DIRT_SHARED_END

#endif
