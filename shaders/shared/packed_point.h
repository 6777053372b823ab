// Surface points in at most 32 bytes. The primitive and the barycentric weights are kept exactly,
// so that what follows from them and the triangle buffer, the position, the geometric normal and
// the origin of the rays that leave, is what it is in full precision, bit for bit. The rest is
// rounded.
#ifndef DIRT_SHARED_PACKED_POINT_H
#define DIRT_SHARED_PACKED_POINT_H

#include "shaders/shared/layouts.h"
#include "shaders/shared/surface.h"

DIRT_SHARED_BEGIN

/// A packed SurfacePoint. A scene without one of the last three leaves out its word.
struct PackedPoint {
    uint primitive DIRT_DEFAULT(kNoPrimitive);
    uint u DIRT_DEFAULT(0u); // bits of the float
    uint v DIRT_DEFAULT(0u);
    uint diffuse DIRT_DEFAULT(0u);         // mantissas: red, green, low bits of blue
    uint roughness DIRT_DEFAULT(0u);       // high bits of blue, exponent, roughness, side
    uint normal DIRT_DEFAULT(0x80008000u); // kNormalOfTriangle
    uint emission DIRT_DEFAULT(0u);        // mantissas and exponent, a byte each
    uint gloss DIRT_DEFAULT(0u);           // as it is in full precision
};

/// In place of a shading normal that is the geometric one.
const uint kNormalOfTriangle = 0x80008000u;

/// Colours are three mantissas over one exponent, such that the largest one has its leading bit:
/// each component is off by at most 2^-bits (1 + 2^-bits) of the largest one.
const int kDiffuseBits = 13;
const int kEmissionBits = 8;

/// Components of normals are multiples of this part of 1.
const float kNormalSteps = 32767.0f;
const float kRoughnessSteps = 65535.0f;

/// Powers of two whose exponent a normal float has.
DIRT_FUNCTION float twoTo(int exponent) {
    return uintBitsToFloat(uint(exponent + 127) << 23u);
}

/// The exponent, as a float has it, above that of the largest component where its mantissa of
/// \p bits is rounded up to 1. Colours below 2^-97 count as black, so that all steps are normal
/// numbers, and what is above 2^127 as that.
DIRT_FUNCTION uint sharedExponent(vec3 colour, int bits) {
    float largest = colour.x > colour.y ? colour.x : colour.y;
    if (colour.z > largest) largest = colour.z;
    if (!(largest >= twoTo(-97))) return 0u;
    if (largest > twoTo(127)) return 254u;
    uint exponent = floatBitsToUint(largest) >> 23u;
    DIRT_PRECISE float mantissa = largest * twoTo(bits + 126 - int(exponent)) + 0.5f;
    return mantissa >= twoTo(bits) ? exponent + 1u : exponent;
}

/// The mantissa of one component. \p exponent: from sharedExponent.
DIRT_FUNCTION uint mantissaOf(float component, uint exponent, int bits) {
    if (exponent == 0u || !(component > 0.0f)) return 0u;
    float value = component < twoTo(127) ? component : twoTo(127);
    DIRT_PRECISE float mantissa = value * twoTo(bits + 126 - int(exponent)) + 0.5f;
    return uint(mantissa);
}

DIRT_FUNCTION vec3 colourOf(uint red, uint green, uint blue, uint exponent, int bits) {
    if (exponent == 0u) return vec3(0.0f);
    DIRT_PRECISE vec3 colour =
        vec3(float(red), float(green), float(blue)) * twoTo(int(exponent) - 126 - bits);
    return colour;
}

/// The multiple of 1/kNormalSteps nearest to \p x of [-1, 1], in 16 bits.
DIRT_FUNCTION uint signedStep(float x) {
    DIRT_PRECISE float steps = floor(x * kNormalSteps + 0.5f);
    return uint(int(steps)) & 0xffffu;
}

DIRT_FUNCTION float fromSignedStep(uint bits) {
    DIRT_PRECISE float x = float(int(bits << 16u) >> 16) / kNormalSteps;
    return x;
}

/// A unit vector, by the octahedron's two coordinates. A step of half of 1/kNormalSteps in both
/// moves the point of the octahedron by at most sqrt(6) of it, and all its points are at least
/// 1/sqrt(3) from the centre: the direction is off by at most sqrt(18)/65534 < 6.5e-5, in radians.
/// Z. Cigolle et al., A Survey of Efficient Representations for Independent Unit Vectors, JCGT
/// 3(2), 2014.
DIRT_FUNCTION uint packNormal(vec3 normal) {
    DIRT_PRECISE float size = abs(normal.x) + abs(normal.y) + abs(normal.z);
    DIRT_PRECISE float x = normal.x / size;
    DIRT_PRECISE float y = normal.y / size;
    if (normal.z < 0.0f) {
        DIRT_PRECISE float beyondX = 1.0f - abs(y);
        DIRT_PRECISE float beyondY = 1.0f - abs(x);
        x = x < 0.0f ? -beyondX : beyondX;
        y = y < 0.0f ? -beyondY : beyondY;
    }
    return signedStep(x) | signedStep(y) << 16u;
}

DIRT_FUNCTION vec3 unpackNormal(uint steps) {
    float x = fromSignedStep(steps & 0xffffu);
    float y = fromSignedStep(steps >> 16u);
    DIRT_PRECISE float z = 1.0f - abs(x) - abs(y);
    if (z < 0.0f) {
        DIRT_PRECISE float innerX = 1.0f - abs(y);
        DIRT_PRECISE float innerY = 1.0f - abs(x);
        x = x < 0.0f ? -innerX : innerX;
        y = y < 0.0f ? -innerY : innerY;
    }
    return unitVector(vec3(x, y, z));
}

/// \p a, \p b, \p c: the corners of the point's triangle.
DIRT_FUNCTION PackedPoint packPoint(SurfacePoint point, vec3 a, vec3 b, vec3 c) {
    PackedPoint record;
    record.primitive = point.primitive;
    record.u = floatBitsToUint(point.u);
    record.v = floatBitsToUint(point.v);
    uint exponent = sharedExponent(point.diffuse, kDiffuseBits);
    uint blue = mantissaOf(point.diffuse.z, exponent, kDiffuseBits);
    record.diffuse = mantissaOf(point.diffuse.x, exponent, kDiffuseBits) |
                     mantissaOf(point.diffuse.y, exponent, kDiffuseBits) << 13u | blue << 26u;
    DIRT_PRECISE float roughness = point.roughness * kRoughnessSteps + 0.5f;
    bool behind = dotProduct(triangleNormal(a, b, c), point.geometricNormal) < 0.0f;
    record.roughness =
        blue >> 6u | exponent << 7u | uint(roughness) << 15u | (behind ? 0x80000000u : 0u);
    record.normal = point.shadingNormal == point.geometricNormal ? kNormalOfTriangle
                                                                 : packNormal(point.shadingNormal);
    exponent = sharedExponent(point.emission, kEmissionBits);
    record.emission = mantissaOf(point.emission.x, exponent, kEmissionBits) |
                      mantissaOf(point.emission.y, exponent, kEmissionBits) << 8u |
                      mantissaOf(point.emission.z, exponent, kEmissionBits) << 16u |
                      exponent << 24u;
    record.gloss = point.gloss;
    return record;
}

DIRT_FUNCTION vec3 diffuseOf(PackedPoint record) {
    return colourOf(record.diffuse & 0x1fffu, record.diffuse >> 13u & 0x1fffu,
                    record.diffuse >> 26u | (record.roughness & 0x7fu) << 6u,
                    record.roughness >> 7u & 0xffu, kDiffuseBits);
}

DIRT_FUNCTION vec3 emissionOf(PackedPoint record) {
    return colourOf(record.emission & 0xffu, record.emission >> 8u & 0xffu,
                    record.emission >> 16u & 0xffu, record.emission >> 24u, kEmissionBits);
}

/// The point, of which there is one; \p a, \p b, \p c as above.
DIRT_FUNCTION SurfacePoint unpackPoint(PackedPoint record, vec3 a, vec3 b, vec3 c) {
    SurfacePoint point;
    point.primitive = record.primitive;
    point.u = uintBitsToFloat(record.u);
    point.v = uintBitsToFloat(record.v);
    point.position = interpolate(a, b, c, point.u, point.v);
    vec3 outward = triangleNormal(a, b, c);
    point.geometricNormal = (record.roughness & 0x80000000u) != 0u ? -outward : outward;
    point.shadingNormal =
        record.normal == kNormalOfTriangle ? point.geometricNormal : unpackNormal(record.normal);
    point.diffuse = diffuseOf(record);
    DIRT_PRECISE float roughness = float(record.roughness >> 15u & 0xffffu) / kRoughnessSteps;
    point.roughness = roughness;
    point.emission = emissionOf(record);
    point.gloss = record.gloss;
    return point;
}

DIRT_SHARED_END

#endif
