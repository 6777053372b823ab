// core/trace/view_ray.h in GLSL: a ray in one view's frame, and when it crosses borders of tiles.

#include "include/intersect.glsl"
#include "include/views.glsl"

/// Border slopes: columns + 1 of them, then rows + 1.
layout(binding = 1) uniform samplerBuffer slopes;

double infinity() {
    return packDouble2x32(uvec2(0u, 0x7ff00000u));
}

/// The slope of a border: axis 0 for columns, 1 for rows.
double slopeOf(int axis, int border) {
    return double(texelFetch(slopes, axis == 0 ? border : grid.columns + 1 + border).x);
}

struct ViewRay {
    dvec3 origin, direction, moment;
    ivec2 step; // -1, 0, 1: how x/w and y/w change along the ray
};

/// The part of a ray inside a view, and w at its begin.
struct ViewSpan {
    double begin, end, depth;
};

struct Crossing {
    double t, depth;
    bool valid;
};

ViewRay makeViewRay(int view, Ray ray) {
    ViewRay result;
    result.origin = dvec3(toView(view, ray.origin));
    result.direction = dvec3(toView(view, ray.direction));
    result.moment = crossProduct(result.origin, result.direction);
    result.step = ivec2(signOf(result.moment.y), signOf(-result.moment.x));
    return result;
}

double slopeGrowth(ViewRay ray, int axis) {
    return axis == 0 ? ray.moment.y : -ray.moment.x;
}

Crossing crossingOf(ViewRay ray, int axis, int border) {
    double slope = slopeOf(axis, border);
    precise double numerator = slope * ray.origin.z - ray.origin[axis];
    precise double denominator = ray.direction[axis] - slope * ray.direction.z;
    double growth = slopeGrowth(ray, axis);
    if (signOf(denominator) * signOf(growth) <= 0)
        return Crossing(ray.direction.z > 0.0LF ? infinity() : -infinity(), 0.0LF, false);
    precise double t = numerator / denominator;
    precise double depth = growth / denominator;
    return Crossing(t, depth, true);
}

/// 1: the column border is crossed before the row border, -1: after it, 0: too close to tell.
int orderOf(ViewRay ray, int columnBorder, int rowBorder) {
    precise double x = ray.moment.x * slopeOf(0, columnBorder);
    precise double y = ray.moment.y * slopeOf(1, rowBorder);
    precise double value = (x + y) + ray.moment.z;
    precise double bound = kCornerDoubt * (abs(x) + abs(y) + abs(ray.moment.z));
    if (abs(value) <= bound) return 0;
    return signOf(value) * ray.step.x * ray.step.y;
}

bool clipSide(ViewRay ray, int axis, int border, bool isLow, inout ViewSpan span) {
    double slope = slopeOf(axis, border);
    precise double numerator = slope * ray.origin.z - ray.origin[axis];
    precise double denominator = ray.direction[axis] - slope * ray.direction.z;
    if (denominator == 0.0LF) return isLow ? numerator <= 0.0LF : numerator >= 0.0LF;
    precise double t = numerator / denominator;
    bool begins = (denominator > 0.0LF) == isLow;
    precise double outwards =
        t * ((t > 0.0LF) == begins ? 1.0LF - kCrossingSlack : 1.0LF + kCrossingSlack);
    if (begins) {
        if (outwards > span.begin) {
            precise double depth = slopeGrowth(ray, axis) / denominator;
            span.begin = outwards;
            span.depth = depth;
        }
    } else {
        span.end = min(span.end, outwards);
    }
    return true;
}

/// The part of the ray inside the view's closed cone. False if there is none.
bool clipToView(ViewRay ray, out ViewSpan span) {
    span = ViewSpan(0.0LF, infinity(), ray.origin.z);
    for (int side = 0; side < 4; ++side) {
        int axis = side / 2;
        bool isLow = side % 2 == 0;
        int border = isLow ? 0 : axis == 0 ? grid.columns : grid.rows;
        if (!clipSide(ray, axis, border, isLow, span)) return false;
    }
    return span.begin <= span.end;
}
