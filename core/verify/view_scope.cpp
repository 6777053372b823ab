#include "core/verify/view_scope.h"

#include "core/trace/view_cone.h"
#include "core/verify/exact.h"

#include <algorithm>
#include <cfloat>

namespace dirt {

namespace {

/// Whether the point at \p t of the ray lies in the closed view.
bool inside(const View& view, const Ray& ray, const ExactT& t) {
    const auto side = [&](int axis, float slope) {
        return sideOfBorder(ray, t, axis, slope, view.axisW, view.signW);
    };
    return side(view.axisX, view.s.front()) >= 0 && side(view.axisX, view.s.back()) <= 0 &&
           side(view.axisY, view.t.front()) >= 0 && side(view.axisY, view.t.back()) <= 0;
}

} // namespace

ViewScope::ViewScope(const GridSettings& settings, const Camera& camera) {
    if (settings.mode == ViewMode::single) view_ = makeViews(settings, camera)[0];
}

bool ViewScope::counts(const Ray& ray, const Verdict& truth, const FrameGeometry& geometry) const {
    if (!view_) return true;
    if (!inside(*view_, ray, {Dyadic(0.0), Dyadic(1.0)})) return false;
    if (!truth.found()) return true;
    const auto t = (float) std::min(truth.t, (double) FLT_MAX);
    return ViewCone(*view_).part(ray).holds(t) &&
           inside(*view_, ray,
                  *intersectExactly(ray, geometry.triangles[truth.primitives.front()]));
}

} // namespace dirt
