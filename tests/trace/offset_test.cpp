#include "core/trace/offset.h"
#include "tests/support/exact_ray.h"
#include "tests/support/nasty_rays.h"
#include "tests/support/print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <map>
#include <string>

// T5: where secondary rays start.

namespace dirt::test {
namespace {

/// Moved by at most this many times the rounding error of the point: 2^-24 |p|_1, and in double
/// 2^-50 of the triangle's largest coordinate. The point's own rounding is 1; the step along the
/// normal, whose length is at most sqrt(3) of its largest component, has to outweigh it (2
/// sqrt(3)); and it may be doubled once.
constexpr double kMostMoved = 1.0 + 4.0 * 1.7320508;

struct OffsetCase {
    Triangle triangle;
    float u, v;
    glm::vec3 direction;
};

std::string violation(const OffsetCase& c) {
    const glm::vec3 origin = offsetOrigin(c.triangle, c.u, c.v, c.direction);
    const glm::dvec3 a(c.triangle.a);
    const glm::dvec3 point = a + (glm::dvec3(c.triangle.b) - a) * (double) c.u +
                             (glm::dvec3(c.triangle.c) - a) * (double) c.v;
    const glm::dvec3 moved = glm::abs(glm::dvec3(origin) - point);
    const double size = std::abs(point.x) + std::abs(point.y) + std::abs(point.z);

    const bool flat = sign(directionSideExactly({1, 0, 0}, c.triangle)) == 0 &&
                      sign(directionSideExactly({0, 1, 0}, c.triangle)) == 0 &&
                      sign(directionSideExactly({0, 0, 1}, c.triangle)) == 0;
    if (flat) return origin == glm::vec3(point) ? "" : "without area, but moved";

    const int outgoing = sign(directionSideExactly(c.direction, c.triangle));
    const int side = sign(planeSideExactly(origin, c.triangle));
    if (side == 0) return "on the plane";
    if (outgoing != 0 && side != outgoing) return "on the wrong side";
    double largest = 0;
    for (const glm::vec3& p : {c.triangle.a, c.triangle.b, c.triangle.c})
        for (int i = 0; i < 3; ++i) largest = std::max(largest, (double) std::abs(p[i]));
    const double most = kMostMoved * (0x1p-24 * size + 0x1p-50 * largest) + 0x1p-118;
    const double distance = glm::length(moved);
    if (distance > most) return "moved too far: " + std::to_string(distance / most) + " times";
    return "";
}

OffsetCase nasty(Random& random, NastyRays& rays) {
    OffsetCase c;
    c.triangle = rays.triangle();
    if (random.chance(0.2)) { // a needle, thinner than the roundings of its edges
        const glm::dvec3 along(rays.direction());
        for (glm::vec3* p : {&c.triangle.a, &c.triangle.b, &c.triangle.c})
            *p = glm::vec3(along * random.wide(-12, 0));
    }
    c.u = (float) random.pick({0.0, 1.0, random.uniform()});
    c.v = (float) ((1.0 - c.u) * random.pick({0.0, 1.0, random.uniform()}));
    const glm::dvec3 ab = glm::dvec3(c.triangle.b) - glm::dvec3(c.triangle.a);
    const glm::dvec3 ac = glm::dvec3(c.triangle.c) - glm::dvec3(c.triangle.a);
    c.direction = rays.direction();
    if (random.chance(0.3)) // grazing
        c.direction = glm::vec3(ab * random.uniform(-1, 1) + ac * random.uniform(-1, 1));
    return c;
}

TEST(Offset, LiesOnTheOutgoingSideAndNotFar) {
    Random random(11);
    NastyRays rays(random);
    std::map<std::string, int> failures;
    for (int i = 0; i < cases(50'000, 1'000'000); ++i) {
        const OffsetCase c = nasty(random, rays);
        const std::string wrong = violation(c);
        if (wrong.empty()) continue;
        if (++failures[wrong.substr(0, 15)] <= 3)
            ADD_FAILURE() << wrong << "\n"
                          << hex(c.triangle) << " " << hex(c.u) << " " << hex(c.v) << " "
                          << hex(c.direction);
    }
    for (const auto& [what, count] : failures) ADD_FAILURE() << count << " times " << what;
}

} // namespace
} // namespace dirt::test
