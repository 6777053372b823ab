// What Fetch makes of a triangle's attributes.
#ifndef DIRT_SHARED_SURFACE_H
#define DIRT_SHARED_SURFACE_H

#include "shaders/shared/radiance.h"
#include "shaders/shared/sampling.h"

DIRT_SHARED_BEGIN

/// Attributes \p a, \p b and \p c of three vertices at the barycentric weights (\p u, \p v).
DIRT_FUNCTION vec3 interpolate(vec3 a, vec3 b, vec3 c, float u, float v) {
    DIRT_PRECISE vec3 value = a * (1.0f - u - v) + b * u + c * v;
    return value;
}
DIRT_FUNCTION vec2 interpolate(vec2 a, vec2 b, vec2 c, float u, float v) {
    DIRT_PRECISE vec2 value = a * (1.0f - u - v) + b * u + c * v;
    return value;
}

/// \p normal or its opposite, whichever lies on the side of \p towards.
DIRT_FUNCTION vec3 facing(vec3 normal, vec3 towards) {
    return dotProduct(normal, towards) < 0.0f ? -normal : normal;
}

#ifndef DIRT_NO_DOUBLES

/// Normal of a triangle with an area. In double, since in float a sliver's would be noise: edges
/// and products lose next to nothing there.
DIRT_FUNCTION vec3 triangleNormal(vec3 a, vec3 b, vec3 c) {
    DIRT_PRECISE dvec3 e = dvec3(b) - dvec3(a);
    DIRT_PRECISE dvec3 f = dvec3(c) - dvec3(a);
    DIRT_PRECISE dvec3 n =
        dvec3(e.y * f.z - f.y * e.z, e.z * f.x - f.z * e.x, e.x * f.y - f.x * e.y);
    double largest = abs(n.x);
    if (abs(n.y) > largest) largest = abs(n.y);
    if (abs(n.z) > largest) largest = abs(n.z);
    if (!(largest > double(0.0f))) return vec3(0.0f, 0.0f, 1.0f);
    DIRT_PRECISE dvec3 scaled = n / largest;
    return unitVector(vec3(scaled));
}

#endif

/// Normal for shading of an interpolated \p normal: on the side of the \p geometric one, which it
/// gives way to where it has no direction. Unit normals cancel only where they are opposite; NaN
/// fails the comparison as well.
DIRT_FUNCTION vec3 shadingNormalFrom(vec3 normal, vec3 geometric) {
    if (!(dotProduct(normal, normal) > 1e-12f)) return geometric;
    return facing(unitVector(normal), geometric);
}

/// \p v with unit length; zero where it is too short to have a direction.
DIRT_FUNCTION vec3 directionOf(vec3 v) {
    float largest = abs(v.x);
    if (abs(v.y) > largest) largest = abs(v.y);
    if (abs(v.z) > largest) largest = abs(v.z);
    if (!(largest > 1e-30f)) return vec3(0.0f);
    DIRT_PRECISE vec3 scaled = v / largest;
    return unitVector(scaled);
}

/// \p x of at most 2^20, of which steeper slopes cannot be told; a NaN for that as well. What is
/// beyond would leave the rest of a unit vector below normal floats, which not every device has.
DIRT_FUNCTION float boundedSlope(float x) {
    const float steepest = 1048576.0f;
    return x > -steepest ? (x < steepest ? x : steepest) : -steepest;
}

/// The unit vector \p normal of a triangle with edges \p e and \p f, turned as J. Blinn has it by
/// heights that grow by \p slopes along the texture's u and v, per length along the surface;
/// \p de and \p df are the texture coordinates' differences along the edges.
DIRT_FUNCTION vec3 bumpedNormal(vec3 normal, vec3 e, vec3 f, vec2 de, vec2 df, vec2 slopes) {
    DIRT_PRECISE float area = de.x * df.y - df.x * de.y;
    if (area == 0.0f) return normal;
    float side = area > 0.0f ? 1.0f : -1.0f;
    DIRT_PRECISE vec3 alongU = (e * df.y - f * de.y) * side;
    DIRT_PRECISE vec3 alongV = (f * de.x - e * df.x) * side;
    DIRT_PRECISE vec3 inPlaneU = alongU - normal * dotProduct(normal, alongU);
    DIRT_PRECISE vec3 inPlaneV = alongV - normal * dotProduct(normal, alongV);
    DIRT_PRECISE vec3 turned = normal - directionOf(inPlaneU) * boundedSlope(slopes.x) -
                               directionOf(inPlaneV) * boundedSlope(slopes.y);
    return directionOf(turned);
}

/// The normal that a normal map's \p texel stands for, along the image's u and v and out of the
/// surface; \p scale: Material::normalScale.
DIRT_FUNCTION vec3 normalOfTexel(vec3 texel, float scale) {
    DIRT_PRECISE vec3 decoded = 2.0f * texel - 1.0f;
    DIRT_PRECISE vec3 scaled = vec3(decoded.x * scale, decoded.y * scale, decoded.z);
    return vec3(boundedSlope(scaled.x), boundedSlope(scaled.y), boundedSlope(scaled.z));
}

/// The unit vector \p normal of a triangle as for bumpedNormal, replaced by \p local, which is in a
/// right-angled frame: along the texture's u as seen on the plane of \p normal, to its v's side,
/// and along \p normal. So mirrored textures, too, have their v run upwards.
DIRT_FUNCTION vec3 mappedNormal(vec3 normal, vec3 e, vec3 f, vec2 de, vec2 df, vec3 local) {
    DIRT_PRECISE float area = de.x * df.y - df.x * de.y;
    if (area == 0.0f) return normal;
    float side = area > 0.0f ? 1.0f : -1.0f;
    DIRT_PRECISE vec3 alongU = (e * df.y - f * de.y) * side;
    DIRT_PRECISE vec3 alongV = (f * de.x - e * df.x) * side;
    DIRT_PRECISE vec3 inPlaneU = alongU - normal * dotProduct(normal, alongU);
    vec3 u = directionOf(inPlaneU);
    DIRT_PRECISE vec3 v = vec3(normal.y * u.z - u.y * normal.z, normal.z * u.x - u.z * normal.x,
                               normal.x * u.y - u.x * normal.y);
    float upwards = dotProduct(v, alongV) < 0.0f ? -local.y : local.y;
    DIRT_PRECISE vec3 turned = u * local.x + v * upwards + normal * local.z;
    return directionOf(turned);
}

/// \p x, or the end of [0, 1] beyond which it lies.
DIRT_FUNCTION float withinUnit(float x) {
    return x > 0.0f ? (x < 1.0f ? x : 1.0f) : 0.0f;
}

/// What a surface reflects diffusely: what is above 1 would be more than it receives.
DIRT_FUNCTION vec3 boundedReflectance(vec3 diffuse) {
    return vec3(withinUnit(diffuse.x), withinUnit(diffuse.y), withinUnit(diffuse.z));
}

/// What it emits.
DIRT_FUNCTION vec3 boundedEmission(vec3 radiance) {
    return vec3(radiance.x > 0.0f ? boundedRadiance(radiance.x) : 0.0f,
                radiance.y > 0.0f ? boundedRadiance(radiance.y) : 0.0f,
                radiance.z > 0.0f ? boundedRadiance(radiance.z) : 0.0f);
}

/// A roughness times what a roughness map has there: the distribution's width grows by its square.
DIRT_FUNCTION float mappedRoughness(float roughness, float texel) {
    float root = texel > 0.0f ? texel : 0.0f;
    DIRT_PRECISE float mapped = roughness * (root * root);
    return withinUnit(mapped);
}

/// Metallic times what a metallic map has there.
DIRT_FUNCTION float mappedMetallic(float metallic, float texel) {
    DIRT_PRECISE float mapped = metallic * texel;
    return withinUnit(mapped);
}

/// Reflectance at normal incidence where a surface that has \p reflectance where it is no metal is
/// one by \p metallic.
DIRT_FUNCTION float metalReflectance(float reflectance, float metallic) {
    DIRT_PRECISE float value = reflectance + (1.0f - reflectance) * metallic;
    return value;
}

DIRT_SHARED_END

#endif
