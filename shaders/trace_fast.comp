#version 450 core
// Trace and Visibility of --precision fast: nearest hits of rays, or (DIRT_ANY_HIT 1) whether they
// hit anything, in float alone. No guard and no second opinion: what that misses, `dirt verify`
// measures. The walk is that of trace.comp in an image, where lines are straight (image_line.glsl).
// Where the driver leaves loops (DIRT_RESUMES 1) it goes on in a further dispatch.

#define DIRT_NO_DOUBLES 1

#include "include/cast_rays.glsl"
#include "include/image_line.glsl"
#include "include/nodes.glsl"
#include "include/plain_intersect.glsl"
#include "shared/bins.h"
#include "shared/hit_rules.h"
#if DIRT_CUT_OUTS
#include "include/materials.glsl"
#endif

layout(local_size_x = 64) in;

/// Where a ray's search stands.
struct State {
    int view;      // kNoView: it has not begun; kDone
    int level;
    ivec2 tile;
    float place;   // on the line
    int bin;       // kWalking, or that of the tile whose list is gone through
    uint node;
    uint located;  // the hit's tile is the one that holds it
};

const int kDone = -1, kNoView = 0, kFirstView = 1; // kFirstView + view
const int kWalking = -1;

layout(std430, binding = DIRT_SEGMENTS + 2) buffer States {
    uint traced;     // rays that have a direction
    uint found;      // of these, those that have hit something
#if DIRT_RESUMES
    uint unfinished; // rays that need another dispatch,
    uint cut;        // of these, those whose loops were cut short: they stay as they were
    State states[];
#endif
};

/// Depth bounds (-near, far).
layout(binding = 2) uniform sampler2DArray pyramid;
layout(binding = 4) uniform usampler2DArray headTexture;

layout(location = 1) uniform int topLevel;
layout(location = 2) uniform bool single; // rays end at the border of the only view
#if DIRT_RESUMES
layout(location = 4) uniform uint turns; // of one dispatch
layout(location = 5) uniform uint probe; // any number above 1
#else
const uint turns = 0xffffffffu;
#endif

/// Lines begin there: most of them are short, and the first cell of all says little.
const int kFirstLevel = 2;

/// Of depths, relative: some roundings of 2^-24.
const float kDepthError = 1e-6;

struct Search {
    Ray ray;
    Shear shear;
    vec3 direction; // of size 1
    float size;     // of the ray's own
    float maxT;
    Hit best;
    bool located;
};

/// What is gone through of a tile's lists.
struct Bins {
    int at, last, step;
    float near, perDepth;
};

#if DIRT_CUT_OUTS
bool isHit(vec3 direction, Triangle t, uint primitive, float u, float v) {
    if (hasOneSide(primitive) && dot(direction, cross(t.b - t.a, t.c - t.a)) > 0.0) return false;
    return isThere(primitive, u, v);
}
#endif

/// An entry that may be the best hit.
struct Candidate {
    uint id; // kNoPrimitive: none
    Triangle triangle;
    TriangleHit hit;
};

/// The entry, where it is nearer than what has been found, or that again.
Candidate candidateOf(Search search, uint id) {
    Candidate candidate;
    candidate.id = id;
    candidate.hit = TriangleHit(0.0, 0.0, 0.0);
    if (id == search.best.primitive) return candidate;
    candidate.triangle = triangleOf(id);
    if (id == search.ray.skip ||
        !plainIntersect(search.shear, search.ray.origin, candidate.triangle, candidate.hit) ||
        !isNearer(candidate.hit.t, id, search.best.t, search.best.primitive))
        candidate.id = kNoPrimitive;
    return candidate;
}

/// Whether a candidate is the best hit, now or from before.
bool take(inout Search search, ImageLine line, Candidate candidate) {
    if (candidate.id == search.best.primitive) return true;
    TriangleHit hit = candidate.hit;
    if (search.ray.skip != kNoPrimitive &&
        sameVertices(candidate.triangle, triangleOf(search.ray.skip)))
        return false;
    if (single) {
        float place = placeOf(line, hit.t * search.size);
        if (place < -kPlaceError || place > 1.0 + kPlaceError) return false;
    }
#if DIRT_ANY_HIT
    if (!(hit.t < search.maxT)) return false;
#endif
#if DIRT_CUT_OUTS
    if (!isHit(search.ray.direction, candidate.triangle, candidate.id, hit.u, hit.v)) return false;
#endif
    search.best.primitive = candidate.id;
    search.best.t = hit.t;
    search.best.u = hit.u;
    search.best.v = hit.v;
    search.located = false;
    return true;
}

/// Behind which place nothing matters any more.
float limitOf(Search search, ImageLine line) {
#if DIRT_ANY_HIT
    float t = search.maxT;
#else
    if (search.best.primitive == kNoPrimitive) return 2.0;
    float t = search.best.t;
#endif
    return placeOf(line, t * search.size) + kPlaceError;
}

/// The bins of a tile that the line meets between two places.
Bins binsBetween(ImageLine line, vec2 bounds, float from, float to) {
    vec2 nearness = nearnessBetween(line, from, to);
    Bins bins;
    bins.near = -bounds.x;
    bins.perDepth = bounds.y > bins.near ? float(grid.bins) / (bounds.y - bins.near) : 0.0;
    if (!(bins.perDepth <= kLargest)) bins.perDepth = 0.0;
    float least = 1.0 / nearness.y * (1.0 - kDepthError);
    float most = nearness.x > 0.0 ? 1.0 / nearness.x * (1.0 + kDepthError) : kLargest;
    int first = binOf(least, bins.near, bins.perDepth, grid.bins);
    int last = binOf(min(most, kLargest), bins.near, bins.perDepth, grid.bins);
    bool recedes = line.change <= 0.0;
    bins.at = recedes ? first : last;
    bins.last = recedes ? last : first;
    bins.step = recedes ? 1 : -1;
    return bins;
}

/// The bin at hand is the last where rounding puts the last before it.
void reachLast(inout Bins bins) {
    if (bins.step * (bins.at - bins.last) > 0) bins.last = bins.at;
}

uint headOf(int view, ivec2 tile, int bin) {
    return texelFetch(headTexture, ivec3(tile, view * grid.bins + bin), 0).x;
}

/// A cell of the walk: where the line leaves it, and through which border.
struct Cell {
    vec2 bounds;
    ivec2 border;
    float exit;
    bool throughColumn, empty;
};

Cell cellAt(ImageLine line, int view, State state) {
    Cell cell;
    ivec2 at = state.tile >> state.level;
    cell.border = (at + max(line.step, ivec2(0))) << state.level;
    vec2 exits = mix((vec2(cell.border) - line.from) * line.perTile, vec2(2.0),
                     equal(line.step, ivec2(0)));
    cell.throughColumn = exits.x <= exits.y;
    cell.exit = clamp(min(exits.x, exits.y), state.place, 1.0);
    cell.bounds = texelFetch(pyramid, ivec3(at, view), state.level).xy; // (-near, far)
    vec2 nearness = nearnessBetween(line, state.place, cell.exit);
    cell.empty = -cell.bounds.x * nearness.x > 1.0 || cell.bounds.y * nearness.y < 1.0;
    return cell;
}

/// Goes on to the next cell. False where there is none.
bool advance(ImageLine line, Cell cell, int top, inout State state) {
    state.place = cell.exit;
    if (cell.exit >= 1.0) return false;
    ivec2 low = state.tile >> state.level << state.level, high = low + (1 << state.level) - 1;
    ivec2 inside = clamp(ivec2(floor(line.from + cell.exit * line.along)), low, high);
    ivec2 beyond = cell.border + min(line.step, ivec2(0));
    state.tile = cell.throughColumn ? ivec2(beyond.x, inside.y) : ivec2(inside.x, beyond.y);
    int border = cell.throughColumn ? cell.border.x : cell.border.y;
    if ((border & ((2 << state.level) - 1)) == 0 && state.level < top) ++state.level;
    return all(greaterThanEqual(state.tile, ivec2(0))) &&
           all(lessThan(state.tile, ivec2(grid.columns, grid.rows)));
}

/// Goes through one view, or as far as there are turns. True if that was all of it.
bool searchView(int view, ImageLine line, inout Search search, inout State state,
                inout uint left) {
    float limit = limitOf(search, line);
    Bins bins;
    float exit = 0.0;
    bool listing = false, again = state.bin != kWalking;
    Cell cell;
    while (left > 0u) {
        // On to a tile.
        for (; !listing && left > 0u; --left) {
            if (state.place > limit) return true;
            cell = cellAt(line, view, state);
            if (cell.empty) {
                if (!advance(line, cell, topLevel, state)) return true;
            } else if (state.level > 0) {
                --state.level;
            } else {
                listing = true;
                bins = binsBetween(line, cell.bounds, state.place, min(cell.exit, limit));
                if (again) bins.at = state.bin;
                reachLast(bins);
                if (!again) state.node = headOf(view, state.tile, bins.at);
                again = false;
            }
        }
        // Through its lists, to the next candidate. What follows is long, and waits for all lanes.
        Candidate candidate;
        candidate.id = kNoPrimitive;
        for (; listing && candidate.id == kNoPrimitive && left > 0u; --left) {
            if (state.node == kNoNode) {
                listing = bins.at != bins.last;
                bins.at += bins.step;
                if (listing) state.node = headOf(view, state.tile, bins.at);
            }
            if (state.node != kNoNode) {
                uvec2 entry = readNode(state.node);
                state.node = entry.x;
                candidate = candidateOf(search, entry.y);
            }
        }
        if (candidate.id != kNoPrimitive) {
            uint before = search.best.primitive;
            if (take(search, line, candidate)) {
#if DIRT_ANY_HIT
                return true;
#endif
                float place = placeOf(line, search.best.t * search.size);
                if (!search.located) {
                    search.best.view = uint(view);
                    search.best.tile = uint(state.tile.y * grid.columns + state.tile.x);
                    search.located =
                        place >= state.place - kPlaceError && place <= cell.exit + kPlaceError;
                }
                if (candidate.id != before) {
                    limit = place + kPlaceError;
                    int last = binsBetween(line, cell.bounds, state.place,
                                           clamp(limit, state.place, cell.exit)).last;
                    if (bins.step * (bins.last - last) > 0) bins.last = last;
                    reachLast(bins);
                }
            }
        }
        state.bin = listing ? bins.at : kWalking;
        if (!listing && left > 0u && !advance(line, cell, topLevel, state)) return true;
    }
    return false;
}

int firstView(Search search) {
    if (single) return 0;
    vec3 p = search.ray.origin == vec3(0.0) ? search.direction : search.ray.origin;
    vec3 size = abs(p);
    int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    return 2 * axis + (p[axis] < 0.0 ? 1 : 0);
}

/// Goes on until the ray is through, or has had its turns.
void run(inout Search search, inout State state) {
    uint left = turns;
    while (state.view != kDone && left > 0u) {
        bool enters = state.view == kNoView || state.level < 0;
        int view = state.view == kNoView ? firstView(search) : state.view - kFirstView;
        ImageLine line;
        if (!lineInView(view, search.ray.origin, search.direction, line)) {
            state.view = kDone;
            return;
        }
        if (enters) {
            state.view = kFirstView + view;
            state.level = min(topLevel, kFirstLevel);
            state.tile = clamp(ivec2(floor(line.from)), ivec2(0),
                               ivec2(grid.columns, grid.rows) - 1);
            state.place = 0.0;
            state.bin = kWalking;
        }
        if (!searchView(view, line, search, state, left)) continue;
        bool over = single || line.side < 0 || limitOf(search, line) < 1.0;
#if DIRT_ANY_HIT
        over = over || search.best.primitive != kNoPrimitive;
#endif
        state.view = over ? kDone : kFirstView + viewBehind(view, line.side);
        state.level = -1;
        --left;
    }
}

Search makeSearch(RayRecord given, Hit best, bool located) {
    Search search;
    search.ray = Ray(flushed(given.origin), flushed(given.direction), given.skip);
    vec3 size = abs(search.ray.direction);
    search.size = max(max(size.x, size.y), size.z);
    search.direction = search.ray.direction / search.size;
    search.shear = shearOf(search.ray);
    search.maxT = given.maxT;
    search.best = best;
    search.located = located;
    return search;
}

void report(RayRecord given, Search search) {
    if (given.direction != vec3(0.0)) atomicAdd(traced, 1u);
    if (search.best.primitive != kNoPrimitive) atomicAdd(found, 1u);
}

bool isCast(Search search) {
#if DIRT_ANY_HIT
    if (!(search.maxT > 0.0)) return false;
#endif
    return isTraceable(search.ray.origin, search.ray.direction);
}

void trace(uint index) {
    RayRecord given = rayOf(index);
#if DIRT_RESUMES
    State state = states[index];
    if (state.view == kDone) return;
    Search search = makeSearch(given, state.view == kNoView ? kNoHit : hits[index],
                               state.located != 0u);
#else
    State state = State(kNoView, 0, ivec2(0), 0.0, kWalking, kNoNode, 0u);
    Search search = makeSearch(given, kNoHit, false);
#endif
    if (isCast(search))
        run(search, state);
    else
        state.view = kDone;
#if DIRT_RESUMES
    uint rounds = 0u; // whether loops still go round as often as they say
    while (rounds < probe) ++rounds;
    if (rounds != probe) atomicAdd(cut, 1u);
    if (rounds != probe || state.view != kDone) atomicAdd(unfinished, 1u);
    if (rounds != probe) return;
    state.located = search.located ? 1u : 0u;
    states[index] = state;
#endif
    if (state.view == kDone) report(given, search);
    hits[index] = search.best;
}

void main() {
    if (gl_GlobalInvocationID.x < count) trace(gl_GlobalInvocationID.x);
}
