#include "backend_embree/filter.h"
#include "core/trace/holes.h"

namespace dirt {

namespace {

// Single rays only: N is 1 in every call.
QueryContext& query(const RTCFilterFunctionNArguments* args) {
    return *reinterpret_cast<QueryContext*>(args->context);
}

uint32_t candidate(const RTCFilterFunctionNArguments* args) {
    return RTCHitN_primID(args->hit, args->N, 0);
}

void reject(const RTCFilterFunctionNArguments* args) {
    args->valid[0] = 0;
}

bool skipped(const QueryContext& query, uint32_t primitive) {
    const uint32_t skip = query.ray->skip;
    const auto& triangles = query.geometry->triangles;
    return skip < triangles.size() &&
           (primitive == skip || sameVertices(triangles[primitive], triangles[skip]));
}

/// Core's verdict on the candidate.
bool accepted(const QueryContext& query, uint32_t primitive, TriangleHit& hit) {
    return !skipped(query, primitive) &&
           intersect(*query.ray, query.geometry->triangles[primitive], hit) &&
           isHit(*query.geometry, query.ray->direction, primitive, hit.u, hit.v);
}

} // namespace

void filterNearest(const RTCFilterFunctionNArguments* args) {
    QueryContext& q = query(args);
    const uint32_t primitive = candidate(args);
    TriangleHit hit;
    if (!accepted(q, primitive, hit)) return reject(args);
    Hit& best = q.best;
    if (best.found() && (hit.t > best.t || (hit.t == best.t && primitive > best.primitive)))
        return reject(args);
    best.primitive = primitive;
    best.t = hit.t, best.u = hit.u, best.v = hit.v;
    // Accepting shortens the ray to the tfar that is left here; the margin keeps ties in reach.
    RTCRayN_tfar(args->ray, args->N, 0) = best.t * q.unit * kLookBehind;
}

void filterOccluded(const RTCFilterFunctionNArguments* args) {
    TriangleHit hit;
    if (!accepted(query(args), candidate(args), hit) || !(hit.t < query(args).maxT)) reject(args);
}

void filterSkipped(const RTCFilterFunctionNArguments* args) {
    if (skipped(query(args), candidate(args))) reject(args);
}

} // namespace dirt
