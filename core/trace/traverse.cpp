#include "core/trace/traverse.h"

#include "core/trace/holes.h"
#include "core/trace/intersect.h"
#include "core/trace/plain_intersect.h"
#include "core/trace/ray_filter.h"
#include "core/trace/view_cone.h"
#include "core/trace/view_walk.h"
#include "shaders/shared/hit_rules.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <limits>

#include <glm/geometric.hpp>

namespace dirt {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Visits the tiles of all views in the order of t. Adds the cells looked at to \p steps.
template <class Visit>
void walkViews(const Grid& grid, const Ray& ray, const double& limit, uint64_t& steps,
               TraversalWatcher* watcher, Visit&& visit) {
    std::array<ViewSpan, 6> spans;
    int count = 0;
    for (size_t v = 0; v < grid.views.size(); ++v) {
        ViewSpan span;
        if (!ViewRay(grid.views[v], ray).clip((int) v, span)) continue;
        int i = count++;
        for (; i > 0 && span.begin < spans[i - 1].begin; --i) spans[i] = spans[i - 1];
        spans[i] = span;
    }

    const GridSettings& settings = grid.settings;
    const int top = settings.traversal == Traversal::linear ? 0
                    : settings.maxMip < 0                   ? std::numeric_limits<int>::max()
                                                            : settings.maxMip;
    const auto look = [&](const CellLook& cell) {
        ++steps;
        if (watcher) watcher->cell(cell);
    };
    for (int i = 0; i < count && spans[i].begin <= limit; ++i) {
        if (watcher) watcher->view(spans[i]);
        const ViewRay viewRay(grid.views[spans[i].view], ray);
        ViewWalk walk(viewRay, spans[i], grid.pyramids[spans[i].view], top);
        if (walk.valid()) walk.run(limit, look, visit);
    }
}

/// The bins of one tile that a ray passes, in the order of t.
struct BinRange {
    int first, last, step;

    BinRange(const Grid& grid, const Ray& ray, const TileVisit& visit, double limit)
        : bin_(grid.bounds(visit.view, visit.tile), grid.settings.bins), visit_(visit) {
        const View& view = grid.views[visit.view];
        originDepth_ = view.signW * ray.origin[view.axisW];
        depthPerT_ = view.signW * ray.direction[view.axisW];
        const bool receding = depthPerT_ >= 0.0;
        step = receding ? 1 : -1;
        first = bin_(receding ? visit.near : visit.far);
        last = bin_(receding ? visit.far : visit.near);
        shorten(limit);
    }

    bool contains(int b) const { return step > 0 ? b <= last : b >= last; }

    /// Leaves out the bins that the ray enters after t = \p limit.
    void shorten(double limit) {
        if (!(limit < visit_.end)) return;
        // Its roundings, 2^-52 of depths, are below what the limit lies beyond a hit (kFinality has
        // 2^-28 to spare), or else, where the depth hardly changes, below what lists exceed depths
        // by (kDepthMargin).
        const double depth = originDepth_ + limit * depthPerT_;
        last = step > 0 ? std::min(last, bin_(roundUp(depth)))
                        : std::max(last, bin_(roundDown(depth)));
    }

private:
    BinMap bin_;
    const TileVisit& visit_;
    double originDepth_, depthPerT_;
};

/// Whether the ray must not hit a triangle: the one it starts on, or one with the same vertices.
/// Asked of hits alone, so the comparison of vertices costs nothing.
bool isSkipped(const FrameGeometry& geometry, const Ray& ray, uint32_t id) {
    return ray.skip != kNoPrimitive &&
           (id == ray.skip || sameVertices(geometry.triangles[id], geometry.triangles[ray.skip]));
}

/// Where a ray may hit something: everywhere in full mode, up to the view's border in single mode.
ViewCone::Part seenPart(const Grid& grid, const Ray& ray) {
    if (grid.settings.mode == ViewMode::full) return {0.0f, FLT_MAX};
    return ViewCone(grid.views[0]).part(ray);
}

/// Whether the line of a ray that starts elsewhere passes through the eye, exactly: each component
/// of origin × direction is a difference of exact products, rounded once.
bool passesEye(const Ray& ray) {
    if (ray.origin == glm::vec3(0.0f)) return false; // meets nothing there
    return glm::cross(glm::dvec3(ray.origin), glm::dvec3(ray.direction)) == glm::dvec3(0.0);
}

/// The decision that the settings ask for.
class Decision {
public:
    Decision(const Grid& grid, const Ray& ray)
        : exact_(grid.settings.precision == Precision::exact), ray_(ray), filter_(ray) {}

    bool hits(const Triangle& triangle, TriangleHit& hit) const {
        if (!exact_) return plainIntersect(ray_, triangle, hit);
        return !filter_.certainlyMisses(triangle) && intersect(ray_, triangle, hit);
    }

private:
    bool exact_;
    const Ray& ray_;
    RayFilter filter_;
};

/// What is said against a triangle that the ray meets; nearest if nothing is.
Tested objection(const FrameGeometry& geometry, const Ray& ray, const ViewCone::Part& seen,
                 uint32_t id, const TriangleHit& hit) {
    if (!seen.holds(hit.t)) return Tested::outside;
    if (isSkipped(geometry, ray, id)) return Tested::skipped;
    if (!isHit(geometry, ray.direction, id, hit.u, hit.v)) return Tested::hole;
    return Tested::nearest;
}

} // namespace

Hit closestHit(const Grid& grid, const FrameGeometry& geometry, const Ray& given,
               TraversalCounts* counts, TraversalWatcher* watcher) {
    Hit best;
    const Ray ray = flushedRay(given);
    if (!isTraceable(ray)) return best;
    const Decision decision(grid, ray);
    const ViewCone::Part seen = seenPart(grid, ray);
    TraversalCounts local;
    double limit = kInfinity;

    const auto judge = [&](uint32_t id, TriangleHit& hit) {
        if (!decision.hits(geometry.triangles[id], hit)) return Tested::missed;
        if (best.primitive == id) return Tested::known;
        if (!isNearer(hit.t, id, best.t, best.primitive)) return Tested::farther;
        return objection(geometry, ray, seen, id, hit);
    };
    // Tests one triangle. True if it is the best hit, now or from before.
    const auto test = [&](uint32_t id) {
        ++local.tests;
        TriangleHit hit;
        const Tested result = judge(id, hit);
        if (watcher) watcher->test(id, result, hit);
        if (result == Tested::nearest) {
            best = {id, hit.t, hit.u, hit.v, 0, 0};
            limit = upperBound(hit.t);
        }
        return result == Tested::nearest || result == Tested::known;
    };

    if (!grid.atEye.empty() && passesEye(ray))
        for (uint32_t id : grid.atEye)
            if (test(id)) best.view = (uint32_t) grid.views.size();

    bool located = false; // best.view and best.tile hold best.t
    walkViews(grid, ray, limit, local.steps, watcher, [&](const TileVisit& visit) {
        ++local.tiles;
        BinRange bins(grid, ray, visit, limit);
        if (watcher) watcher->tile(visit, bins.first, bins.last);
        for (int b = bins.first; bins.contains(b); b += bins.step) {
            ++local.bins;
            const auto ids = grid.list(visit.view, visit.tile, b);
            if (watcher) watcher->bin(b, ids);
            for (uint32_t id : ids) {
                const uint32_t before = best.primitive;
                if (!test(id)) continue;
                if (best.primitive != before) {
                    bins.shorten(limit);
                    located = false;
                }
                // The record belongs to the tile in which the hit lies, among those that list it.
                if (!located) {
                    best.view = (uint32_t) visit.view;
                    best.tile = (uint32_t) visit.tile;
                    located = mayHold(visit.begin, visit.end, best.t);
                }
            }
        }
    });
    if (counts) *counts = local;
    return best;
}

bool anyHit(const Grid& grid, const FrameGeometry& geometry, const Ray& given, float maxT,
            TraversalCounts* counts, TraversalWatcher* watcher) {
    const Ray ray = flushedRay(given);
    if (!isTraceable(ray) || !(maxT > 0.0f)) return false;
    const Decision decision(grid, ray);
    const ViewCone::Part seen = seenPart(grid, ray);
    TraversalCounts local;
    double limit = upperBound(maxT);
    bool found = false;

    const auto judge = [&](uint32_t id, TriangleHit& hit) {
        if (!decision.hits(geometry.triangles[id], hit)) return Tested::missed;
        if (!(hit.t < maxT)) return Tested::farther;
        return objection(geometry, ray, seen, id, hit);
    };
    const auto test = [&](uint32_t id) {
        ++local.tests;
        TriangleHit hit;
        const Tested result = judge(id, hit);
        if (watcher) watcher->test(id, result, hit);
        if (result == Tested::nearest) {
            found = true;
            limit = -1.0; // ends the walk
        }
        return found;
    };

    if (!grid.atEye.empty() && passesEye(ray))
        for (uint32_t id : grid.atEye)
            if (test(id)) break;
    walkViews(grid, ray, limit, local.steps, watcher, [&](const TileVisit& visit) {
        ++local.tiles;
        const BinRange bins(grid, ray, visit, limit);
        if (watcher) watcher->tile(visit, bins.first, bins.last);
        for (int b = bins.first; !found && bins.contains(b); b += bins.step) {
            ++local.bins;
            const auto ids = grid.list(visit.view, visit.tile, b);
            if (watcher) watcher->bin(b, ids);
            for (uint32_t id : ids)
                if (test(id)) break;
        }
    });
    if (counts) *counts = local;
    return found;
}

void visitCells(const Grid& grid, const Ray& given,
                const std::function<void(int view, int tile, int bin)>& visit) {
    const Ray ray = flushedRay(given);
    if (!isTraceable(ray)) return;
    const double limit = kInfinity;
    uint64_t steps = 0;
    walkViews(grid, ray, limit, steps, nullptr, [&](const TileVisit& tile) {
        const BinRange bins(grid, ray, tile, limit);
        for (int b = bins.first; bins.contains(b); b += bins.step) visit(tile.view, tile.tile, b);
    });
}

Hit closestHitBruteForce(const FrameGeometry& geometry, const Ray& given) {
    Hit best;
    const Ray ray = flushedRay(given);
    if (!isTraceable(ray)) return best;
    for (uint32_t id = 0; id < geometry.triangles.size(); ++id) {
        TriangleHit candidate;
        if (intersect(ray, geometry.triangles[id], candidate) &&
            isNearer(candidate.t, id, best.t, best.primitive) && !isSkipped(geometry, ray, id) &&
            isHit(geometry, ray.direction, id, candidate.u, candidate.v))
            best = {id, candidate.t, candidate.u, candidate.v, 0, 0};
    }
    return best;
}

} // namespace dirt
