#ifndef DIRT_SHARED_SAMPLING_H
#define DIRT_SHARED_SAMPLING_H

#include "shaders/shared/trigonometry.h"

DIRT_SHARED_BEGIN

const float kOneOverPi = 0.318309886183790672f;

/// How a path goes on.
struct Scattering {
    vec3 direction; // unit length; zero where it would leave through the surface: the path ends
    float pdf;      // over solid angle; 0 of a direction that a mirror leaves no choice of
    vec3 weight;    // reflectance times cosine over pdf
};

/// x a.x + y a.y + z a.z in a fixed order.
DIRT_FUNCTION float dotProduct(vec3 a, vec3 b) {
    DIRT_PRECISE float sum = a.x * b.x + a.y * b.y + a.z * b.z;
    return sum;
}

/// \p v with unit length; \p v must not be zero, nor so small or large that its square is not a
/// normal number.
DIRT_FUNCTION vec3 unitVector(vec3 v) {
    DIRT_PRECISE float scale = 1.0f / sqrt(dotProduct(v, v));
    DIRT_PRECISE vec3 unit = v * scale;
    return unit;
}

/// Two unit vectors at right angles to the unit vector \p n and to each other.
/// T. Duff et al., Building an Orthonormal Basis, Revisited, JCGT 6(1), 2017.
DIRT_FUNCTION void orthonormalBasis(vec3 n, DIRT_OUT(vec3) tangent, DIRT_OUT(vec3) bitangent) {
    float side = n.z >= 0.0f ? 1.0f : -1.0f;
    DIRT_PRECISE float a = -1.0f / (side + n.z);
    DIRT_PRECISE float b = n.x * n.y * a;
    DIRT_PRECISE vec3 t = vec3(1.0f + side * n.x * n.x * a, side * b, -side * n.x);
    DIRT_PRECISE vec3 u = vec3(b, side + n.y * n.y * a, -n.y);
    tangent = t;
    bitangent = u;
}

/// A direction around (0, 0, 1) with density cos(theta) / pi; its z is above 0 for u, v in [0, 1).
DIRT_FUNCTION vec3 cosineHemisphere(float u, float v) {
    float sine;
    float cosine;
    sinCosTwoPi(v, sine, cosine);
    DIRT_PRECISE float radius = sqrt(u);
    DIRT_PRECISE vec3 direction = vec3(radius * cosine, radius * sine, sqrt(1.0f - u));
    return direction;
}

/// The same around the unit vector \p normal.
DIRT_FUNCTION vec3 cosineAround(vec3 normal, float u, float v) {
    vec3 tangent;
    vec3 bitangent;
    orthonormalBasis(normal, tangent, bitangent);
    vec3 local = cosineHemisphere(u, v);
    DIRT_PRECISE vec3 direction = tangent * local.x + bitangent * local.y + normal * local.z;
    return direction;
}

DIRT_SHARED_END

#endif
