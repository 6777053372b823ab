#include "backend_cpu/direct_visibility.h"

#include "backend_cpu/image_footprint.h"
#include "core/grid/denormals.h"
#include "core/path/surface.h"
#include "core/trace/intersect.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cfloat>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

namespace dirt {
namespace {

constexpr size_t kTrianglesPerPiece = 1024;
constexpr size_t kPixelsPerPiece = 4096;

/// What a pixel sees: the bits of t, which for t >= 0 are in the order of t, above the id. The
/// least key is the nearest hit, at equal t that of the lowest id.
using Key = uint64_t;
constexpr Key kNothing = ~0ull;

Key makeKey(float t, uint32_t id) {
    return (Key) std::bit_cast<uint32_t>(t) << 32 | id;
}
float distanceOf(Key key) {
    return std::bit_cast<float>((uint32_t) (key >> 32));
}

void includeAtomically(Key& shared, Key key) {
    std::atomic_ref<Key> nearest(shared);
    Key current = nearest.load(std::memory_order_relaxed);
    while (key < current &&
           !nearest.compare_exchange_weak(current, key, std::memory_order_relaxed)) {
    }
}

/// A triangle seen from the eye, for rays that start there: a filter before the exact decision.
///
/// Each component of a cross product of floats in double has one rounding; three products with the
/// direction and two sums make the error of an edge's weight less than
/// 4 * 2^-53 sum |d_i n_i| <= 2^-51 |d|_max |n|_1, here with twice that.
class EyeTriangle {
public:
    /// \p reach bounds the |components| of the rays' directions.
    EyeTriangle(const Triangle& triangle, double reach) {
        const glm::dvec3 a(triangle.a), b(triangle.b), c(triangle.c);
        edges_[0] = glm::cross(b, c);
        edges_[1] = glm::cross(c, a);
        edges_[2] = glm::cross(a, b);
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 n = glm::abs(edges_[i]);
            bounds_[i] = 0x1p-50 * reach * (n.x + n.y + n.z);
        }
        const glm::dvec3 terms = a * edges_[0];
        volume_ = std::abs(terms.x + terms.y + terms.z) -
                  0x1p-50 * (std::abs(terms.x) + std::abs(terms.y) + std::abs(terms.z));
    }

    /// True only if the exact ray misses the closed triangle, or meets it at a t that is computed
    /// as more than \p limit.
    bool certainlyBeyond(const glm::dvec3& direction, float limit) const {
        bool positive = false, negative = false;
        double sum = 0.0, error = 0.0;
        for (int i = 0; i < 3; ++i) {
            const double weight = glm::dot(edges_[i], direction);
            positive |= weight > bounds_[i];
            negative |= weight < -bounds_[i];
            sum += weight;
            error += bounds_[i];
        }
        if (positive && negative) return true;
        // t = volume / sum of weights; the computed t is off by less than 2^-22 of it, and the sum
        // of three weights by less than twice their bounds.
        // Below FLT_MIN it is computed as zero.
        const double beyond = std::max((double) limit, (double) FLT_MIN) * (1.0 + 0x1p-22);
        return volume_ > beyond * (std::abs(sum) + 2.0 * error);
    }

private:
    glm::dvec3 edges_[3]; ///< normals of the planes through the eye and an edge
    double bounds_[3];
    double volume_; ///< |a . (b x c)|, from below
};

Ray rayThrough(const FrameContext& frame, int x, int y, glm::vec2 offset) {
    Ray ray = frame.camera.through((float) x + offset.x, (float) y + offset.y);
    for (int i = 0; i < 3; ++i) ray.direction[i] = flushed(ray.direction[i]);
    return ray;
}

/// Bound of the |components| of all directions: they are affine in the pixel.
double reachOf(const FrameContext& frame) {
    const int width = frame.settings.grid.width, height = frame.settings.grid.height;
    double reach = 0.0;
    for (int corner = 0; corner < 4; ++corner) {
        const Ray ray = frame.camera.through((float) (corner & 1 ? width : 0),
                                             (float) (corner & 2 ? height : 0));
        for (int i = 0; i < 3; ++i) reach = std::max(reach, (double) std::abs(ray.direction[i]));
    }
    return reach * (1.0 + 0x1p-20);
}

/// The nearest hit of every pixel.
std::vector<Key> findNearest(const FrameContext& frame, Executor& executor, glm::vec2 offset) {
    const GridSettings& grid = frame.settings.grid;
    const ImageFootprint footprint(frame.scene.camera, grid.width, grid.height, grid.mode, offset);
    const double reach = reachOf(frame);
    std::vector<Key> keys((size_t) grid.width * grid.height, kNothing);
    const auto& triangles = frame.geometry.triangles;
    executor.forRange(triangles.size(), kTrianglesPerPiece, [&](size_t begin, size_t end) {
        for (size_t id = begin; id < end; ++id) {
            const Triangle& triangle = triangles[id];
            const PixelRange range = footprint(triangle);
            if (range.x0 > range.x1 || range.y0 > range.y1) continue;
            const EyeTriangle seen(triangle, reach);
            for (int y = range.y0; y <= range.y1; ++y)
                for (int x = range.x0; x <= range.x1; ++x) {
                    Key& key = keys[(size_t) y * grid.width + x];
                    const Ray ray = rayThrough(frame, x, y, offset);
                    const Key current = std::atomic_ref<Key>(key).load(std::memory_order_relaxed);
                    const float limit = current == kNothing ? INFINITY : distanceOf(current);
                    TriangleHit hit;
                    if (!seen.certainlyBeyond(ray.direction, limit) &&
                        intersect(ray, triangle, hit))
                        includeAtomically(key, makeKey(hit.t, (uint32_t) id));
                }
        }
    });
    return keys;
}

} // namespace

void rasterizeDirectVisibility(const FrameContext& frame, Executor& executor, uint32_t sample,
                               std::span<SurfacePoint> points) {
    const int width = frame.settings.grid.width;
    const glm::vec2 offset = subPixelOffset(sample, frame.settings.seed);
    const std::vector<Key> keys = findNearest(frame, executor, offset);
    executor.forRange(points.size(), kPixelsPerPiece, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            points[i] = {};
            if (keys[i] == kNothing) continue;
            const uint32_t id = (uint32_t) keys[i];
            const Ray ray = rayThrough(frame, (int) (i % width), (int) (i / width), offset);
            TriangleHit hit;
            intersect(ray, frame.geometry.triangles[id], hit);
            points[i] = fetchSurface(frame.scene, frame.geometry, ray.direction, id, hit.u, hit.v);
        }
    });
}

} // namespace dirt
