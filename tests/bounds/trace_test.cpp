// How near the walk, the intersection and what follows from it come to the bounds derived in
// core/trace.

#include "core/trace/intersect.h"
#include "core/trace/offset.h"
#include "core/trace/view_ray.h"
#include "tests/bounds/meeting.h"
#include "tests/support/exact_point.h"
#include "tests/support/exact_ray.h"
#include "tests/support/views.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace dirt::test {
namespace {

/// |f - exact| / |exact|.
double relativeError(double f, const Fraction& exact) {
    const int unit = std::min(f == 0.0 ? exact.exponent : lowestExponent(f), exact.exponent);
    const Integer value = exact.numerator << (exact.exponent - unit);
    return Fraction{abs(toInteger(f, unit) * exact.denominator - value), abs(value), 0}.value();
}

/// |f - exact|.
double distance(double f, const Fraction& exact) {
    const int unit = std::min(f == 0.0 ? exact.exponent : lowestExponent(f), exact.exponent);
    const Integer value = exact.numerator << (exact.exponent - unit);
    return Fraction{abs(toInteger(f, unit) * exact.denominator - value), exact.denominator, unit}
        .value();
}

// ---------------------------------------------------------------- the walk

const View& face() {
    static const ViewSet set = fullViews(kMaxTiles - 1, 1);
    return set.views[4]; // its frame is the grid's
}

/// Origin, direction, and the place of a border on either axis.
using Crossing = Numbers<8>;
Ray crossingRay(const Crossing& in) {
    return {vectorAt(in, 0), vectorAt(in, 1), kNoPrimitive};
}
float borderOf(float place) {
    return face().s[(size_t) std::clamp(place * (kMaxTiles - 1.0f), 0.0f, kMaxTiles - 1.0f)];
}
bool isSmall(const Ray& ray) {
    return maxNorm(ray.origin) < 4.0 && maxNorm(ray.direction) < 4.0 && isTraceable(ray);
}
Crossing anyRay(Random& random) {
    Crossing in;
    for (float& x : in) x = (float) random.uniform(-1, 1);
    in[6] = std::abs(in[6]), in[7] = std::abs(in[7]);
    return in;
}

/// N, D and m_y of the crossing x = s w.
struct ExactCrossing {
    Integer n, d, m;
    int unit, directionUnit, slopeUnit;

    ExactCrossing(const Ray& ray, float slope) {
        const ExactRay exact(ray);
        slopeUnit = slope == 0.0f ? 0 : std::min(0, lowestExponent(slope));
        const Integer s = toInteger(slope, slopeUnit);
        n = s * exact.origin.z - (exact.origin.x << -slopeUnit);
        d = (exact.direction.x << -slopeUnit) - s * exact.direction.z;
        m = exact.origin.z * exact.direction.x - exact.origin.x * exact.direction.z;
        unit = exact.unit, directionUnit = exact.directionUnit;
    }
    Fraction t() const { return {n * sign(d), abs(d), unit - directionUnit}; }
    Fraction depth() const { return {m * sign(d), abs(d), unit - slopeUnit}; }
};

double crossingScore(const Crossing& in, bool depth) {
    const Ray ray = crossingRay(in);
    if (!isSmall(ray)) return -HUGE_VAL;
    const float slope = borderOf(in[6]);
    const dirt::Crossing crossing = crossingOf(ViewRay(face(), ray), 0, slope);
    const ExactCrossing exact(ray, slope);
    if (!crossing.valid || exact.n == 0 || exact.m == 0) return -HUGE_VAL;
    return (depth ? relativeError(crossing.depth, exact.depth())
                  : relativeError(crossing.t, exact.t())) /
           (3 * v);
}

TEST(Bounds, CrossingsOfBorders) {
    expectHeld(Bound<8>{"t where a border is crossed: 3 * 2^-53",
                        0.99,
                        {{-0x1.00663p-2f, 0x1.000004p-57f, 0x1.3d01fcp-7f, 0x1.fffffap-3f,
                          0x1.361df4p-47f, 0x1.b0220ep-6f, 0x1.ffe1ecp-2f, -0x1.bcdacp-41f}},
                        anyRay,
                        [](const Crossing& in) { return crossingScore(in, false); }});
    expectHeld(Bound<8>{"depth there: 3 * 2^-53",
                        0.99,
                        {{-0x1.e78a6p-7f, -0x1.a0fd78p-36f, 0x1.ff91fap-1f, -0x1.00019ap+1f,
                          -0x1.20ce32p-35f, -0x1.000002p-3f, 0x1.fffffcp-2f, 0x1.000002p-40f}},
                        anyRay,
                        [](const Crossing& in) { return crossingScore(in, true); }});
}

/// Where the order is told, or is not, though the corner lies on a side of the line by more than
/// kCornerDoubt of the terms, or by less: what differs is the error of the side.
TEST(Bounds, OrderOfBorders) {
    expectHeld(Bound<8>{
        "side of a corner: 2 * 2^-53 of the terms",
        0.54,
        {{0x1.2c693ap-2f, 0x1.d95ee4p-1f, 0x1.ffffb8p-1f, 0x1.523182p-23f, -0x1.4482aap-39f,
          0x1.2167b6p-21f, 0x1.4b1d74p-1f, 0x1.ecbb76p-1f}},
        [](Random& random) {
            Crossing in = anyRay(random);
            const glm::vec3 corner(borderOf(in[6]), borderOf(in[7]), 1.0f);
            // From beside the corner, through it but for an ulp; some of it tiny, which double
            // drops.
            for (int i = 0; i < 3; ++i) {
                const float x = corner[i], ulp = std::nextafter(x, 9.0f * x) - x;
                const float off = ulp * (float) random.range(-99, 99);
                in[(size_t) i] = x + off;
                in[(size_t) i + 3] = -off * (float) (1.0 + random.uniform(-1, 1) * 0x1p-22);
                if (random.chance(0.3)) in[(size_t) i + 3] *= (float) random.powerOfTwo(-30, 0);
            }
            return in;
        },
        [](const Crossing& in) {
            const Ray ray = crossingRay(in);
            if (!isSmall(ray)) return -HUGE_VAL;
            const float s = borderOf(in[6]), t = borderOf(in[7]);
            const ViewRay seen(face(), ray);
            if (seen.step.x == 0 || seen.step.y == 0) return -HUGE_VAL;
            const ExactRay exact(ray);
            const int unit = std::min({lowestExponent(s), lowestExponent(t), 0});
            const IntegerVector m = cross(exact.origin, exact.direction);
            const IntegerVector corner = toIntegers({s, t, 1.0f}, unit);
            const double side = toDouble(dot(m, corner));
            const double size = toDouble(abs(m.x * corner.x)) + toDouble(abs(m.y * corner.y)) +
                                toDouble(abs(m.z * corner.z));
            if (size == 0.0) return -HUGE_VAL;
            const double part = std::abs(side) / size - kCornerDoubt; // > 0: told
            const bool told = orderOf(seen, s, t) != 0;
            return (told == (part > 0.0) ? -std::abs(part) : std::abs(part)) / (2 * v);
        }});
}

// ---------------------------------------------------------------- the intersection

/// (p - a) . ((b - a) x (c - a)), times \p factor.
Fraction sideOf(glm::vec3 p, const Triangle& t, int factor) {
    const int unit = std::min(
        {lowestExponent(p), lowestExponent(t.a), lowestExponent(t.b), lowestExponent(t.c), 0});
    const IntegerVector a = toIntegers(t.a, unit);
    return {factor * dot(toIntegers(p, unit) - a,
                         cross(toIntegers(t.b, unit) - a, toIntegers(t.c, unit) - a)),
            1, 3 * unit};
}

/// Of a weight, of |d|_1 and two norms: 14 * 2^-53, of which kEdgeError is more.
TEST(Bounds, EdgeDeterminants) {
    expectHeld(Bound<15>{
        "edge determinant: 14 * 2^-53 of the norms",
        0.51,
        {{0x1.6205ccp-3f, 0x1.d44ceep-6f, -0x1.b26e9ap+0f, 0x1.adbf36p+0f, 0x1.000006p-5f, 0x1p-4f,
          0x1.9c48aap-21f, -0x1.36a01p-17f, -0x1.e006ep-34f, 0x1.9b5802p-9f, -0x1.152246p+0f,
          -0x1.16179ep-1f, -0x1.597c54p-3f, 0x1.fa57c8p-1f, -0x1.fffddep-2f}},
        [](Random& random) { return meeting(random, random.uniform(0.1, 1), 0.5); },
        [](const Meeting& in) {
            if (!isCase(in)) return -HUGE_VAL;
            const Ray ray = rayOf(in);
            const Triangle t = triangleOf(in);
            const double weight = EdgePlanes(ray.origin, t).along(ray.direction).a;
            const int unit =
                std::min({lowestExponent(ray.origin), lowestExponent(t.b), lowestExponent(t.c), 0});
            const int directionUnit = std::min(lowestExponent(ray.direction), 0);
            const IntegerVector o = toIntegers(ray.origin, unit);
            const Integer exact = dot(toIntegers(ray.direction, directionUnit),
                                      cross(toIntegers(t.b, unit) - o, toIntegers(t.c, unit) - o));
            const int whole = 2 * unit + directionUnit;
            const double off = distance(weight, {exact, 1, whole});
            const glm::dvec3 origin(ray.origin);
            const double norms = oneNorm(ray.direction) * maxNorm(glm::dvec3(t.b) - origin) *
                                 maxNorm(glm::dvec3(t.c) - origin);
            return norms > 0.0 ? off / (14 * v * norms) : -HUGE_VAL;
        }});
}

/// Before the rounding to float: two errors of determinants, of their sum. kSureWeights makes that
/// 2^-24 at most.
TEST(Bounds, BarycentricWeights) {
    expectHeld(Bound<15>{
        "barycentric weight: 28 * 2^-53 of norms / sum",
        0.28,
        {{0x1.c50ef8p-1f, -0x1.2661ep-2f, 0x1.e94b5ap-2f, -0x1.fb1194p-21f, -0x1.1f69dcp+4f,
          0x1.03d1d6p-18f, 0x1.00ee9p+1f, 0x1.07644ap-2f, 0x1.9c788p+0f, 0x1.c2fc64p+0f,
          -0x1.1ec768p+0f, -0x1.99d5d8p-2f, 0x1.c2e71p-8f, 0x1.f09f2p-2f, 0x1.526b9ap+0f}},
        [](Random& random) {
            Meeting in = meeting(random, random.uniform(0.1, 1), 0.5);
            for (size_t i = 6; i < 15; ++i) // so that differences round
                if (random.chance(0.3)) in[i] *= (float) random.powerOfTwo(-30, 0);
            return in;
        },
        [](const Meeting& in) {
            TriangleHit hit;
            if (!isCase(in) || !intersect(rayOf(in), triangleOf(in), hit)) return -HUGE_VAL;
            const EdgePlanes::Weights w =
                EdgePlanes(vectorAt(in, 0), triangleOf(in)).along(vectorAt(in, 1));
            const double sum = w.a + w.b + w.c, bound = w.bound / kEdgeError * 28 * v;
            const ExactHit exact = intersectExactly(rayOf(in), triangleOf(in));
            return std::max(std::abs(w.b / sum - exact.u.value()),
                            std::abs(w.c / sum - exact.v.value())) *
                   std::abs(sum) / bound;
        }});
}

/// On which side of a plane: as certainSign of determinant.cpp forms it.
TEST(Bounds, SideOfAPlane) {
    expectHeld(Bound<15>{
        "side of a plane: 14 * 2^-53 of the norms",
        0.50,
        {{0x1.ff87cap-6f, 0x1.686fe8p+1f, 0x1.b60866p-1f, 0x1.0be934p-36f, 0x1.fffef8p-21f,
          0x1.8e5838p-11f, 0x1.775298p-6f, -0x1.071f4ep+0f, 0x1.1322a4p+0f, -0x1.fff656p-1f,
          -0x1.6d1992p-1f, 0x1.000004p-7f, 0x1.000006p+0f, -0x1.cf8f3p+0f, -0x1.cb5fdcp-5f}},
        [](Random& random) { return meeting(random, 1.0, std::exp2(random.uniform(-30, 0))); },
        [](const Meeting& in) {
            if (!isCase(in)) return -HUGE_VAL;
            const Triangle t = triangleOf(in);
            const glm::dvec3 from(t.a), x = glm::dvec3(vectorAt(in, 0)) - from;
            const glm::dvec3 y = glm::dvec3(t.b) - from, z = glm::dvec3(t.c) - from;
            const double value = glm::dot(x, glm::cross(y, z));
            const double norms = oneNorm(x) * maxNorm(y) * maxNorm(z);
            if (!(norms > 0.0)) return -HUGE_VAL;
            return distance(value, sideOf(vectorAt(in, 0), t, 1)) / (14 * v * norms);
        }});
}

/// How far a secondary ray's origin is moved, of what offset.cpp needs: a rounding of the point,
/// and a step along the normal, of a length of sqrt(3), that outweighs it, doubled once. Triangle,
/// u, v and the direction.
TEST(Bounds, OriginsOfSecondaryRays) {
    const auto part = [](const Numbers<14>& in) -> double {
        for (const float x : in)
            if (!(std::abs(x) < 16.0f)) return -HUGE_VAL;
        const float s = in[9], t = in[10];
        const Triangle triangle{vectorAt(in, 0), vectorAt(in, 1), vectorAt(in, 2)};
        const glm::vec3 direction(in[11], in[12], in[13]);
        if (!(s >= 0.0f && t >= 0.0f && s + t <= 1.0f)) return -HUGE_VAL;
        const glm::dvec3 a(triangle.a);
        const glm::dvec3 point = a + (glm::dvec3(triangle.b) - a) * (double) s +
                                 (glm::dvec3(triangle.c) - a) * (double) t;
        const double size = oneNorm(point);
        if (!(size > 0x1p-20)) return -HUGE_VAL; // where roundings of double do not matter
        const glm::dvec3 moved = glm::dvec3(offsetOrigin(triangle, s, t, direction)) - point;
        return glm::length(moved) / ((1.0 + 4.0 * std::sqrt(3.0)) * u * size + 0x1p-50 * 16.0);
    };
    expectHeld(
        Bound<14>{"origin of a secondary ray: (1 + 4 sqrt 3) u |p|_1",
                  0.51,
                  {{0x1.6575cap-3f, 0x1.6ba692p-1f, 0x1.2f4ae8p-2f, -0x1.340744p-1f, 0x1.17a2a2p-5f,
                    0x1.983082p-2f, 0x1.eb0104p-4f, -0x1.257ec2p-1f, -0x1.f22734p-1f,
                    0x1.a5db52p-3f, 0x1.000002p-2f, -0x1.30165cp-27f, -0x1.b3ae4ap-22f, 0x1p-9f}},
                  [](Random& random) {
                      Numbers<14> in;
                      for (float& x : in) x = (float) random.uniform(-1, 1);
                      in[9] = (float) random.uniform(0, 0.5);
                      in[10] = (float) random.uniform(0, 0.5);
                      return in;
                  },
                  part});
}

} // namespace
} // namespace dirt::test
