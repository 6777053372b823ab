#pragma once

#include "core/trace/ray.h"
#include "core/verify/exact_clip.h"

/// Points of a ray, exactly, and the tiles and depths they lie at.
namespace dirt::test {

/// A ray as integers times powers of two.
struct ExactRay {
    int unit, directionUnit;
    IntegerVector origin, direction;

    explicit ExactRay(const Ray& ray)
        : unit(std::min(lowestExponent(ray.origin), 0)),
          directionUnit(std::min(lowestExponent(ray.direction), 0)),
          origin(toIntegers(ray.origin, unit)),
          direction(toIntegers(ray.direction, directionUnit)) {}

    /// A parameter t >= 0, in units of 2^(unit - directionUnit).
    struct Parameter {
        Integer numerator, denominator; ///< denominator > 0
    };
    Parameter parameter(double t) const {
        const int tUnit = unit - directionUnit;
        const int shift = t == 0.0 ? 0 : std::max(0, tUnit - lowestExponent(t));
        return {toInteger(t, tUnit - shift), Integer(1) << shift};
    }
    /// Where the plane x = slope w (or y = slope w, axis 1) of a view is crossed. False if nowhere
    /// at t >= 0.
    bool crossing(const View& view, int axis, float slope, Parameter& out) const {
        const int fraction = slope == 0.0f ? 0 : std::max(0, -lowestExponent(slope));
        const Integer s = toInteger(slope, -fraction);
        const IntegerVector o = toView(view, origin), d = toView(view, direction);
        Integer n = s * o.z - ((axis ? o.y : o.x) << fraction);
        Integer m = ((axis ? d.y : d.x) << fraction) - s * d.z;
        if (m < 0) n = -n, m = -m;
        if (m == 0 || n < 0) return false;
        out = {n, m};
        return true;
    }

    /// The point there, times \p t's denominator, in units of 2^unit.
    IntegerVector at(const Parameter& t) const {
        return origin * t.denominator + direction * t.numerator;
    }

    static IntegerVector toView(const View& view, const IntegerVector& p) {
        const Integer* c[3] = {&p.x, &p.y, &p.z};
        const Integer& w = *c[view.axisW];
        return {*c[view.axisX], *c[view.axisY], view.signW < 0 ? Integer(-w) : w};
    }
};

/// The parameters of a ray in the interior of a cone, to 2^-50 of their own.
struct ParameterSpan {
    double from = 0.0, to = INFINITY;
    bool empty() const { return !(from * (1.0 + 0x1p-48) < to); }
};
inline ParameterSpan spanInside(const ExactRay& ray, const View& view, const ExactCone& cone) {
    const auto o = cone.distances(ExactRay::toView(view, ray.origin));
    const auto d = cone.distances(ExactRay::toView(view, ray.direction));
    ParameterSpan span;
    for (int i = 0; i < 4; ++i) { // o + t d > 0
        if (d[i] == 0) {
            if (o[i] <= 0) return {1.0, 0.0};
            continue;
        }
        const int unit = ray.unit - ray.directionUnit;
        const double t = Fraction{-o[i] * sign(d[i]), abs(d[i]), unit}.value();
        if (d[i] > 0)
            span.from = std::max(span.from, t);
        else
            span.to = std::min(span.to, t);
    }
    return span;
}

/// Calls \p found(tile) for every tile of \p view whose cone, widened by a fraction of a tile,
/// holds the point \p p (of the view's frame, times any positive factor).
template <class Found>
void tilesAround(const View& view, TileSize tile, const IntegerVector& p, double widened,
                 Found&& found) {
    if (p.z <= 0) return;
    const double w = toDouble(p.z), x = toDouble(p.x) / w, y = toDouble(p.y) / w;
    if (x < view.s.front() - tile.x || x > view.s.back() + tile.x || y < view.t.front() - tile.y ||
        y > view.t.back() + tile.y)
        return;
    const int column = cellAt(view.s, x), row = cellAt(view.t, y);
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, view.rows - 1); ++r)
        for (int c = std::max(column - 1, 0); c <= std::min(column + 1, view.columns - 1); ++c) {
            // Far from the neighbour, compared with the rounding of x and y: no need to be exact.
            const double beside = std::max({view.s[c] - x, x - view.s[c + 1]}) / tile.x;
            const double above = std::max({view.t[r] - y, y - view.t[r + 1]}) / tile.y;
            if (std::max(beside, above) > 2.0 * widened) continue;
            if (ExactCone(view, c, r, tile, widened).contains(p)) found(r * view.columns + c);
        }
}

} // namespace dirt::test
