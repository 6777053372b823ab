#include "core/trace/view_ray.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace dirt {
namespace {

int sign(double x) {
    return (x > 0.0) - (x < 0.0);
}

constexpr double kInfinity = std::numeric_limits<double>::infinity();

} // namespace

ViewRay::ViewRay(const View& view, const Ray& ray)
    : view(view), origin(view.toView(ray.origin)), direction(view.toView(ray.direction)),
      moment(glm::cross(origin, direction)), stepX(sign(moment.y)), stepY(sign(-moment.x)) {}

ViewRay::Crossing ViewRay::crossing(int axis, double slope) const {
    const double numerator = slope * origin.z - origin[axis];
    const double denominator = direction[axis] - slope * direction.z;
    const double slopeGrowth = axis == 0 ? moment.y : -moment.x;
    if (sign(denominator) * sign(slopeGrowth) <= 0)
        return {direction.z > 0.0 ? kInfinity : -kInfinity, 0.0, false};
    return {numerator / denominator, slopeGrowth / denominator, true};
}

int ViewRay::order(float s, float t) const {
    const double x = moment.x * s, y = moment.y * t;
    const double value = (x + y) + moment.z;
    const double bound = kCornerDoubt * (std::abs(x) + std::abs(y) + std::abs(moment.z));
    if (std::abs(value) <= bound) return 0;
    return sign(value) * stepX * stepY;
}

/// Cuts the span to one side of a rim: x >= slope w if isLow, else x <= slope w.
bool ViewRay::clipSide(int axis, double slope, bool isLow, ViewSpan& span) const {
    const double numerator = slope * origin.z - origin[axis];
    const double denominator = direction[axis] - slope * direction.z;
    // Inside where t D >= N, resp. t D <= N.
    if (denominator == 0.0) return isLow ? numerator <= 0.0 : numerator >= 0.0;
    const double t = numerator / denominator;
    if ((denominator > 0.0) == isLow) {
        const double begin = t > 0.0 ? t * (1.0 - kCrossingSlack) : t * (1.0 + kCrossingSlack);
        if (begin > span.begin) {
            span.begin = begin;
            span.depth = (axis == 0 ? moment.y : -moment.x) / denominator;
        }
    } else {
        const double end = t > 0.0 ? t * (1.0 + kCrossingSlack) : t * (1.0 - kCrossingSlack);
        span.end = std::min(span.end, end);
    }
    return true;
}

bool ViewRay::clip(int viewIndex, ViewSpan& span) const {
    span = {viewIndex, 0.0, kInfinity, origin.z};
    return clipSide(0, view.s.front(), true, span) && clipSide(0, view.s.back(), false, span) &&
           clipSide(1, view.t.front(), true, span) && clipSide(1, view.t.back(), false, span) &&
           span.begin <= span.end;
}

} // namespace dirt
