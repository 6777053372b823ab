// core/trace/view_ray.h in GLSL: a ray in one view's frame, and the part of it inside the view.

#include "include/intersect.glsl"
#include "include/views.glsl"
#include "shared/border_crossing.h"

/// Border slopes: columns + 1 of them, then rows + 1.
layout(binding = 1) uniform samplerBuffer slopes;

/// The slope of a border: axis 0 for columns, 1 for rows.
double slopeOf(int axis, int border) {
    return double(texelFetch(slopes, axis == 0 ? border : grid.columns + 1 + border).x);
}

SeenRay seenRay(int view, Ray ray) {
    return makeSeenRay(dvec3(toView(view, ray.origin)), dvec3(toView(view, ray.direction)));
}

/// The part of the ray inside the view's closed cone. False if there is none.
bool clipToView(SeenRay ray, out SeenSpan span) {
    span = SeenSpan(0.0LF, infinity(), ray.origin.z);
    for (int side = 0; side < 4; ++side) {
        int axis = side / 2;
        bool isLow = side % 2 == 0;
        int border = isLow ? 0 : axis == 0 ? grid.columns : grid.rows;
        if (!clipSide(ray, axis, slopeOf(axis, border), isLow, span)) return false;
    }
    return span.begin <= span.end;
}
