#include "core/trace/view_ray.h"

namespace dirt {

ViewRay::ViewRay(const View& view, const Ray& ray)
    : SeenRay(
          makeSeenRay(glm::dvec3(view.toView(ray.origin)), glm::dvec3(view.toView(ray.direction)))),
      view(view) {}

bool ViewRay::clip(int viewIndex, ViewSpan& span) const {
    span = {{0.0, infinity(), origin.z}, viewIndex};
    return clipSide(*this, 0, view.s.front(), true, span) &&
           clipSide(*this, 0, view.s.back(), false, span) &&
           clipSide(*this, 1, view.t.front(), true, span) &&
           clipSide(*this, 1, view.t.back(), false, span) && span.begin <= span.end;
}

} // namespace dirt
