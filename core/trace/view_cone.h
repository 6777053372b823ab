#pragma once

#include "core/grid/view.h"
#include "core/trace/ray.h"

namespace dirt {

/// The camera's view in single mode, where a ray ends when it leaves. Triangles that reach beyond
/// the view are listed inside it, and Embree knows of no view at all; so what a ray may hit is
/// decided here, once, for every tile size and every backend.
class ViewCone {
public:
    explicit ViewCone(const View& view) : view_(view) {}

    /// Parameters of a ray: nothing is hit before begin or after end.
    struct Part {
        float begin = 0.0f, end = 0.0f;
        bool holds(float t) const { return t >= begin && t <= end; }
    };

    /// The part of \p ray inside the closed cone, shortened by twice err(t) at an end where it
    /// crosses the border, so that a hit in it lies inside the cone exactly and is in the grid's
    /// lists. end is FLT_MAX if the ray stays inside for ever, and negative if it never is inside.
    Part part(const Ray& ray) const;

private:
    View view_;
};

} // namespace dirt
