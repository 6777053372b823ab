#include "core/frame/shadow_raster.h"

#include "core/base/denormals.h"
#include "core/trace/holes.h"
#include "core/trace/intersect.h"
#include "core/trace/norms.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>

#include <glm/geometric.hpp>

namespace dirt {
namespace {

constexpr size_t kDrawnAtOnce = 512;

/// Triangles with more texels in their rectangle are drawn in bands of rows, by all threads.
constexpr int64_t kMostTexels = 1 << 14;
constexpr int kBand = 16; ///< rows

Ray rayThrough(const GridSpotlight& light, const ShadowMap& map, uint x, uint y) {
    const glm::vec3 d = shadowRayDirection(light, map, x, y);
    return {light.position, {flushed(d.x), flushed(d.y), flushed(d.z)}, kNoPrimitive};
}

/// The depth at which \p ray meets the triangle, if that casts there.
bool casts(const FrameGeometry& geometry, const ShadowMap& map, const Ray& ray, uint32_t id,
           float& depth) {
    TriangleHit hit;
    if (!intersect(ray, geometry.triangles[id], hit) || !castsShadow(map, hit.t)) return false;
    // As the shadow ray, which comes back.
    if (geometry.mayHaveHoles(id) && !isHit(geometry, -ray.direction, id, hit.u, hit.v))
        return false;
    depth = hit.t;
    return true;
}

/// The edge determinants of a triangle, in double, as functions of a texel's place: all are above
/// their margin where the ray meets it for certain, and one is below its negative where it misses.
/// In between the exact decision is asked for.
///
/// Of d . (B × C) in double the error is below 2^-49 |d|_1 |B| |C| (intersect.cpp), and |d|_1 below
/// 3 (1 + 2 S), S the frustum's slope. That d is not the rounded direction of shadowRayDirection
/// but the nominal one makes 2^-20 (1 + 2 S) |B × C|_1 more (shadow_map.h).
class EdgeFunctions {
public:
    /// \p side: the sign that the determinants have inside.
    EdgeFunctions(const Triangle& t, const GridSpotlight& light, const ShadowMap& map, int side) {
        const glm::dvec3 o(light.position);
        const glm::dvec3 p[3] = {glm::dvec3(t.a) - o, glm::dvec3(t.b) - o, glm::dvec3(t.c) - o};
        const double step = map.step, first = 0.5 * step - map.extent;
        const glm::dvec3 right(light.right), up(light.up), axis(light.axis);
        const glm::dvec3 corner = axis + right * first + up * first;
        const double largest = 1.0 + 2.0 * map.extent;
        for (int i = 0; i < 3; ++i) {
            const glm::dvec3 &b = p[(i + 1) % 3], &c = p[(i + 2) % 3];
            const glm::dvec3 normal = (double) side * glm::cross(b, c);
            // As derived above.
            edges_[i] = {glm::dot(normal, corner), glm::dot(normal, right) * step,
                         glm::dot(normal, up) * step,
                         largest * (0x1p-20 * oneNorm(normal) + 0x1p-47 * oneNorm(b) * oneNorm(c))};
        }
    }

    /// The part of [\p x0, \p x1] in which the texels of a row may be hit.
    void narrow(int y, int& x0, int& x1) const {
        for (const Edge& edge : edges_) {
            if (x0 > x1) return;
            const double at = edge.first + y * edge.dy + edge.margin;
            if (edge.dx == 0.0) {
                if (at < 0.0) x1 = x0 - 1;
                continue;
            }
            // One texel more than division says, which rounds less.
            const double zero = std::clamp(-at / edge.dx, x0 - 2.0, x1 + 2.0);
            if (edge.dx > 0.0)
                x0 = std::max(x0, (int) std::floor(zero) - 1);
            else
                x1 = std::min(x1, (int) std::ceil(zero) + 1);
        }
    }

    /// 1: hit, -1: missed, 0: not certain.
    int at(int x, int y) const {
        int result = 1;
        for (const Edge& edge : edges_) {
            const double value = edge.first + y * edge.dy + x * edge.dx;
            if (value < -edge.margin) return -1;
            if (value <= edge.margin) result = 0;
        }
        return result;
    }

private:
    struct Edge {
        double first, dx, dy, margin;
    };
    std::array<Edge, 3> edges_;
};

void lower(float& texel, float depth) {
    std::atomic_ref<float> shared(texel);
    float now = shared.load(std::memory_order_relaxed);
    while (depth < now && !shared.compare_exchange_weak(now, depth, std::memory_order_relaxed)) {
    }
}

/// A triangle and the texels that it may cover.
struct Caster {
    uint32_t id;
    ivec4 texels;
};

class Raster {
public:
    Raster(const FrameGeometry& geometry, const GridSpotlight& light, const ShadowMap& map,
           std::vector<float>& depths)
        : geometry_(geometry), light_(light), map_(map), depths_(depths) {}

    /// Draws the rows from \p y0 to \p y1 of a triangle.
    void draw(const Caster& caster, int y0, int y1) const {
        const Triangle& triangle = geometry_.triangles[caster.id];
        const PlaneDistance plane(light_.position, triangle);
        if (plane.side() == 0) return; // edge-on
        const EdgeFunctions edges(triangle, light_, map_, plane.side());
        const bool holes = geometry_.mayHaveHoles(caster.id);
        for (int y = std::max(y0, caster.texels.y); y <= std::min(y1, caster.texels.w); ++y) {
            int x0 = caster.texels.x, x1 = caster.texels.z;
            edges.narrow(y, x0, x1);
            for (int x = x0; x <= x1; ++x) {
                const int inside = edges.at(x, y);
                if (inside < 0) continue;
                const Ray ray = rayThrough(light_, map_, (uint) x, (uint) y);
                float depth = 0.0f;
                const bool cast = inside > 0 && !holes
                                      ? plane.at(ray.direction, depth) && castsShadow(map_, depth)
                                      : casts(geometry_, map_, ray, caster.id, depth);
                if (cast) lower(depths_[(size_t) y * map_.resolution + (size_t) x], depth);
            }
        }
    }

private:
    const FrameGeometry& geometry_;
    const GridSpotlight& light_;
    const ShadowMap& map_;
    std::vector<float>& depths_;
};

} // namespace

float shadowDepth(const FrameGeometry& geometry, const GridSpotlight& light, const ShadowMap& map,
                  uint x, uint y) {
    const Ray ray = rayThrough(light, map, x, y);
    float nearest = kNothingCasts, depth = 0.0f;
    for (uint32_t id = 0; id < geometry.triangles.size(); ++id)
        if (casts(geometry, map, ray, id, depth)) nearest = std::min(nearest, depth);
    return nearest;
}

void rasterizeShadowMap(const FrameGeometry& geometry, const GridSpotlight& light,
                        const ShadowMap& map, Executor& executor, std::vector<float>& depths) {
    const auto side = (size_t) map.resolution;
    depths.assign(side * side, kNothingCasts);
    const Raster raster(geometry, light, map, depths);
    std::vector<Caster> large;
    std::mutex mutex;
    executor.forRange(geometry.triangles.size(), kDrawnAtOnce, [&](size_t begin, size_t end) {
        for (size_t id = begin; id < end; ++id) {
            const Triangle& t = geometry.triangles[id];
            Caster caster{(uint32_t) id, {}};
            ivec4& texels = caster.texels;
            if (!shadowFootprint(light, map, t.a, t.b, t.c, texels)) continue;
            const int64_t columns = texels.z - texels.x + 1, rows = texels.w - texels.y + 1;
            if (columns * rows <= kMostTexels) {
                raster.draw(caster, texels.y, texels.w);
                continue;
            }
            const std::lock_guard lock(mutex);
            large.push_back(caster);
        }
    });
    // In any order: a texel keeps the least of what all give it.
    executor.forRange(side, kBand, [&](size_t begin, size_t end) {
        for (const Caster& caster : large) raster.draw(caster, (int) begin, (int) end - 1);
    });
}

} // namespace dirt
