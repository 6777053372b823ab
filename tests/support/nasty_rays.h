#pragma once

#include "core/grid/geometry.h"
#include "core/trace/ray.h"
#include "tests/support/random.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

/// Rays and triangles whose exact decision floating point gets wrong.
namespace dirt::test {

struct RayCase {
    Ray ray;
    Triangle triangle;
    const char* kind;
};

class NastyRays {
public:
    explicit NastyRays(Random& random) : random(random) {}

    RayCase next() {
        RayCase c{{}, triangle(), ""};
        c.kind = aim(c);
        return c;
    }

    glm::vec3 direction() {
        glm::dvec3 d;
        do d = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        while (glm::dot(d, d) > 1 || glm::dot(d, d) < 1e-6);
        return glm::vec3(d);
    }

    /// Any triangle, or a small-integer one (so that sums are exact), a sliver, or one without
    /// area.
    Triangle triangle() {
        Triangle t;
        const double size = random.wide(-6, 6);
        const glm::dvec3 offset =
            random.chance(0.5) ? glm::dvec3(0) : at(std::pow(10.0, random.uniform(-6, 6)));
        switch (random.below(10)) {
        case 0:
            t = {wide(-6, 6), wide(-6, 6), wide(-6, 6)};
            break;
        case 1:
            t = {wide(-18, 18), wide(-18, 18), wide(-18, 18)};
            break;
        case 2:
        case 3:
        case 4:
            t = {integers(1000), integers(1000), integers(1000)};
            break;
        case 5:
            t = {glm::vec3(at(size)), glm::vec3(at(size)), glm::vec3(at(size))};
            t.c = glm::vec3(glm::mix(glm::dvec3(t.a), glm::dvec3(t.b), random.uniform()) +
                            at(size * std::pow(10.0, random.uniform(-8, -3))));
            break;
        case 6: // no area
            t.a = integers(1000), t.b = integers(1000);
            t.c = random.chance(0.5) ? t.a : 2.0f * t.b - t.a;
            break;
        default:
            t = {glm::vec3(at(size) + offset), glm::vec3(at(size) + offset),
                 glm::vec3(at(size) + offset)};
        }
        return t;
    }

private:
    glm::dvec3 at(double size) {
        return {random.uniform(-size, size), random.uniform(-size, size),
                random.uniform(-size, size)};
    }
    glm::vec3 wide(double lo, double hi) {
        return {(float) random.wide(lo, hi), (float) random.wide(lo, hi),
                (float) random.wide(lo, hi)};
    }
    glm::vec3 integers(int n) {
        return {(float) random.range(-n, n), (float) random.range(-n, n),
                (float) random.range(-n, n)};
    }

    const char* aim(RayCase& c) {
        Ray& ray = c.ray;
        const Triangle& t = c.triangle;
        const glm::dvec3 a(t.a), b(t.b), ab = glm::dvec3(t.b) - a, ac = glm::dvec3(t.c) - a;
        const double size = std::max(glm::length(ab), glm::length(ac));
        double u = random.uniform(), v = (1 - u) * random.uniform();
        const glm::dvec3 inside = a + ab * u + ac * v;
        ray.origin = random.chance(0.2)
                         ? glm::vec3(0)
                         : glm::vec3(inside + at(size * std::pow(10.0, random.uniform(-3, 3))));
        const glm::dvec3 o(ray.origin);
        const float scale = random.chance(0.5) ? 1.0f : (float) random.wide(-6, 6);

        switch (random.below(13)) {
        case 0:
            ray.direction = direction() * scale;
            return "random";
        case 1:
            ray.direction = glm::vec3(inside - o) * scale;
            return "inside";
        case 2:
        case 3:
            ray.direction = (random.pick({t.a, t.b, t.c}) - ray.origin) * std::abs(scale);
            return "vertex";
        case 4:
        case 5:
            ray.direction = glm::vec3(a + ab * u - o) * std::abs(scale);
            return "edge";
        case 6: // exactly at an integer point's multiple: at a vertex or the middle of an edge
            ray.direction = integers(50);
            ray.origin = (random.chance(0.5) ? t.a : 0.5f * (t.a + t.b)) -
                         (float) random.range(-3, 9) * ray.direction;
            return "exact";
        case 7: // exactly in the plane for integer triangles
            ray.direction = (t.b - t.a) * (float) random.range(-3, 3) +
                            (t.c - t.a) * (float) random.range(-3, 3);
            ray.origin = t.a + (t.b - t.a) * (float) random.range(-3, 3) +
                         (t.c - t.a) * (float) random.range(-3, 3);
            return "in the plane";
        case 8: {
            const glm::dvec3 normal = glm::cross(ab, ac);
            const double length = glm::length(normal);
            const glm::dvec3 n = length > 0 ? normal / length : glm::dvec3(0, 0, 1);
            const glm::dvec3 along = ab * random.uniform(-1, 1) + ac * random.uniform(-1, 1);
            const double height = size * random.wide(-9, -4);
            ray.origin = glm::vec3(inside - along + n * height);
            ray.direction = glm::vec3(inside - glm::dvec3(ray.origin));
            return "grazing";
        }
        case 9:
            ray.origin = random.pick({t.a, t.b, t.c, 0.5f * (t.a + t.b), glm::vec3(inside)});
            ray.direction = direction() * scale;
            return "from on the triangle";
        case 10: {
            ray.direction = direction();
            const double back = size * random.wide(-9, -6);
            ray.origin = glm::vec3(inside + glm::dvec3(ray.direction) * back);
            return "from beside the triangle";
        }
        case 11:
            ray.direction = glm::vec3(0);
            ray.direction[random.below(3)] = scale;
            if (random.chance(0.7))
                ray.origin[random.below(3)] = random.pick({t.a, t.b, t.c})[random.below(3)];
            return "axis";
        default:
            ray.origin = wide(-18, 18);
            ray.direction = random.chance(0.5) ? wide(-18, 18) : t.a - ray.origin;
            return "huge range";
        }
    }

    Random& random;
};

} // namespace dirt::test
