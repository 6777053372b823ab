// core/trace/view_walk.h in GLSL: the walk of a ray through the tiles of one view, up and down the
// depth pyramid. Why it loses nothing is told there.

#include "include/view_ray.glsl"

/// Depth bounds (-near, far).
layout(binding = 2) uniform sampler2DArray pyramid;

/// A tile that a ray visits: parameters and depths, rounded outwards.
struct TileVisit {
    ivec2 tile;
    double begin, end;
    float near, far; // depths of the ray inside the tile
};

struct ViewWalk {
    SeenRay ray;
    int view, top;
    ivec2 tile;
    double begin, end, depth; // of the current tile; of the view; w at begin
};

/// How the ray leaves a cell.
struct Exit {
    int order; // 1: through the column border, -1: the row border, 0: their corner, 2: never
    ivec2 border;
    double begin, end, near, far;
};

ivec2 gridSize() {
    return ivec2(grid.columns, grid.rows);
}

/// First cell in [from, to], in the order of the ray, that is not left before t.
int firstNotLeft(SeenRay ray, int axis, int from, int to, double t) {
    int step = ray.step[axis];
    precise double earliest = t * (1.0LF - kCrossingSlack);
    int low = 0, high = abs(to - from);
    while (low < high) {
        int middle = (low + high) / 2;
        int border = from + middle * step + (step > 0 ? 1 : 0);
        if (crossingOf(ray, axis, slopeOf(axis, border)).t < earliest)
            low = middle + 1;
        else
            high = middle;
    }
    return from + low * step;
}

int startCell(SeenRay ray, int axis, double t) {
    int cells = gridSize()[axis], step = ray.step[axis];
    if (step != 0)
        return step > 0 ? firstNotLeft(ray, axis, 0, cells - 1, t)
                        : firstNotLeft(ray, axis, cells - 1, 0, t);
    dvec3 p = ray.origin.z > 0.0LF ? ray.origin : ray.direction;
    precise double low = slopeOf(axis, 0) * p.z;
    precise double high = slopeOf(axis, cells) * p.z;
    if (!(p.z > 0.0LF && p[axis] >= low && p[axis] <= high)) return -1;
    int first = 0, end = cells + 1; // the first border beyond p
    while (first < end) {
        int middle = (first + end) / 2;
        precise double border = slopeOf(axis, middle) * p.z;
        if (border <= p[axis])
            first = middle + 1;
        else
            end = middle;
    }
    return clamp(first - 1, 0, cells - 1);
}

/// Not valid (a negative tile) if the ray touches the cone in the eye alone.
ViewWalk startWalk(int view, SeenRay ray, SeenSpan span, int top) {
    ViewWalk walk;
    walk.ray = ray;
    walk.view = view;
    walk.top = top;
    walk.tile = ivec2(startCell(ray, 0, span.begin), startCell(ray, 1, span.begin));
    walk.begin = span.begin;
    walk.end = span.end;
    walk.depth = max(span.depth, 0.0LF);
    return walk;
}

Exit exitOf(ViewWalk walk, int level) {
    Exit exit;
    ivec2 cell = walk.tile >> level << level;
    ivec2 next = min(cell + (1 << level), gridSize());
    exit.border = ivec2(walk.ray.step.x > 0 ? next.x : cell.x, walk.ray.step.y > 0 ? next.y : cell.y);
    Crossing x = Crossing(0.0LF, 0.0LF, false), y = x;
    double s = slopeOf(0, exit.border.x), t = slopeOf(1, exit.border.y);
    if (walk.ray.step.x != 0) x = crossingOf(walk.ray, 0, s);
    if (walk.ray.step.y != 0) y = crossingOf(walk.ray, 1, t);
    exit.order = x.valid && y.valid ? orderOf(walk.ray, s, t)
                 : x.valid          ? 1
                 : y.valid          ? -1
                                    : 2;
    if (exit.order == 0) { // along the rim, if only one border is one
        bvec2 low = equal(exit.border, ivec2(0)), high = equal(exit.border, gridSize());
        exit.order = int(low.y || high.y) - int(low.x || high.x);
    }
    if (exit.order == 2) { // stays in this cell: for ever, or until it reaches the eye
        exit.begin = exit.end = walk.end;
        exit.near = exit.far = walk.ray.direction.z > 0.0LF   ? infinity()
                               : walk.ray.direction.z < 0.0LF ? 0.0LF
                                                              : walk.ray.origin.z;
        return exit;
    }
    if (exit.order == 1) y = x;
    if (exit.order == -1) x = y;
    exit.begin = min(x.t, y.t);
    exit.end = max(x.t, y.t);
    exit.near = min(x.depth, y.depth);
    exit.far = max(x.depth, y.depth);
    return exit;
}

/// Moves into the next tile. False if that leaves the view.
bool advance(inout ViewWalk walk, Exit exit, int level) {
    ivec2 cell = walk.tile >> level << level;
    ivec2 end = min(cell + (1 << level), gridSize());
    for (int axis = 0; axis < 2; ++axis) {
        int step = walk.ray.step[axis];
        if (axis == 0 ? exit.order >= 0 : exit.order <= 0)
            walk.tile[axis] = step > 0 ? exit.border[axis] : exit.border[axis] - 1;
        else if (level > 0 && step != 0)
            walk.tile[axis] = firstNotLeft(walk.ray, axis, walk.tile[axis],
                                           step > 0 ? end[axis] - 1 : cell[axis], exit.begin);
    }
    precise double begin = exit.begin * (1.0LF - kCrossingSlack);
    walk.begin = max(walk.begin, begin);
    walk.depth = walk.ray.direction.z > 0.0LF ? exit.near : exit.far;
    return all(greaterThanEqual(walk.tile, ivec2(0))) && all(lessThan(walk.tile, gridSize()));
}

/// Whether the depth bounds of the tile meet the ray's depths until it leaves it.
bool offerTile(ViewWalk walk, Exit exit, out TileVisit visit) {
    precise double end = exit.end * (1.0LF + kCrossingSlack);
    visit = TileVisit(walk.tile, walk.begin, end, 0.0, 0.0);
    double near = min(walk.depth, exit.near), far = max(walk.depth, exit.far);
    vec2 bounds = texelFetch(pyramid, ivec3(walk.tile, walk.view), 0).xy;
    precise double low = near * (1.0LF - kDepthSlack);
    precise double high = far * (1.0LF + kDepthSlack);
    visit.near = roundDown(low);
    visit.far = roundUp(high);
    return !(bounds.y < visit.near || -bounds.x > visit.far);
}
