#version 450 core
// Trace and Visibility of --precision exact: nearest hits of rays, or (DIRT_ANY_HIT 1) whether they
// hit anything. The traversal of core/trace/traverse.cpp. Where the driver leaves loops before they
// are through (DIRT_RESUMES 1; llvmpipe does, without a word, once a shader has gone round 65535 times
// in all) in turns, and a ray keeps its state between dispatches.
//
// Rays that run side by side all wait for the one that does something else. So there is a loop for
// each thing to do, cheap ones inside: walk to a tile; go through its lists to a triangle that the
// float filter does not refuse; decide that one exactly, which is long and rare.

#include "include/cast_rays.glsl"
#include "include/search.glsl"
#include "include/view_walk.glsl"
#include "include/nodes.glsl"
#include "shared/bins.h"

layout(local_size_x = 64) in;

#if DIRT_RESUMES
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
#endif

layout(std430, binding = DIRT_SEGMENTS + 2) buffer States {
    uint traced;     // rays that have a direction
    uint found;      // of these, those that have hit something
#if DIRT_RESUMES
    uint unfinished; // rays that need another dispatch,
    uint cut;        // of these, those whose loops were cut short: they stay as they were
    State states[];
#endif
};
layout(binding = 4) uniform usampler2DArray headTexture;
layout(binding = 5) uniform usamplerBuffer atEye;

layout(location = 1) uniform int topLevel;
layout(location = 3) uniform int atEyeCount;
#if DIRT_RESUMES
layout(location = 4) uniform uint turns; // of one dispatch
layout(location = 5) uniform uint probe; // any number above 1
#else
const uint turns = 0xffffffffu;
#endif

// What a ray is about to do; it begins with the first. A search that is interrupted in a list opens
// its tile again.
const int kBegin = 0, kEye = 1, kNextView = 2, kStep = 3, kLeave = 4, kOpen = 5, kList = 6,
          kDone = 7;

/// BinMap of core/grid/grid.h.
struct BinMap {
    float near, perDepth;
};

int binOf(BinMap map, float w) {
    return binOf(w, map.near, map.perDepth, grid.bins);
}

/// The last bin that the ray enters before search.limit.
int lastBin(Search search, BinMap map, int view, TileVisit visit, bool receding, int last) {
    if (!(search.limit < visit.end)) return last;
    double origin = double(toView(view, search.ray.origin).z);
    precise double depth = origin + search.limit * double(toView(view, search.ray.direction).z);
    return receding ? min(last, binOf(map, roundUp(depth)))
                    : max(last, binOf(map, roundDown(depth)));
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
    bool again; // the tile was open when the search was interrupted
};

void examineCell(inout Walker w) {
    w.exit = exitOf(w.walk, w.level);
    double near = min(w.walk.depth, w.exit.near), far = max(w.walk.depth, w.exit.far);
    vec2 bounds = texelFetch(pyramid, ivec3(w.walk.tile >> w.level, w.walk.view), w.level).xy;
    precise double low = near * (1.0LF - kDepthSlack);
    precise double high = far * (1.0LF + kDepthSlack);
    w.empty = double(bounds.y) < low || double(-bounds.x) > high; // bounds: (-near, far)
}

/// One cell of the walk: down, on to the next cell, or the tile to open.
void step(inout Walker w, Search search) {
    examineCell(w);
    if (w.again) {
        w.phase = kOpen;
    } else if (w.phase == kStep) {
        if (!(w.walk.begin <= search.limit)) {
            w.phase = kNextView;
        } else if (w.empty) {
            w.phase = kLeave;
        } else if (w.level > 0) {
            --w.level;
        } else {
            w.phase = kOpen;
        }
    }
    if (w.phase != kLeave) return;
    w.phase = kNextView;
    if (w.exit.order == 2 || !advance(w.walk, w.exit, w.level)) return;
    int mask = (2 << w.level) - 1;
    bool coarser = (w.exit.order >= 0 && (w.exit.border.x & mask) == 0) ||
                   (w.exit.order <= 0 && (w.exit.border.y & mask) == 0);
    if (coarser && w.level < topLevel) ++w.level;
    w.phase = kStep;
}

bool hasBin(Walker w, int bin) {
    return w.receding ? bin <= w.last : bin >= w.last;
}

/// Begins with the lists of the walk's tile, or goes on with them.
void openTile(inout Walker w, Search search) {
    bool again = w.again;
    w.again = false;
    w.phase = kLeave;
    if (!offerTile(w.walk, w.exit, w.visit)) return;
    vec2 bounds = texelFetch(pyramid, ivec3(w.walk.tile, w.walk.view), 0).xy;
    w.map = BinMap(-bounds.x, binsPerDepth(-bounds.x, bounds.y, grid.bins));
    w.receding = toView(w.walk.view, search.ray.direction).z >= 0.0;
    w.last = binOf(w.map, w.receding ? w.visit.far : w.visit.near);
    w.last = lastBin(search, w.map, w.walk.view, w.visit, w.receding, w.last);
    w.phase = kList;
    if (again) return;
    int first = binOf(w.map, w.receding ? w.visit.near : w.visit.far);
    w.bin = w.receding ? first - 1 : first + 1; // the list before it has no more entries
    w.at = kNoNode;
}

/// The next entry of the lists, if it may be hit.
Candidate nextCandidate(inout Walker w, Search search) {
    Candidate candidate = noCandidate();
    if (w.phase == kEye) {
        if (w.at < uint(atEyeCount))
            candidate.id = texelFetch(atEye, int(w.at++)).x;
        else
            w.phase = kNextView;
    } else {
        if (w.at == kNoNode) {
            w.bin += w.receding ? 1 : -1;
            if (hasBin(w, w.bin))
                w.at = headOf(w.walk.view, w.visit.tile, w.bin);
            else
                w.phase = kLeave;
        }
        if (w.at != kNoNode) {
            uvec2 entry = readNode(w.at);
            w.at = entry.x;
            candidate.id = entry.y;
        }
    }
    if (candidate.id != kNoPrimitive && !isWorthTesting(search, candidate))
        candidate.id = kNoPrimitive;
    return candidate;
}

/// Decides a candidate, which the tile of the visit, or the eye, has.
void testCandidate(inout Walker w, inout Search search, Candidate candidate) {
    uint before = search.best.primitive;
    if (!test(search, candidate)) return;
    if (w.phase == kEye) {
        search.best.view = uint(grid.views);
        search.located = false;
    } else {
        if (search.best.primitive != before)
            w.last = lastBin(search, w.map, w.walk.view, w.visit, w.receding, w.last);
        if (!search.located) {
            search.best.view = uint(w.walk.view);
            search.best.tile = uint(w.visit.tile.y * grid.columns + w.visit.tile.x);
            search.located = mayHold(w.visit.begin, w.visit.end, search.best.t);
        }
    }
    if (search.limit < 0.0LF) w.phase = kDone;
}

/// The next view in the order in which the ray enters them.
void nextView(inout Walker w, Search search) {
    int next = -1;
    SeenRay nextRay;
    SeenSpan nextSpan;
    for (int view = 0; view < grid.views; ++view) {
        if ((w.pendingViews >> view & 1u) == 0u) continue;
        SeenRay ray = seenRay(view, search.ray);
        SeenSpan span;
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

bool isWalking(Walker w) {
    return w.phase == kStep || w.phase == kLeave;
}

bool isListing(Walker w) {
    return w.phase == kList || w.phase == kEye;
}

/// Goes on until the ray is through, or has had its turns.
void run(inout Walker w, inout Search search) {
    uint left = turns;
    while (w.phase != kDone && left > 0u) {
        --left;
        if (w.phase == kNextView) nextView(w, search);
        Candidate candidate = noCandidate();
        while ((isWalking(w) || isListing(w)) && candidate.id == kNoPrimitive && left > 0u) {
            for (; isWalking(w) && left > 0u; --left) step(w, search);
            if (w.phase == kOpen) openTile(w, search);
            for (; isListing(w) && candidate.id == kNoPrimitive && left > 0u; --left)
                candidate = nextCandidate(w, search);
        }
        if (candidate.id != kNoPrimitive) testCandidate(w, search, candidate);
    }
}

/// Where a ray begins.
Walker firstTurn(Search search) {
    Walker w;
    w.again = false;
    w.at = 0u;
    w.pendingViews = (1u << grid.views) - 1u;
    bool throughEye =
        search.ray.origin != vec3(0.0) && // from there it meets nothing there
        crossProduct(dvec3(search.ray.origin), dvec3(search.ray.direction)) == dvec3(0.0LF);
    w.phase = throughEye ? kEye : kNextView;
    if (!isTraceable(search.ray.origin, search.ray.direction)) w.phase = kDone;
#if DIRT_ANY_HIT
    if (!(search.maxT > 0.0)) w.phase = kDone;
#endif
    return w;
}

void report(RayRecord given, Search search) {
    if (given.direction != vec3(0.0)) atomicAdd(traced, 1u);
    if (search.best.primitive != kNoPrimitive) atomicAdd(found, 1u);
}

#if DIRT_RESUMES
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
    w.again = w.phase == kList;
    if (w.phase < kStep || w.phase == kDone) return w;
    SeenSpan span;
    w.walk.ray = seenRay(state.view, search.ray);
    clipToView(w.walk.ray, span);
    w.walk.view = state.view;
    w.walk.top = topLevel;
    w.walk.tile = state.tile;
    w.walk.begin = packDouble2x32(state.begin);
    w.walk.end = span.end;
    w.walk.depth = packDouble2x32(state.depth);
    w.bin = state.bin;
    if (w.again) w.phase = kStep;
    return w;
}

void trace(uint index) {
    State state = states[index];
    if (state.phase == kDone) return;
    RayRecord given = rayOf(index);
    Search search = makeSearch(given);
    Walker w;
    if (state.phase == kBegin)
        w = firstTurn(search);
    else
        w = resumed(state, search, hits[index]);
    run(w, search);

    uint rounds = 0u; // whether loops still go round as often as they say
    while (rounds < probe) ++rounds;
    if (rounds != probe) atomicAdd(cut, 1u);
    if (rounds != probe || w.phase != kDone) atomicAdd(unfinished, 1u);
    if (rounds != probe) return;
    if (w.phase == kDone) report(given, search);
    hits[index] = search.best;
    states[index] = State(w.phase, w.pendingViews, w.walk.view, w.level, w.at, w.walk.tile,
                          unpackDouble2x32(w.walk.begin),
                          unpackDouble2x32(w.walk.depth), w.bin, search.located ? 1u : 0u);
}
#else
void trace(uint index) {
    RayRecord given = rayOf(index);
    Search search = makeSearch(given);
    Walker w = firstTurn(search);
    run(w, search);
    report(given, search);
    hits[index] = search.best;
}
#endif

void main() {
    if (gl_GlobalInvocationID.x < count) trace(gl_GlobalInvocationID.x);
}
