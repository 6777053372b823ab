#pragma once

#include "core/trace/ray.h"
#include "tests/support/views.h"

#include <cfloat>
#include <cmath>
#include <span>

/// Rays that a walk through the grid gets wrong: along borders, through corners, through and past
/// the eye, along axes; and rays aimed at a scene.
namespace dirt::test {

struct GridRay {
    Ray ray;
    const char* kind;
};

class GridRays {
public:
    GridRays(Random& random, const ViewSet& set, std::span<const Triangle> scene = {})
        : random(random), set(set), scene(scene) {}

    GridRay next() {
        view = &set.views[random.below((int) set.views.size())];
        GridRay r{};
        do {
            r.ray = {};
            r.kind = aim(r.ray);
        } while (r.ray.direction == glm::vec3(0.0f));
        return r;
    }

private:
    const char* aim(Ray& ray) {
        if (!scene.empty() && random.chance(0.6)) return atScene(ray);
        switch (random.below(13)) {
        case 0:
            ray = {anywhere(), direction()};
            return "random";
        case 1: {
            ray = {anywhere(), {}};
            for (int i = 0; i < 3; ++i)
                if (random.chance(0.3)) ray.origin[i] = 0.0f;
            ray.direction[random.below(3)] = (float) random.sign();
            return "along an axis";
        }
        case 2:
            ray.direction = random.chance(0.5) ? direction() : toGrid(corner(1.0));
            return "from the eye";
        case 3:
            ray.direction = random.chance(0.3) ? toGrid(corner(1.0)) : direction();
            ray.origin = ray.direction * (float) -random.powerOfTwo(-10, 1);
            return "through the eye";
        case 4: {
            ray.direction = direction();
            const double past = std::pow(10.0, random.uniform(-12, -1));
            ray.origin = glm::vec3(glm::dvec3(ray.direction) * -random.uniform(0, 2) +
                                   glm::dvec3(direction()) * past);
            return "past the eye";
        }
        case 5: { // exactly in the plane of a border: slope times powers of two
            const bool upright = random.chance(0.5);
            const double s = border(upright), w = random.powerOfTwo(-20, 0);
            const double dw = random.sign() * random.powerOfTwo(-20, 0);
            const double other = random.uniform(-1, 1) * w, dOther = random.uniform(-1, 1);
            ray.origin =
                toGrid(upright ? glm::dvec3(s * w, other, w) : glm::dvec3(other, s * w, w));
            ray.direction =
                toGrid(upright ? glm::dvec3(s * dw, dOther, dw) : glm::dvec3(dOther, s * dw, dw));
            return "along a border";
        }
        case 6:
        case 7: { // from corner to corner, exactly where the difference is exact
            const glm::dvec3 p = corner(random.powerOfTwo(-12, 0)),
                             q = corner(random.powerOfTwo(-12, 0));
            ray = {toGrid(p), toGrid(q - p)};
            return "corner to corner";
        }
        case 8: { // across a plane of constant depth, through many corners of an even grid
            const glm::dvec3 p = corner(random.powerOfTwo(-12, 0));
            ray.origin = toGrid(p);
            ray.direction = toGrid({random.range(-2, 2), random.range(-2, 2), 0.0});
            return "diagonal";
        }
        case 9: { // through a corner, from anywhere
            ray.origin = anywhere();
            ray.direction = toGrid(corner(random.uniform(0.01, 1))) - ray.origin;
            return "at a corner";
        }
        case 10: { // beside a border, by little
            const glm::dvec3 p = corner(random.powerOfTwo(-12, 0)),
                             q = corner(random.powerOfTwo(-12, 0));
            ray = {toGrid(p), toGrid(q - p)};
            for (int i = 0; i < 3; ++i) {
                ray.origin[i] = nudged(ray.origin[i]);
                ray.direction[i] = nudged(ray.direction[i]);
            }
            return "beside corners";
        }
        case 11: {
            ray = {anywhere(), direction()};
            ray.direction[random.below(3)] *= (float) random.wide(-12, -3);
            ray.direction *= (float) std::abs(random.wide(-6, 6));
            return "almost along an axis";
        }
        default:
            for (int i = 0; i < 3; ++i) {
                ray.origin[i] = (float) random.wide(-12, 0.3);
                ray.direction[i] = (float) random.wide(-8, 1);
            }
            return "wide exponents";
        }
    }

    const char* atScene(Ray& ray) {
        const Triangle& t = scene[random.below((int) scene.size())];
        const Triangle& other = scene[random.below((int) scene.size())];
        const glm::dvec3 a(t.a), ab = glm::dvec3(t.b) - a, ac = glm::dvec3(t.c) - a;
        const double u = random.uniform(), v = (1 - u) * random.uniform();
        const glm::vec3 inside(a + ab * u + ac * v), edge(a + ab * u);
        const glm::vec3 otherInside((other.a + other.b + other.c) * (1.0f / 3.0f));
        ray.origin = random.chance(0.2)   ? glm::vec3(0.0f)
                     : random.chance(0.5) ? anywhere()
                                          : otherInside;
        switch (random.below(6)) {
        case 0:
            ray.direction = inside - ray.origin;
            return "at a triangle";
        case 1:
            ray.direction = random.pick({t.a, t.b, t.c}) - ray.origin;
            return "at a vertex";
        case 2:
            ray.direction = edge - ray.origin;
            return "at an edge";
        case 3:
            ray.origin = random.pick({t.a, inside, edge});
            ray.direction = direction();
            return "from on a triangle";
        case 4: {
            const glm::dvec3 normal = glm::cross(ab, ac);
            const double length = glm::length(normal);
            if (length == 0) return "";
            ray.origin = glm::vec3(glm::dvec3(inside) + normal / length * random.wide(-7, -2) -
                                   (ab + ac) * random.uniform(-3, 3));
            ray.direction = inside - ray.origin;
            return "grazing";
        }
        default:
            ray.direction[random.below(3)] = (float) random.sign();
            for (int i = 0; i < 3; ++i)
                if (ray.direction[i] == 0.0f) ray.origin[i] = random.pick({t.a, inside})[i];
            return "along an axis, at a triangle";
        }
    }

    glm::vec3 anywhere() {
        const double size = random.chance(0.3) ? std::pow(10.0, random.uniform(-6, 0)) : 1.5;
        return {(float) random.uniform(-size, size), (float) random.uniform(-size, size),
                (float) random.uniform(-size, size)};
    }
    glm::vec3 direction() {
        glm::dvec3 d;
        do d = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        while (glm::dot(d, d) > 1 || glm::dot(d, d) < 1e-6);
        return glm::vec3(d);
    }
    double border(bool upright) {
        const std::vector<float>& borders = upright ? view->s : view->t;
        return borders[random.below((int) borders.size())];
    }
    glm::dvec3 corner(double w) { return {border(true) * w, border(false) * w, w}; }
    glm::vec3 toGrid(glm::dvec3 p) const { return fromView(*view, glm::vec3(p)); }
    float nudged(float x) {
        const int steps = random.range(-2, 2);
        for (int i = 0; i < std::abs(steps); ++i) x = std::nextafter(x, steps > 0 ? 4.0f : -4.0f);
        return std::abs(x) < FLT_MIN ? 0.0f : x; // traversal flushes denormals
    }

    Random& random;
    const ViewSet& set;
    std::span<const Triangle> scene;
    const View* view = nullptr;
};

} // namespace dirt::test
