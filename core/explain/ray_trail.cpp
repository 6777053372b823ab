#include "core/explain/ray_trail.h"

#include "core/trace/determinant.h"
#include "core/trace/ray_filter.h"

#include <algorithm>

namespace dirt {

namespace {

/// Writes down what a traversal says.
class Recorder final : public TraversalWatcher {
public:
    Recorder(const Grid& grid, const FrameGeometry& geometry, RayTrail& trail)
        : grid_(grid), geometry_(geometry), trail_(trail) {}

    void view(const ViewSpan& span) override { trail_.views.push_back({span, {}, {}}); }
    void cell(const CellLook& look) override { trail_.views.back().cells.push_back(look); }
    void tile(const TileVisit& visit, int first, int last) override {
        const int columns = grid_.views[(size_t) visit.view].columns;
        trail_.views.back().tiles.push_back({visit,
                                             visit.tile % columns,
                                             visit.tile / columns,
                                             grid_.bounds(visit.view, visit.tile),
                                             first,
                                             last,
                                             {}});
    }
    void bin(int bin, std::span<const uint32_t> ids) override {
        trail_.views.back().tiles.back().bins.push_back({bin, ids.size(), {}});
    }
    void test(uint32_t id, Tested result, const TriangleHit& hit) override {
        TriangleTrail tested{id, result, hit, {}};
        if (result == Tested::missed)
            tested.refusal =
                refusalOf(trail_.ray, geometry_.triangles[id], grid_.settings.precision);
        (trail_.views.empty() ? trail_.atEye
                              : trail_.views.back().tiles.back().bins.back().triangles)
            .push_back(tested);
    }

private:
    const Grid& grid_;
    const FrameGeometry& geometry_;
    RayTrail& trail_;
};

} // namespace

Refusal refusalOf(const Ray& given, const Triangle& triangle, Precision precision) {
    using Reason = Refusal::Reason;
    const Ray ray = flushedRay(given);
    Refusal refusal;
    refusal.a = signOf(edgeDeterminantExact(ray.origin, ray.direction, triangle.b, triangle.c));
    refusal.b = signOf(edgeDeterminantExact(ray.origin, ray.direction, triangle.c, triangle.a));
    refusal.c = signOf(edgeDeterminantExact(ray.origin, ray.direction, triangle.a, triangle.b));
    if (precision == Precision::fast) {
        refusal.reason = Reason::floatTest;
        return refusal;
    }
    const int least = std::min({refusal.a, refusal.b, refusal.c});
    const int most = std::max({refusal.a, refusal.b, refusal.c});
    TriangleHit hit;
    if (RayFilter(ray).certainlyMisses(triangle))
        refusal.reason = Reason::filter;
    else if (intersect(ray, triangle, hit))
        refusal.reason = Reason::none;
    else if (least < 0 && most > 0)
        refusal.reason = Reason::beside;
    else if (directionSide(ray.direction, triangle.a, triangle.b, triangle.c) == 0)
        refusal.reason = Reason::inPlane;
    else
        refusal.reason = Reason::behind;
    return refusal;
}

RayTrail closestTrail(const Grid& grid, const FrameGeometry& geometry, const Ray& ray) {
    RayTrail trail;
    trail.ray = ray;
    Recorder recorder(grid, geometry, trail);
    trail.hit = closestHit(grid, geometry, ray, &trail.counts, &recorder);
    return trail;
}

RayTrail anyTrail(const Grid& grid, const FrameGeometry& geometry, const Ray& ray, float maxT) {
    RayTrail trail;
    trail.ray = ray;
    trail.maxT = maxT;
    Recorder recorder(grid, geometry, trail);
    trail.blocked = anyHit(grid, geometry, ray, maxT, &trail.counts, &recorder);
    return trail;
}

} // namespace dirt
