#version 450 core
// Trace and Visibility: nearest hits of rays, or (DIRT_ANY_HIT 1) whether they hit anything. The
// traversal of core/trace/traverse.cpp, as a sequence of small turns that can be interrupted: a
// driver may stop a shader that runs for long, and llvmpipe (Mesa 22.3) silently leaves all loops
// once a shader has gone round 65535 times in all. So a ray keeps its state between dispatches.

#include "include/triangles.glsl"
#include "include/view_cone.glsl"
#include "include/view_walk.glsl"
#include "include/bins.glsl"
#include "include/plain_intersect.glsl"
#include "include/nodes.glsl"
#include "include/ray_record.glsl"
#include "shared/layouts.h"
#if DIRT_CUT_OUTS
#include "include/materials.glsl"
#endif

layout(local_size_x = 64) in;

/// Where a ray's search stands.
struct State {
    int phase;
    uint pendingViews;
    int view, level;
    uint at;  // kEye: place in the list; kList: node
    ivec2 tile;
    uvec2 begin, depth; // doubles
    int bin;
    uint located;
};

layout(std430, binding = DIRT_SEGMENTS) readonly buffer Rays {
#if DIRT_PATHS
    PathRay rays[];
#else
    RayRecord rays[];
#endif
};
layout(std430, binding = DIRT_SEGMENTS + 1) buffer Hits {
    Hit hits[];
};
layout(std430, binding = DIRT_SEGMENTS + 2) buffer States {
    uint unfinished; // rays that need another dispatch,
    uint cut;        // of these, those whose loops were cut short: they stay as they were
    uint traced;     // rays that have a direction
    uint found;      // of these, those that have hit something
    State states[];
};
layout(binding = 4) uniform usampler2DArray headTexture;
layout(binding = 5) uniform usamplerBuffer atEye;
#if DIRT_PATHS
layout(binding = 8) uniform usamplerBuffer mask; // of all pixels
#endif

layout(location = 0) uniform uint count;
layout(location = 1) uniform int topLevel;
layout(location = 2) uniform bool single; // rays end at the border of the only view
layout(location = 3) uniform int atEyeCount;
layout(location = 4) uniform uint turns; // of one dispatch
layout(location = 5) uniform uint probe; // any number above 1
layout(location = 6) uniform bool masked; // paths: only those that the mask leaves alive
layout(location = 7) uniform uint firstPixel; // paths: that of the first ray

// What a turn does; a ray begins with the first.
const int kBegin = 0, kEye = 1, kNextView = 2, kStep = 3, kLeave = 4, kList = 5, kDone = 6;

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

/// No candidate whose computed t is at most t has an exact t above this.
double upperBound(float t) {
    precise double bound =
        double(t) * (1.0LF + double(2.0 * kRelativeErrorT)) + double(kSmallestNormal);
    return bound;
}

bool isSkipped(Ray ray, uint id, Triangle triangle) {
    return ray.skip != kNoPrimitive &&
           (id == ray.skip || sameVertices(triangle, triangleOf(ray.skip)));
}

/// Tests one triangle. True if it is the best hit, now or from before.
bool test(inout Search search, uint id) {
    Triangle triangle = triangleOf(id);
    TriangleHit hit;
#if DIRT_EXACT
    if (certainlyMisses(search.sieve, search.ray, triangle) ||
        !intersect(search.ray, triangle, hit))
        return false;
#else
    if (!plainIntersect(search.ray, triangle, hit)) return false;
#endif
    if (search.best.primitive == id) return true;
    bool nearer = search.best.primitive == kNoPrimitive || hit.t < search.best.t ||
                  (hit.t == search.best.t && id < search.best.primitive);
    if (!nearer || hit.t < search.seenBegin || hit.t > search.seenEnd ||
        isSkipped(search.ray, id, triangle))
        return false;
#if DIRT_ANY_HIT
    if (!(hit.t < search.maxT)) return false;
#endif
#if DIRT_CUT_OUTS
    if (!isThere(id, hit.u, hit.v)) return false;
#endif
#if DIRT_ANY_HIT
    search.limit = -1.0LF; // ends the walk
#else
    search.limit = upperBound(hit.t);
#endif
    search.best.primitive = id;
    search.best.t = hit.t;
    search.best.u = hit.u;
    search.best.v = hit.v;
    search.located = false;
    return true;
}

/// The last bin that the ray enters before search.limit.
int lastBin(Search search, BinMap map, int view, TileVisit visit, bool receding, int last) {
    if (!(search.limit < visit.end)) return last;
    double origin = double(toView(view, search.ray.origin).z);
    precise double growth = search.limit * double(toView(view, search.ray.direction).z);
    precise double depth = origin + growth;
    precise double error = powerOfTwo(-51) * (abs(origin) + abs(growth));
    precise double beyond = receding ? depth + error : depth - error;
    return receding ? min(last, binOf(map, roundUp(beyond), grid.bins))
                    : max(last, binOf(map, roundDown(beyond), grid.bins));
}

uint headOf(int view, ivec2 tile, int bin) {
    return texelFetch(headTexture, ivec3(tile, view * grid.bins + bin), 0).x;
}

/// A search in a view, in the midst of it.
struct Walker {
    ViewWalk walk;
    int phase, level;
    uint pendingViews, at;
    Exit exit;
    bool empty; // the cell's depth bounds do not meet the ray's depths
    TileVisit visit;
    BinMap map;
    int bin, last;
    bool receding;
};

void examineCell(inout Walker w) {
    w.exit = exitOf(w.walk, w.level);
    double near = min(w.walk.depth, w.exit.near), far = max(w.walk.depth, w.exit.far);
    vec2 bounds = texelFetch(pyramid, ivec3(w.walk.tile >> w.level, w.walk.view), w.level).xy;
    precise double low = near * (1.0LF - kDepthSlack);
    precise double high = far * (1.0LF + kDepthSlack);
    w.empty = double(bounds.y) < low || double(-bounds.x) > high; // bounds: (-near, far)
}

/// Offers the tile of the walk. True if it is to be visited.
bool openTile(inout Walker w, Search search) {
    if (!offerTile(w.walk, w.exit, w.visit)) return false;
    vec2 bounds = texelFetch(pyramid, ivec3(w.walk.tile, w.walk.view), 0).xy;
    w.map = binMap(vec2(-bounds.x, bounds.y), grid.bins);
    w.receding = toView(w.walk.view, search.ray.direction).z >= 0.0;
    w.bin = binOf(w.map, w.receding ? w.visit.near : w.visit.far, grid.bins);
    w.last = binOf(w.map, w.receding ? w.visit.far : w.visit.near, grid.bins);
    w.last = lastBin(search, w.map, w.walk.view, w.visit, w.receding, w.last);
    return true;
}

/// Tests one entry of the list, which the tile of the visit has.
void testEntry(inout Walker w, inout Search search, uint id) {
    uint before = search.best.primitive;
    if (!test(search, id)) return;
    if (search.best.primitive != before)
        w.last = lastBin(search, w.map, w.walk.view, w.visit, w.receding, w.last);
    if (search.located) return;
    search.best.view = uint(w.walk.view);
    search.best.tile = uint(w.visit.tile.y * grid.columns + w.visit.tile.x);
    precise double error =
        double(search.best.t) * double(kRelativeErrorT) + double(kSmallestNormal);
    precise double early = double(search.best.t) + error;
    precise double late = double(search.best.t) - error;
    search.located = w.visit.begin <= early && late <= w.visit.end;
}

/// The next view in the order in which the ray enters them.
void nextView(inout Walker w, Search search) {
    int next = -1;
    ViewRay nextRay;
    ViewSpan nextSpan;
    for (int view = 0; view < grid.views; ++view) {
        if ((w.pendingViews >> view & 1u) == 0u) continue;
        ViewRay ray = makeViewRay(view, search.ray);
        ViewSpan span;
        if (!clipToView(ray, span)) {
            w.pendingViews &= ~(1u << view);
        } else if (next < 0 || span.begin < nextSpan.begin) {
            next = view;
            nextRay = ray;
            nextSpan = span;
        }
    }
    w.phase = kDone;
    if (next < 0 || !(nextSpan.begin <= search.limit)) return;
    w.pendingViews &= ~(1u << next);
    w.walk = startWalk(next, nextRay, nextSpan, topLevel);
    w.level = topLevel;
    w.phase = w.walk.tile.x >= 0 && w.walk.tile.y >= 0 ? kStep : kNextView;
}

/// One turn of ViewWalk::run and of what it visits.
void turn(inout Walker w, inout Search search) {
    if (w.phase == kList) {
        if (w.at != kNoNode) {
            uvec2 entry = readNode(w.at);
            w.at = entry.x;
            testEntry(w, search, entry.y);
            if (search.limit < 0.0LF) w.phase = kDone;
        } else {
            w.bin += w.receding ? 1 : -1;
            if (w.receding ? w.bin <= w.last : w.bin >= w.last) {
                w.at = headOf(w.walk.view, w.visit.tile, w.bin);
            } else {
                w.phase = kLeave;
            }
        }
    } else if (w.phase == kStep) {
        examineCell(w);
        if (!(w.walk.begin <= search.limit)) {
            w.phase = kNextView;
        } else if (!w.empty && w.level > 0) {
            --w.level;
        } else if (!w.empty && openTile(w, search)) {
            bool any = w.receding ? w.bin <= w.last : w.bin >= w.last;
            w.at = any ? headOf(w.walk.view, w.visit.tile, w.bin) : kNoNode;
            w.phase = kList;
        } else {
            w.phase = kLeave;
        }
    } else if (w.phase == kLeave) {
        if (w.exit.order == 2 || !advance(w.walk, w.exit, w.level)) {
            w.phase = kNextView;
        } else {
            int mask = (2 << w.level) - 1;
            bool coarser = (w.exit.order >= 0 && (w.exit.border.x & mask) == 0) ||
                           (w.exit.order <= 0 && (w.exit.border.y & mask) == 0);
            if (coarser && w.level < topLevel) ++w.level;
            w.phase = kStep;
        }
    } else if (w.phase == kNextView) {
        nextView(w, search);
    } else if (w.phase == kEye) {
        if (w.at < uint(atEyeCount)) {
            if (test(search, texelFetch(atEye, int(w.at)).x)) search.best.view = uint(grid.views);
            search.located = false;
            ++w.at;
            if (search.limit < 0.0LF) w.phase = kDone;
        } else {
            w.phase = kNextView;
        }
    }
}

/// Finite, and with a direction. Tests bits, as a compiler may reason that there is no NaN.
bool isTraceable(Ray ray) {
    uvec3 o = floatBitsToUint(ray.origin) & 0x7f800000u;
    uvec3 d = floatBitsToUint(ray.direction) & 0x7f800000u;
    return all(notEqual(o, uvec3(0x7f800000u))) && all(notEqual(d, uvec3(0x7f800000u))) &&
           ray.direction != vec3(0.0);
}

RayRecord rayOf(uint index) {
#if DIRT_PATHS
    PathRay ray = rays[index];
    bool alive = !masked || texelFetch(mask, int(firstPixel + index)).x != 0u;
    return RayRecord(ray.origin, ray.skip, alive ? ray.direction : vec3(0.0), 0.0);
#else
    return rays[index];
#endif
}

Search makeSearch(RayRecord given) {
    Search search;
    search.best = Hit(kNoPrimitive, 0.0, 0.0, 0.0, 0u, 0u, 0u);
    for (int i = 0; i < 3; ++i) {
        search.ray.origin[i] = flushed(given.origin[i]);
        search.ray.direction[i] = flushed(given.direction[i]);
    }
    search.ray.skip = given.skip;
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

/// Where a ray begins.
Walker firstTurn(Search search) {
    Walker w;
    w.at = 0u;
    w.pendingViews = (1u << grid.views) - 1u;
    bool throughEye =
        crossProduct(dvec3(search.ray.origin), dvec3(search.ray.direction)) == dvec3(0.0LF);
    w.phase = throughEye ? kEye : kNextView;
    if (!isTraceable(search.ray)) w.phase = kDone;
#if DIRT_ANY_HIT
    if (!(search.maxT > 0.0)) w.phase = kDone;
#endif
    return w;
}

/// Where a ray was at the end of the last dispatch.
Walker resumed(State state, inout Search search, Hit best) {
    search.best = best;
    search.located = state.located != 0u;
#if !DIRT_ANY_HIT
    if (best.primitive != kNoPrimitive) search.limit = upperBound(best.t);
#endif
    Walker w;
    w.phase = state.phase;
    w.pendingViews = state.pendingViews;
    w.level = state.level;
    w.at = state.at;
    if (w.phase < kStep || w.phase == kDone) return w;
    ViewSpan span;
    w.walk.ray = makeViewRay(state.view, search.ray);
    clipToView(w.walk.ray, span);
    w.walk.view = state.view;
    w.walk.top = topLevel;
    w.walk.tile = state.tile;
    w.walk.begin = packDouble2x32(state.begin);
    w.walk.end = span.end;
    w.walk.depth = packDouble2x32(state.depth);
    examineCell(w);
    if (w.phase == kList) openTile(w, search);
    w.bin = state.bin;
    return w;
}

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= count) return;
    State state = states[index];
    if (state.phase == kDone) return;
    RayRecord given = rayOf(index);
    Search search = makeSearch(given);
    Walker w;
    if (state.phase == kBegin)
        w = firstTurn(search);
    else
        w = resumed(state, search, hits[index]);
    for (uint i = 0u; i < turns && w.phase != kDone; ++i) turn(w, search);

    uint rounds = 0u; // whether loops still go round as often as they say
    while (rounds < probe) ++rounds;
    if (rounds != probe) atomicAdd(cut, 1u);
    if (rounds != probe || w.phase != kDone) atomicAdd(unfinished, 1u);
    if (rounds != probe) return;
    if (state.phase == kBegin && given.direction != vec3(0.0)) atomicAdd(traced, 1u);
    if (w.phase == kDone && search.best.primitive != kNoPrimitive) atomicAdd(found, 1u);
    hits[index] = search.best;
    states[index] = State(w.phase, w.pendingViews, w.walk.view, w.level, w.at, w.walk.tile,
                          unpackDouble2x32(w.walk.begin),
                          unpackDouble2x32(w.walk.depth), w.bin, search.located ? 1u : 0u);
}
