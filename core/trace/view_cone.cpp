#include "core/trace/view_cone.h"

#include "core/trace/view_ray.h"
#include "shaders/shared/rounding.h"

namespace dirt {

ViewCone::Part ViewCone::part(const Ray& ray) const {
    ViewSpan span;
    if (!ViewRay(view_, ray).clip(0, span)) return {0.0f, -1.0f};
    // The span is rounded outwards by far less than that.
    return {roundUp(span.begin * (1.0 + kConeInset)), roundDown(span.end * (1.0 - kConeInset))};
}

} // namespace dirt
