#include "backend_cpu/trace/tracer.h"

#include "core/trace/holes.h"
#include "core/trace/intersect.h"
#include "core/trace/plain_intersect.h"
#include "shaders/shared/hit_rules.h"

#include <array>
#include <cfloat>

// Compiles what follows once for each instruction set that Highway knows on this architecture.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "backend_cpu/trace/tracer.cpp"
#include <hwy/foreach_target.h>

#include "backend_cpu/light/light_test-inl.h"
#include "backend_cpu/trace/leaf_test-inl.h"
#include "backend_cpu/trace/tile_walk-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

/// The decision that the settings ask for.
inline bool decide(const LeafTracer& tracer, const Ray& ray, const Triangle& triangle,
                   TriangleHit& hit) {
    return tracer.grid.settings.precision == Precision::exact ? intersect(ray, triangle, hit)
                                                              : plainIntersect(ray, triangle, hit);
}

/// Asked before the exact decision, which takes longest where a ray starts: on its own triangle.
inline bool skips(const FrameGeometry& geometry, const Ray& ray, uint32_t id,
                  const Triangle& other) {
    if (ray.skip == kNoPrimitive) return false;
    if (id == ray.skip) return true;
    const Triangle& own = geometry.triangles[ray.skip];
    const bool shared = own.a == other.a || own.a == other.b || own.a == other.c;
    return shared && sameVertices(own, other);
}

/// One ray on its way through the leaves. \p Query says what becomes of a triangle that may be hit.
template <class Query>
class Traversal {
public:
    Traversal(const LeafTracer& tracer, const Ray& ray, Query& query, LeafCounts& counts)
        : tracer_(tracer), ray_(ray), query_(query), counts_(counts) {}

    /// False if the ray has to be left to core.
    bool run() {
        if (!leafRay_.set(ray_)) return false;
        ViewParts parts;
        if (!parts.set(tracer_.viewTable, ray_)) return false;
        for (int i = 0; i < parts.count; ++i) {
            const ViewPart& part = parts.part[i];
            const TracedView& view = tracer_.views[part.view];
            if (!(part.begin <= query_.limit)) break;
            walkTiles(view, part, query_.limit, counts_.steps,
                      [&](const Visit& visit) HWY_ATTR { visitTile(view, part, visit); });
        }
        return true;
    }

private:
    HWY_INLINE void visitTile(const TracedView& view, const ViewPart& part, const Visit& visit) {
        ++counts_.tiles;
        query_.enter(visit.begin, visit.end, part.view, visit.tile);
        leafRay_.setPart(visit.begin, std::min(visit.end, query_.limit));
        const uint32_t root = view.depths[visit.tile].root;
        if ((root & TileDepths::kBlock) != 0)
            testBlock(root & ~TileDepths::kBlock, visit);
        else
            testNode(tracer_.leaves.nodes[root], visit);
    }

    /// Most of the time of a test is that of its first miss in the caches.
    HWY_INLINE void prefetchChild(const LeafNode& node, int child) const {
        const Leaves& leaves = tracer_.leaves;
        const bool inner = child < node.nodes;
        const auto* const lines =
            inner ? reinterpret_cast<const char*>(&leaves.nodes[node.firstNode + child])
                  : reinterpret_cast<const char*>(
                        &leaves.blocks[node.firstBlock + child - node.nodes]);
        hwy::Prefetch(lines);
        hwy::Prefetch(lines + 64);
        if (!inner) hwy::Prefetch(lines + 128);
    }

    void testNode(const LeafNode& node, const Visit& visit) {
        ++counts_.nodes;
        HWY_ALIGN float entry[LeafNode::kChildren];
        uint32_t met = childrenMet(leafRay_, node, entry);
        for (uint32_t rest = met; rest != 0; rest &= rest - 1)
            prefetchChild(node, (int) hwy::Num0BitsBelowLS1Bit_Nonzero32(rest));
        while (met != 0) {
            // The nearest that is left; most often there are one or two.
            int child = hwy::Num0BitsBelowLS1Bit_Nonzero32(met);
            for (uint32_t rest = met & (met - 1); rest != 0; rest &= rest - 1) {
                const int other = hwy::Num0BitsBelowLS1Bit_Nonzero32(rest);
                if (entry[other] < entry[child]) child = other;
            }
            if (entry[child] > leafRay_.end) return;
            met &= ~(1u << child);
            if (child < node.nodes)
                testNode(tracer_.leaves.nodes[node.firstNode + child], visit);
            else
                testBlock(node.firstBlock + child - node.nodes, visit);
        }
    }

    void testBlock(uint32_t index, const Visit& visit) {
        ++counts_.blocks;
        const LeafBlock& block = tracer_.leaves.blocks[index];
        const Triangle* const triangles = tracer_.geometry.triangles.data();
        HWY_ALIGN float entry[LeafNode::kChildren];
        uint32_t met = childrenMet(leafRay_, block, entry);
        if (met == 0) return;
        for (uint32_t rest = met; rest != 0; rest &= rest - 1)
            hwy::Prefetch(&triangles[block.id[hwy::Num0BitsBelowLS1Bit_Nonzero32(rest)]]);
        for (; met != 0; met &= met - 1) {
            const size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(met);
            const uint32_t id = block.id[lane];
            if (id == ray_.skip || entry[lane] > leafRay_.end) continue;
            ++counts_.triangles;
            if (!leafRay_.mayHit(triangles[id])) continue;
            query_.test(id, triangles[id], counts_);
            leafRay_.setEnd(std::min(visit.end, query_.limit));
        }
    }

    const LeafTracer& tracer_;
    const Ray& ray_;
    Query& query_;
    LeafCounts& counts_;
    LeafRay leafRay_;
};

/// T3: the nearest hit, at equal t the lowest id, filed under a tile in which it lies.
class NearestQuery {
public:
    NearestQuery(const LeafTracer& tracer, const Ray& ray) : tracer_(tracer), ray_(ray) {
        if (tracer.cone) seen_ = tracer.cone->part(ray);
    }

    void enter(double begin, double end, int view, int tile) {
        begin_ = begin, end_ = end, view_ = view, tile_ = tile;
    }

    void test(uint32_t id, const Triangle& triangle, LeafCounts& counts) {
        if (id != best.primitive) {
            if (skips(tracer_.geometry, ray_, id, triangle)) return;
            ++counts.exact;
            TriangleHit hit;
            if (!decide(tracer_, ray_, triangle, hit)) return;
            if (!isNearer(hit.t, id, best.t, best.primitive) || !seen_.holds(hit.t) ||
                !isHit(tracer_.geometry, ray_.direction, id, hit.u, hit.v))
                return;
            best = {id, hit.t, hit.u, hit.v, 0, 0};
            limit = upperBound(hit.t);
            located_ = false;
        }
        if (located_) return;
        best.view = (uint32_t) view_;
        best.tile = (uint32_t) tile_;
        located_ = mayHold(begin_, end_, best.t);
    }

    Hit best;
    double limit = kForever;

private:
    const LeafTracer& tracer_;
    const Ray& ray_;
    ViewCone::Part seen_{0.0f, FLT_MAX};
    bool located_ = false; ///< best's view and tile hold its t
    double begin_ = 0.0, end_ = 0.0;
    int view_ = 0, tile_ = 0;
};

class AnyQuery {
public:
    AnyQuery(const LeafTracer& tracer, const Ray& ray, float maxT)
        : limit(upperBound(maxT)), tracer_(tracer), ray_(ray), maxT_(maxT) {
        if (tracer.cone) seen_ = tracer.cone->part(ray);
    }

    void enter(double, double, int, int) {}

    void test(uint32_t id, const Triangle& triangle, LeafCounts& counts) {
        if (found || skips(tracer_.geometry, ray_, id, triangle)) return;
        ++counts.exact;
        TriangleHit hit;
        if (decide(tracer_, ray_, triangle, hit) && hit.t < maxT_ && seen_.holds(hit.t) &&
            isHit(tracer_.geometry, ray_.direction, id, hit.u, hit.v)) {
            found = true;
            limit = -1.0; // ends everything
        }
    }

    /// A triangle that is hit beyond doubt between the origin and t = 1.
    void testCertain(uint32_t id, LeafCounts& counts) {
        const bool whole = maxT_ >= 1.0f && !tracer_.cone && !tracer_.geometry.cutOuts;
        if (!whole)
            test(id, tracer_.geometry.triangles[id], counts);
        else if (!skips(tracer_.geometry, ray_, id, tracer_.geometry.triangles[id]))
            found = true;
    }

    bool found = false;
    double limit;

private:
    const LeafTracer& tracer_;
    const Ray& ray_;
    float maxT_;
    ViewCone::Part seen_{0.0f, FLT_MAX};
};

void Closest(const LeafTracer& tracer, std::span<const Ray> rays, std::span<Hit> hits,
             LeafCounts& counts) {
    for (size_t i = 0; i < rays.size(); ++i) {
        const Ray ray = flushedRay(rays[i]);
        if (ray.skip != kNoPrimitive) hwy::Prefetch(&tracer.geometry.triangles[ray.skip]);
        hits[i] = {};
        if (!isTraceable(ray)) continue;
        NearestQuery query(tracer, ray);
        if (Traversal(tracer, ray, query, counts).run()) {
            hits[i] = query.best;
        } else {
            ++counts.scalar;
            hits[i] = closestHit(tracer.grid, tracer.geometry, ray);
        }
    }
}

bool OccludedInLeaves(const LeafTracer& tracer, const Ray& ray, float maxT, LeafCounts& counts) {
    AnyQuery query(tracer, ray, maxT);
    if (Traversal(tracer, ray, query, counts).run()) return query.found;
    ++counts.scalar;
    return anyHit(tracer.grid, tracer.geometry, ray, maxT);
}

/// The ray from the light's point of view: one list.
bool OccludedFromLight(const LeafTracer& tracer, const LightRay& seen, LightCandidates& candidates,
                       const Ray& ray, float maxT, LeafCounts& counts) {
    const LightGrid& grid = *tracer.light;
    AnyQuery query(tracer, ray, maxT);
    ++counts.lookups;
    const auto& triangles = tracer.geometry.triangles;
    for (const uint32_t id : grid.close) query.test(id, triangles[id], counts);
    for (;; candidates.find(grid, seen)) {
        for (size_t i = 0; i < candidates.count && !query.found; ++i) {
            const uint32_t id = candidates.id[i];
            if (id == ray.skip) continue;
            ++counts.listed;
            switch (testRecord(grid.records[id], seen)) {
            case LightTest::misses:
                break;
            case LightTest::mayHit:
                query.test(id, triangles[id], counts);
                break;
            case LightTest::hits:
                query.testCertain(id, counts);
                break;
            }
        }
        if (query.found || candidates.next == candidates.end) return query.found;
    }
}

/// Rays of a group are looked up step by step together: what one of them waits for, the caches
/// bring meanwhile.
inline constexpr size_t kLightGroup = 16;

void Occluded(const LeafTracer& tracer, std::span<const Ray> rays, std::span<const float> maxT,
              std::span<uint8_t> result, LeafCounts& counts) {
    LightRay seen[kLightGroup];
    LightCandidates candidates[kLightGroup];
    Ray flushed[kLightGroup];
    for (size_t first = 0; first < rays.size(); first += kLightGroup) {
        const size_t count = std::min(kLightGroup, rays.size() - first);
        for (size_t i = 0; i < count; ++i) {
            flushed[i] = flushedRay(rays[first + i]);
            if (!tracer.light) continue;
            seen[i].set(*tracer.light, flushed[i], maxT[first + i]);
            if (flushed[i].skip != kNoPrimitive)
                hwy::Prefetch(&tracer.geometry.triangles[flushed[i].skip]);
        }
        for (size_t i = 0; i < count; ++i)
            if (seen[i].looksUp()) candidates[i].start(*tracer.light, seen[i]);
        for (size_t i = 0; i < count; ++i)
            if (seen[i].looksUp()) candidates[i].find(*tracer.light, seen[i]);
        for (size_t i = 0; i < count; ++i) {
            const Ray& ray = flushed[i];
            const float end = maxT[first + i];
            bool occluded = false;
            if (isTraceable(ray) && end > 0.0f)
                occluded = seen[i].looksUp()
                               ? OccludedFromLight(tracer, seen[i], candidates[i], ray, end, counts)
                               : OccludedInLeaves(tracer, ray, end, counts);
            result[first + i] = occluded;
        }
    }
}

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dirt {

HWY_EXPORT(Closest);
HWY_EXPORT(Occluded);

LeafTracer::LeafTracer(const FrameGeometry& geometry, const Grid& grid, const Leaves& leaves,
                       const LightGrid* light)
    : geometry(geometry), grid(grid), leaves(leaves),
      light(light && !light->empty() ? light : nullptr) {
    const GridSettings& settings = grid.settings;
    for (size_t v = 0; v < grid.views.size(); ++v) {
        const View& view = grid.views[v];
        const auto tilesPerSlope = [&](int pixels, const std::vector<float>& borders) {
            return pixels / ((double) settings.tile * ((double) borders.back() - borders.front()));
        };
        views.push_back({{view.columns, view.rows},
                         {view.s.data(), view.t.data()},
                         {tilesPerSlope(view.width, view.s), tilesPerSlope(view.height, view.t)},
                         leaves.tiles.data() + grid.firstTile[v]});
    }
    for (size_t lane = 0; lane < ViewTable::kLanes; ++lane) {
        const View& view = grid.views[std::min(lane, grid.views.size() - 1)];
        const int axes[3] = {view.axisX, view.axisY, view.axisW};
        for (int i = 0; i < 3; ++i) {
            viewTable.axis[i][lane] = axes[i];
            viewTable.sign[i][lane] = i == 2 ? view.signW : 1.0;
        }
        viewTable.rim[0][0][lane] = view.s.front(), viewTable.rim[0][1][lane] = view.s.back();
        viewTable.rim[1][0][lane] = view.t.front(), viewTable.rim[1][1][lane] = view.t.back();
        const double rim = std::min(view.s.back(), view.t.back());
        viewTable.nearest[lane] = kNearestWalked * std::max(1.0, 1.0 / rim);
        // In full mode a part of one point is the begin or end of a neighbour's.
        viewTable.atLeast[lane] = lane >= grid.views.size()         ? HUGE_VAL
                                  : settings.mode == ViewMode::full ? 0.0
                                                                    : -1.0;
    }
    if (settings.mode == ViewMode::single) cone.emplace(grid.views[0]);
}

void LeafTracer::closest(std::span<const Ray> rays, std::span<Hit> hits, LeafCounts* counts) const {
    LeafCounts local;
    HWY_DYNAMIC_DISPATCH(Closest)(*this, rays, hits, local);
    if (counts) *counts = local;
}

void LeafTracer::occluded(std::span<const Ray> rays, std::span<const float> maxT,
                          std::span<uint8_t> result, LeafCounts* counts) const {
    LeafCounts local;
    HWY_DYNAMIC_DISPATCH(Occluded)(*this, rays, maxT, result, local);
    if (counts) *counts = local;
}

} // namespace dirt
#endif // HWY_ONCE
