#ifndef DIRT_SHARED_SPOTLIGHT_H
#define DIRT_SHARED_SPOTLIGHT_H

#include "shaders/shared/exponential.h"
#include "shaders/shared/radiance.h"
#include "shaders/shared/rounding.h"
#include "shaders/shared/sampling.h"

DIRT_SHARED_BEGIN

/// A spotlight in the grid frame (std140).
struct GridSpotlight {
    vec3 position DIRT_DEFAULT(0.0f);
    float outer DIRT_DEFAULT(0.0f); // 1 - cos of the half aperture
    vec3 axis DIRT_DEFAULT(0.0f);   // unit vectors: axis, right, up
    float range DIRT_DEFAULT(0.0f); // outer less the same of the penumbra
    vec3 right DIRT_DEFAULT(0.0f);
    float exponent DIRT_DEFAULT(0.0f);
    vec3 up DIRT_DEFAULT(0.0f);
    uint conical DIRT_DEFAULT(0u);     // 0: a square frustum
    vec3 intensity DIRT_DEFAULT(0.0f); // on the axis, per squared unit, so that irradiance is in
                                       //   world units
    float unit DIRT_DEFAULT(1.0f);     // a length of the grid frame: a power of two about as large
                                       //   as the light is far away, 1 at least
};

/// The nearest to a light that light is told apart, of its unit.
const float kNearestToLight = 1.0842021724855044e-19f; // 2^-63

/// Farther lights, in the grid frame, reach nothing.
const float kFarthestLight = 8.507059173023462e+37f; // 2^126

/// What a point receives from a light, if nothing is between them.
struct LightSample {
    vec3 toLight;    // light minus point, grid frame
    vec3 direction;  // the same with unit length
    vec3 irradiance; // on a surface that faces the light; zero outside its cone
};

/// Part of the intensity on the axis that goes in the direction \p fromLight.
DIRT_FUNCTION float spotlightFalloff(GridSpotlight light, vec3 fromLight) {
    float x = dotProduct(fromLight, light.right);
    float y = dotProduct(fromLight, light.up);
    float z = dotProduct(fromLight, light.axis);
    bool conical = light.conical != 0u;
    if (!conical && !(z > 0.0f)) return 0.0f;
    DIRT_PRECISE float xx = x * x;
    DIRT_PRECISE float yy = y * y;
    // Squared distance from the axis; for the square frustum that of the larger coordinate, so
    // that the angle is taken to the frustum's nearest side.
    DIRT_PRECISE float side = conical ? xx + yy : (xx < yy ? yy : xx);
    DIRT_PRECISE float length = sqrt(side + z * z);
    // 1 - cos = sin^2 / (1 + cos), free of cancellation in front of the light.
    DIRT_PRECISE float angle = z > 0.0f ? side / (length * (length + z)) : 1.0f - z / length;
    DIRT_PRECISE float inside = light.outer - angle;
    if (!(angle < light.outer)) return 0.0f;
    if (!(inside < light.range)) return 1.0f;
    DIRT_PRECISE float part = inside / light.range;
    return light.exponent == 1.0f ? part : unitPower(part, light.exponent);
}

/// What \p point receives, in the grid frame.
///
/// Squares of a distance below 2^-63 or above 2^63 are no normal floats. So the distance is taken
/// times the power of two that brings it near 1, and the intensity is per squared unit: all in
/// between is scaled by powers of two, which rounds nothing.
DIRT_FUNCTION LightSample sampleSpotlight(GridSpotlight light, vec3 point) {
    LightSample result;
    DIRT_PRECISE vec3 toLight = light.position - point;
    result.toLight = toLight;
    result.direction = vec3(0.0f);
    result.irradiance = vec3(0.0f);
    float largest = abs(toLight.x);
    if (abs(toLight.y) > largest) largest = abs(toLight.y);
    if (abs(toLight.z) > largest) largest = abs(toLight.z);
    if (!(largest >= kSmallestNormal && largest < kFarthestLight)) return result;
    float inverse = uintBitsToFloat((254u - (floatBitsToUint(largest) >> 23u)) << 23u);
    DIRT_PRECISE vec3 scaled = toLight * inverse; // its largest coordinate is in [1, 2)
    float squared = dotProduct(scaled, scaled);
    DIRT_PRECISE vec3 direction = scaled * (1.0f / sqrt(squared));
    result.direction = direction;
    float falloff = spotlightFalloff(light, -scaled);
    if (!(falloff > 0.0f)) return result;
    DIRT_PRECISE float units = light.unit * inverse; // 1/4 at least
    if (!(units < 1.0f / kNearestToLight)) units = 1.0f / kNearestToLight;
    DIRT_PRECISE float received = falloff / squared * units;
    DIRT_PRECISE vec3 irradiance = light.intensity * units * received;
    result.irradiance = boundedRadiance(irradiance);
    return result;
}

DIRT_SHARED_END

#ifdef __cplusplus

#include <cstddef>

namespace dirt {
static_assert(sizeof(GridSpotlight) == 80 && offsetof(GridSpotlight, axis) == 16 &&
              offsetof(GridSpotlight, right) == 32 && offsetof(GridSpotlight, up) == 48 &&
              offsetof(GridSpotlight, intensity) == 64);
} // namespace dirt

#endif

#endif
