#include "core/verify/closed_bodies.h"

#include "core/trace/offset.h"
#include "core/verify/aim.h"
#include "core/verify/exact.h"
#include "core/verify/extreme_bodies.h"
#include "core/verify/random.h"
#include "core/verify/ray_kinds.h"

#include <cfloat>
#include <cmath>
#include <vector>

namespace dirt {

namespace {

constexpr int kTries = 64; ///< for one ray

/// Rays and how far they are followed.
struct Queries {
    std::vector<Ray> rays;
    std::vector<float> maxT;

    void add(const Ray& ray, float end) {
        rays.push_back(withoutDenormals(ray));
        maxT.push_back(end);
    }

    /// How many answers, of the two to each ray, are not \p hit.
    uint64_t unlike(bool hit, Tracer& tracer) const {
        std::vector<Hit> hits(rays.size());
        std::vector<uint8_t> occluded(rays.size());
        tracer.intersect(rays, hits);
        tracer.occluded(rays, maxT, occluded);
        uint64_t count = 0;
        for (size_t i = 0; i < rays.size(); i++)
            count += (uint64_t) (hits[i].found() != hit) + (uint64_t) ((occluded[i] != 0) != hit);
        return count;
    }
};

/// A room in the grid frame, and points of it.
struct GridRoom {
    glm::vec3 low, high;

    bool holds(glm::vec3 p) const {
        for (int i = 0; i < 3; i++)
            if (!(low[i] < p[i] && p[i] < high[i])) return false;
        return true;
    }
    float within(int axis, RayRandom& random) const {
        return (float) (low[axis] + random.uniform() * ((double) high[axis] - low[axis]));
    }
    glm::vec3 any(RayRandom& random) const {
        return {within(0, random), within(1, random), within(2, random)};
    }
    /// Of an edge, or of four a corner: on the walls exactly.
    glm::vec3 onEdge(RayRandom& random) const {
        glm::vec3 p;
        for (int i = 0; i < 3; i++) p[i] = random.below(2) ? high[i] : low[i];
        const int axis = (int) random.below(4);
        if (axis < 3) p[axis] = within(axis, random);
        return p;
    }
};

/// A part of the way, down to a millionth of it.
double someOfTheWay(RayRandom& random) {
    return std::pow(10.0, -6.0 * random.uniform());
}

glm::dvec3 between(const glm::dvec3& a, const glm::dvec3& b, double part) {
    return a + part * (b - a);
}

/// The sign of p against the plane of the triangle; with direction \p d in place of a point.
int sideOf(const Triangle& t, const DyadicVector& fromA) {
    const DyadicVector a(t.a);
    return dot(cross(DyadicVector(t.b) - a, DyadicVector(t.c) - a), fromA).sign();
}

/// Per triangle the sign of its outer side; empty where the triangles are not those of a convex
/// body.
std::vector<int> outerSides(const std::vector<Triangle>& triangles) {
    std::vector<int> sides;
    for (const Triangle& face : triangles) {
        int inner = 0;
        for (const Triangle& other : triangles)
            for (const glm::vec3& p : {other.a, other.b, other.c}) {
                const int side = sideOf(face, DyadicVector(p) - DyadicVector(face.a));
                if (side * inner < 0) return {};
                if (side != 0) inner = side;
            }
        if (inner == 0) return {};
        sides.push_back(-inner);
    }
    return sides;
}

} // namespace

std::optional<uint64_t> countLeaks(Tracer& tracer, const FrameGeometry& geometry,
                                   const Scene& scene, uint32_t rays, uint32_t seed) {
    const Room world = roomOf(scene.mesh);
    const GridRoom room{geometry.frame.toGrid(world.low), geometry.frame.toGrid(world.high)};
    const glm::vec3 light = geometry.frame.toGrid(scene.lights.front().position);
    Queries queries;
    for (uint32_t i = 0; i < rays; i++) {
        RayRandom random(seed, 0, i);
        for (int attempt = 0; attempt < kTries; attempt++) {
            const glm::vec3 target = room.onEdge(random);
            if (i % 2 == 0) {
                const glm::vec3 origin(between(target, room.any(random), someOfTheWay(random)));
                const auto ray = aimAtPoint(origin, target);
                if (!ray || !room.holds(ray->origin)) continue;
                queries.add(*ray, FLT_MAX);
            } else {
                // The light is seen past the edge; or from anywhere, where it is not.
                glm::vec3 origin(between(target, light, -someOfTheWay(random)));
                if (!room.holds(origin)) origin = room.any(random);
                if (!room.holds(origin)) continue;
                queries.add({origin, light - origin, kNoPrimitive}, 1.0f);
            }
            break;
        }
    }
    if (queries.rays.empty()) return std::nullopt;
    return queries.unlike(true, tracer);
}

std::optional<uint64_t> countSelfShadows(Tracer& tracer, const FrameGeometry& geometry,
                                         const Scene& scene, uint32_t rays, uint32_t seed) {
    const std::vector<Triangle>& triangles = geometry.triangles;
    const std::vector<int> outside = outerSides(triangles);
    if (outside.empty()) return std::nullopt;
    const glm::vec3 light = geometry.frame.toGrid(scene.lights.front().position);
    Queries queries;
    for (uint32_t i = 0; i < rays; i++) {
        RayRandom random(seed, 1, i);
        for (int attempt = 0; attempt < kTries; attempt++) {
            const uint32_t face = random.below(triangles.size());
            const Triangle& triangle = triangles[face];
            // Inside, on an edge, or at a corner.
            float u = (float) random.uniform(), v = (1.0f - u) * (float) random.uniform();
            const uint32_t place = random.below(4);
            if (place == 1) v = 0.0f;
            if (place == 2) u = 0.0f;
            if (place == 3) u = v = 0.0f;
            glm::vec3 direction;
            for (int k = 0; k < 3; k++) direction[k] = (float) (2.0 * random.uniform() - 1.0);
            const bool toLight = i % 2 == 1;
            if (toLight) direction = light - triangle.a;
            const int side = sideOf(triangle, DyadicVector(direction));
            if (side == 0 || (toLight && side != outside[face])) continue;
            if (side != outside[face]) direction = -direction;
            Ray ray{offsetOrigin(triangle, u, v, direction), direction, face};
            if (toLight) ray.direction = light - ray.origin;
            if (sideOf(triangle, DyadicVector(ray.direction)) != outside[face]) continue;
            queries.add(ray, toLight ? 1.0f : FLT_MAX);
            break;
        }
    }
    if (queries.rays.empty()) return std::nullopt;
    return queries.unlike(false, tracer);
}

} // namespace dirt
