// What a ray of trace.comp searches for and has found so far: the nearest hit, or (DIRT_ANY_HIT 1)
// any hit.

#include "include/triangles.glsl"
#include "include/view_cone.glsl"
#include "shared/hit_rules.h"
#if DIRT_CUT_OUTS
#include "include/holes.glsl"
#endif

layout(location = 2) uniform bool single; // rays end at the border of the only view

/// What is known of the ray so far.
struct Search {
    Ray ray;
    RayFilter sieve;
    float seenBegin, seenEnd; // where something may be hit
    float maxT;
    double limit; // nothing that begins later matters
    Hit best;
    bool located; // best.view and best.tile hold best.t
};

/// Whether it has the vertices of the triangle to skip.
bool isSkipped(Ray ray, Triangle triangle) {
    return ray.skip != kNoPrimitive && sameVertices(triangle, triangleOf(ray.skip));
}

/// A triangle that may be hit, and has to be decided.
struct Candidate {
    uint id; // kNoPrimitive: none
    Triangle triangle;
};

Candidate noCandidate() {
    Candidate none;
    none.id = kNoPrimitive;
    return none;
}

/// Whether to look at a triangle more closely. It has been hit before, or is not cheaply refused.
bool isWorthTesting(Search search, inout Candidate candidate) {
    if (candidate.id == search.best.primitive) return true;
    if (candidate.id == search.ray.skip) return false;
    candidate.triangle = triangleOf(candidate.id);
    return !certainlyMisses(search.sieve, search.ray, candidate.triangle);
}

/// Tests one triangle. True if it is the best hit, now or from before.
bool test(inout Search search, Candidate candidate) {
    if (candidate.id == search.best.primitive) return true;
    TriangleHit hit;
    if (!intersect(search.ray, candidate.triangle, hit)) return false;
    if (!isNearer(hit.t, candidate.id, search.best.t, search.best.primitive) ||
        hit.t < search.seenBegin || hit.t > search.seenEnd ||
        isSkipped(search.ray, candidate.triangle))
        return false;
#if DIRT_ANY_HIT
    if (!(hit.t < search.maxT)) return false;
#endif
#if DIRT_CUT_OUTS
    if (!isHit(search.ray.direction, candidate.id, hit.u, hit.v)) return false;
#endif
#if DIRT_ANY_HIT
    search.limit = -1.0LF; // ends the walk
#else
    search.limit = upperBound(hit.t);
#endif
    search.best.primitive = candidate.id;
    search.best.t = hit.t;
    search.best.u = hit.u;
    search.best.v = hit.v;
    search.located = false;
    return true;
}

Search makeSearch(RayRecord given) {
    Search search;
    search.best = kNoHit;
    search.ray = Ray(flushed(given.origin), flushed(given.direction), given.skip);
    search.maxT = given.maxT;
    search.sieve = makeFilter(search.ray);
    search.located = false;
    search.seenBegin = 0.0;
    search.seenEnd = kLargest;
    if (single) {
        vec2 part = partInView(search.ray);
        search.seenBegin = part.x;
        search.seenEnd = part.y;
    }
#if DIRT_ANY_HIT
    search.limit = upperBound(given.maxT);
#else
    search.limit = infinity();
#endif
    return search;
}
