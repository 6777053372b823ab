#pragma once

#include "core/grid/geometry.h"
#include "core/trace/ray.h"
#include "core/verify/exact_number.h"

/// The exact decision on ray and triangle (T4).
namespace dirt::test {

struct ExactHit {
    bool hit = false;
    Fraction t, u, v; ///< only if hit
};

/// Whether the exact ray, t >= 0, meets the closed triangle; a ray in the triangle's plane, or a
/// triangle without area, is no hit, nor is a triangle that holds the eye, of a ray from there.
inline ExactHit intersectExactly(const Ray& ray, const Triangle& triangle) {
    ExactHit result;
    const int unit = std::min({lowestExponent(ray.origin), lowestExponent(triangle.a),
                               lowestExponent(triangle.b), lowestExponent(triangle.c)});
    const int directionUnit = lowestExponent(ray.direction);
    if (unit == INT_MAX || directionUnit == INT_MAX) return result; // all zero

    const IntegerVector o = toIntegers(ray.origin, unit),
                        d = toIntegers(ray.direction, directionUnit);
    const IntegerVector a = toIntegers(triangle.a, unit) - o;
    const IntegerVector b = toIntegers(triangle.b, unit) - o;
    const IntegerVector c = toIntegers(triangle.c, unit) - o;

    const Integer weights[3] = {dot(d, cross(b, c)), dot(d, cross(c, a)), dot(d, cross(a, b))};
    const Integer sum = weights[0] + weights[1] + weights[2]; // d . normal
    if (sum == 0) return result;
    for (const Integer& weight : weights)
        if (sign(weight) * sign(sum) < 0) return result;
    const Integer distance = dot(a, cross(b - a, c - a));
    if (sign(distance) * sign(sum) < 0) return result;
    if (distance == 0 && ray.origin == glm::vec3(0.0f)) return result;

    result.hit = true;
    const Integer denominator = abs(sum);
    result.t = {abs(distance), denominator, unit - directionUnit};
    result.u = {abs(weights[1]), denominator, 0};
    result.v = {abs(weights[2]), denominator, 0};
    return result;
}

/// (p - a) . ((b - a) x (c - a)), up to a positive factor.
inline Integer planeSideExactly(glm::vec3 p, const Triangle& triangle) {
    const int unit = std::min({lowestExponent(p), lowestExponent(triangle.a),
                               lowestExponent(triangle.b), lowestExponent(triangle.c)});
    if (unit == INT_MAX) return 0;
    const IntegerVector a = toIntegers(triangle.a, unit);
    return dot(toIntegers(p, unit) - a,
               cross(toIntegers(triangle.b, unit) - a, toIntegers(triangle.c, unit) - a));
}

/// d . ((b - a) x (c - a)), up to a positive factor.
inline Integer directionSideExactly(glm::vec3 d, const Triangle& triangle) {
    const int unit = std::min(
        {lowestExponent(triangle.a), lowestExponent(triangle.b), lowestExponent(triangle.c)});
    if (unit == INT_MAX || lowestExponent(d) == INT_MAX) return 0;
    const IntegerVector a = toIntegers(triangle.a, unit);
    return dot(toIntegers(d, lowestExponent(d)),
               cross(toIntegers(triangle.b, unit) - a, toIntegers(triangle.c, unit) - a));
}

} // namespace dirt::test
