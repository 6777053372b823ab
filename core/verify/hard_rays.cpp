// The kinds of rays at the edge of what floats hold.

#include "core/verify/aim.h"
#include "core/verify/ray_kinds.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

namespace dirt {

namespace {

glm::dvec3 timesPowerOfTwo(const glm::dvec3& v, int exponent) {
    return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

/// Uniform over the sphere.
glm::dvec3 anyDirection(RayRandom& random) {
    const double z = 2.0 * random.uniform() - 1.0, r = std::sqrt(1.0 - z * z);
    const double angle = 2.0 * std::numbers::pi * random.uniform();
    return {r * std::cos(angle), r * std::sin(angle), z};
}

glm::vec3 fromView(const View& view, float x, float y, float w) {
    glm::vec3 p;
    p[view.axisX] = x, p[view.axisY] = y, p[view.axisW] = view.signW * w;
    return p;
}

/// A power of two in [2^-\p least, 1].
float powerOfTwo(RayRandom& random, int least) {
    return std::ldexp(1.0f, -(int) random.below((uint64_t) least + 1));
}

float anyOf(const std::vector<float>& values, RayRandom& random) {
    return values[random.below(values.size())];
}

/// Bits, as arithmetic on denormals may flush them.
float denormal(RayRandom& random) {
    return std::bit_cast<float>((random.bits() & 0x807fffffu) | 1u);
}

/// \p d times the power of two that gives its largest component a random exponent of a normal
/// float.
glm::vec3 ofAnyLength(glm::vec3 d, RayRandom& random) {
    int exponent = 0;
    std::frexp(std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}), &exponent);
    const int wanted = -125 + (int) random.below(254); // m 2^wanted, m in [0.5, 1)
    return glm::vec3(timesPowerOfTwo(d, wanted - exponent));
}

} // namespace

Ray RaySource::plane(uint32_t index) const {
    RayRandom random = this->random(RayKind::plane, index);
    // Of another edge: none, or a power of two of it, to either side.
    const double away = std::ldexp((double) random.below(3) - 1.0, 2 - (int) random.below(5));
    Ray ray;
    for (int attempt = 0; attempt < kTries; attempt++) {
        const Triangle& triangle = anyTriangle(random);
        const glm::dvec3 vertices[3] = {triangle.a, triangle.b, triangle.c};
        const uint32_t first = random.below(3);
        const glm::dvec3 a = vertices[first], b = vertices[(first + 1) % 3],
                         c = vertices[(first + 2) % 3];
        // Differences of floats are exact in double, unless their exponents are far apart.
        const glm::dvec3 along =
            timesPowerOfTwo(b - a, 8 - (int) random.below(17)) * (random.below(2) ? 1.0 : -1.0);
        const glm::dvec3 beside = away * (c - a);
        ray = {glm::vec3(a + beside), glm::vec3(along), kNoPrimitive};
        const bool exact = glm::dvec3(ray.origin) == a + beside &&
                           glm::dvec3(ray.direction) == along && along != glm::dvec3(0.0);
        if (exact && inside(ray.origin)) break;
    }
    return withoutDenormals(ray);
}

Ray RaySource::border(uint32_t index) const {
    RayRandom random = this->random(RayKind::border, index);
    const View& view = views_[random.below(views_.size())];
    const bool column = random.below(2) != 0;
    const float s = anyOf(view.s, random), t = anyOf(view.t, random);
    // A border times a power of two is exact. Beside the border, anywhere in the view.
    const auto onBorder = [&](float w) {
        const std::vector<float>& others = column ? view.t : view.s;
        const float rim = others.back() * w;
        const float other = (float) (2.0 * random.uniform() - 1.0) * rim;
        return column ? fromView(view, s * w, other, w) : fromView(view, other, t * w, w);
    };
    const auto onCorner = [&](float w) { return fromView(view, s * w, t * w, w); };
    const float sign = random.below(2) ? 1.0f : -1.0f, w = powerOfTwo(random, 12);
    switch (index % 4) {
    case 0:
        return withoutDenormals(
            {onBorder(w), sign * onBorder(powerOfTwo(random, 12)), kNoPrimitive});
    case 1:
        return withoutDenormals(
            {onCorner(w), sign * onCorner(powerOfTwo(random, 12)), kNoPrimitive});
    case 2:
        return withoutDenormals({onBorder(w), glm::vec3(anyDirection(random)), kNoPrimitive});
    default:
        break;
    }
    Ray ray;
    for (int attempt = 0; attempt < kTries; attempt++) {
        const glm::vec3 origin = pointInBox(random), corner = onCorner(w);
        const auto exact = aimAtPoint(origin, corner);
        ray = exact ? *exact : Ray{origin, corner - origin, kNoPrimitive};
        if (inside(ray.origin)) break;
    }
    return withoutDenormals(ray);
}

Ray RaySource::wild(uint32_t index) const {
    constexpr RayKind kOthers[] = {RayKind::primary, RayKind::vertex, RayKind::edge,  RayKind::axis,
                                   RayKind::grazing, RayKind::plane,  RayKind::border};
    RayRandom random = this->random(RayKind::wild, index);
    Ray ray = make(kOthers[random.below(std::size(kOthers))], index);
    const uint32_t kind = index % 8;
    if (kind < 5)
        ray = withoutDenormals({ray.origin, ofAnyLength(ray.direction, random), ray.skip});
    if (kind == 5) ray.direction[(int) random.below(3)] = denormal(random);
    if (kind == 6)
        for (int i = 0; i < 3; i++) ray.direction[i] = denormal(random);
    for (glm::vec3* v : {&ray.origin, &ray.direction})
        for (int i = 0; i < 3; i++)
            if (std::bit_cast<uint32_t>((*v)[i]) << 1 == 0)
                (*v)[i] = random.below(2) ? 0.0f : -0.0f;
    if (kind == 7) {
        constexpr float kInfinity = std::numeric_limits<float>::infinity();
        const float values[] = {kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN()};
        glm::vec3& v = random.below(2) ? ray.origin : ray.direction;
        v[(int) random.below(3)] = values[random.below(3)];
    }
    return ray;
}

} // namespace dirt
