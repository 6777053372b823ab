// When a ray crosses the borders between tiles. core/trace/view_ray.h says how exact that is.
#ifndef DIRT_SHARED_BORDER_CROSSING_H
#define DIRT_SHARED_BORDER_CROSSING_H

#include "shaders/shared/margins.h"

DIRT_SHARED_BEGIN

/// A ray in one view's frame, and its moment, origin × direction.
struct SeenRay {
    dvec3 origin;
    dvec3 direction;
    dvec3 moment;
    ivec2 step; // -1, 0, 1: how x/w and y/w change along the ray
};

/// The part of a ray inside a view, rounded outwards, and w at its begin.
struct SeenSpan {
    double begin;
    double end;
    double depth;
};

/// When and where a border is crossed; t is +-infinity if that never happens (the crossing would
/// lie behind the eye): + if the border is still ahead forever, - if always behind.
struct Crossing {
    double t;
    double depth;
    bool valid;
};

DIRT_FUNCTION SeenRay makeSeenRay(dvec3 o, dvec3 d) {
    SeenRay ray;
    ray.origin = o;
    ray.direction = d;
    DIRT_PRECISE dvec3 moment =
        dvec3(o.y * d.z - d.y * o.z, o.z * d.x - d.z * o.x, o.x * d.y - d.x * o.y);
    ray.moment = moment;
    ray.step = ivec2(signOf(moment.y), signOf(-moment.x));
    return ray;
}

DIRT_FUNCTION double slopeGrowth(SeenRay ray, int axis) {
    return axis == 0 ? ray.moment.y : -ray.moment.x;
}

/// Of the border of \p slope, \p axis 0 for a column's, 1 for a row's.
DIRT_FUNCTION Crossing crossingOf(SeenRay ray, int axis, double slope) {
    DIRT_PRECISE double numerator = slope * ray.origin.z - ray.origin[axis];
    DIRT_PRECISE double denominator = ray.direction[axis] - slope * ray.direction.z;
    double growth = slopeGrowth(ray, axis);
    Crossing crossing;
    crossing.t = ray.direction.z > 0.0 ? infinity() : -infinity();
    crossing.depth = 0.0;
    crossing.valid = signOf(denominator) * signOf(growth) > 0;
    if (crossing.valid) {
        DIRT_PRECISE double t = numerator / denominator;
        DIRT_PRECISE double depth = growth / denominator;
        crossing.t = t;
        crossing.depth = depth;
    }
    return crossing;
}

/// Whether the crossing of column border \p s comes before (1) or after (-1) that of row border
/// \p t, or too close to tell (0): the side on which the tile corner lies of the ray's image.
DIRT_FUNCTION int orderOf(SeenRay ray, double s, double t) {
    DIRT_PRECISE double x = ray.moment.x * s;
    DIRT_PRECISE double y = ray.moment.y * t;
    DIRT_PRECISE double value = (x + y) + ray.moment.z;
    DIRT_PRECISE double bound = kCornerDoubt * (abs(x) + abs(y) + abs(ray.moment.z));
    if (abs(value) <= bound) return 0;
    return signOf(value) * ray.step.x * ray.step.y;
}

/// Cuts \p span to one side of a rim: x >= slope w if \p isLow, else x <= slope w. False if nothing
/// is left.
DIRT_FUNCTION bool clipSide(SeenRay ray, int axis, double slope, bool isLow,
                            DIRT_INOUT(SeenSpan) span) {
    DIRT_PRECISE double numerator = slope * ray.origin.z - ray.origin[axis];
    DIRT_PRECISE double denominator = ray.direction[axis] - slope * ray.direction.z;
    // Inside where t D >= N, resp. t D <= N.
    if (denominator == 0.0) return isLow ? numerator <= 0.0 : numerator >= 0.0;
    DIRT_PRECISE double t = numerator / denominator;
    bool begins = (denominator > 0.0) == isLow;
    DIRT_PRECISE double outwards =
        t * ((t > 0.0) == begins ? 1.0 - kCrossingSlack : 1.0 + kCrossingSlack);
    if (!begins) {
        if (outwards < span.end) span.end = outwards;
    } else if (outwards > span.begin) {
        DIRT_PRECISE double depth = slopeGrowth(ray, axis) / denominator;
        span.begin = outwards;
        span.depth = depth;
    }
    return true;
}

DIRT_SHARED_END

#endif
