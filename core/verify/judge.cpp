#include "core/verify/judge.h"

#include "core/trace/holes.h"
#include "core/trace/intersect.h"
#include "core/verify/exact.h"
#include "core/verify/filter.h"
#include "shaders/shared/margins.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

namespace dirt {

namespace {

bool isOrdinary(const Ray& ray) {
    for (int i = 0; i < 3; i++)
        if (!std::isfinite(ray.origin[i]) || !std::isfinite(ray.direction[i])) return false;
    return ray.direction.x != 0.0f || ray.direction.y != 0.0f || ray.direction.z != 0.0f;
}

using Point = std::tuple<float, float, float>;

std::array<Point, 3> sortedVertices(const Triangle& t) {
    std::array<Point, 3> points;
    const glm::vec3 vertices[3] = {t.a, t.b, t.c};
    // Adding zero makes -0 and 0 the same.
    for (int i = 0; i < 3; i++)
        points[i] = {vertices[i].x + 0.0f, vertices[i].y + 0.0f, vertices[i].z + 0.0f};
    std::sort(points.begin(), points.end());
    return points;
}

} // namespace

Judge::Judge(const FrameGeometry& geometry)
    : geometry_(geometry), boxes_(geometry.triangles), all_(geometry.triangles.size()) {
    std::iota(all_.begin(), all_.end(), 0u);
}

bool Judge::skipped(const Ray& ray, uint32_t primitive) const {
    if (ray.skip >= geometry_.triangles.size()) return false;
    return primitive == ray.skip || sortedVertices(geometry_.triangles[primitive]) ==
                                        sortedVertices(geometry_.triangles[ray.skip]);
}

bool Judge::inHole(const Ray& ray, uint32_t primitive) const {
    TriangleHit hit;
    return geometry_.cutOuts && intersect(ray, geometry_.triangles[primitive], hit) &&
           !isHit(geometry_, ray.direction, primitive, hit.u, hit.v);
}

Verdict Judge::nearest(const Ray& ray) const {
    if (!isOrdinary(ray)) return {};
    std::vector<uint32_t> candidates;
    boxes_.candidates(ray, candidates);
    return decide(ray, candidates);
}

Verdict Judge::nearestOfAll(const Ray& ray) const {
    return isOrdinary(ray) ? decide(ray, all_) : Verdict{};
}

Verdict Judge::decide(const Ray& ray, std::span<const uint32_t> candidates) const {
    struct Survivor {
        double tLow;
        uint32_t primitive;
    };
    std::vector<Survivor> survivors;
    for (const uint32_t primitive : candidates) {
        const FilterResult filtered = filterTriangle(ray, geometry_.triangles[primitive]);
        if (filtered.possible) survivors.push_back({filtered.tLow, primitive});
    }
    std::sort(survivors.begin(), survivors.end(), [](const Survivor& l, const Survivor& r) {
        return std::tie(l.tLow, l.primitive) < std::tie(r.tLow, r.primitive);
    });

    Verdict verdict;
    ExactT nearest;
    for (const Survivor& survivor : survivors) {
        // verdict.t may be too small by its rounding; nothing that ties may be left out.
        if (verdict.found() && survivor.tLow > verdict.t * (1.0 + 0x1p-49)) break;
        if (skipped(ray, survivor.primitive) || inHole(ray, survivor.primitive)) continue;
        const auto t = intersectExactly(ray, geometry_.triangles[survivor.primitive]);
        if (!t || (verdict.found() && nearest < *t)) continue;
        if (!verdict.found() || *t < nearest) {
            verdict.primitives.clear();
            nearest = *t;
            verdict.t = t->toDouble();
        }
        verdict.primitives.push_back(survivor.primitive);
    }
    std::sort(verdict.primitives.begin(), verdict.primitives.end());
    return verdict;
}

Judgement Judge::judge(const Ray& ray, const Verdict& truth, const Hit& hit) const {
    if (!hit.found()) return {truth.found() ? Grade::missed : Grade::right};
    if (!truth.found()) return {Grade::falseHit};
    if (hit.primitive >= geometry_.triangles.size() || skipped(ray, hit.primitive) ||
        inHole(ray, hit.primitive))
        return {Grade::wrongPrimitive};
    const auto t = intersectExactly(ray, geometry_.triangles[hit.primitive]);
    if (!t) return {Grade::wrongPrimitive};

    Judgement judgement{Grade::right, relativeError(hit.t, *t), ulpError(hit.t, *t)};
    if (!std::binary_search(truth.primitives.begin(), truth.primitives.end(), hit.primitive)) {
        const auto nearest = intersectExactly(ray, geometry_.triangles[truth.primitives[0]]);
        if (exceeds(*t, *nearest, kRelativeErrorT) && !beyondFloats(*t, *nearest))
            judgement.grade = Grade::wrongPrimitive;
    }
    return judgement;
}

} // namespace dirt
