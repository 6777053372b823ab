#pragma once

#include <vector>

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// A smooth function through keys (x, y), sorted by x, that does not overshoot between them;
/// constant beyond the ends.
class Keys {
public:
    Keys(std::initializer_list<Vec2> keys) : keys_(keys) {}
    double operator()(double x) const;

private:
    std::vector<Vec2> keys_;
};

/// A wing's cross-section: the leading edge, the chord behind it (towards -z), and the thickness as
/// a part of the chord.
struct WingStation {
    Vec3 leading;
    double chord;
    double thickness;
};

/// A wing through stations, from the root outwards; `columns` around and `rows` between two
/// stations at quality 1. Outward is right where it is drawn towards +x or +y.
void addWing(Mesh& mesh, int material, const std::vector<WingStation>& stations, double columns,
             double rows);

/// A bevelled bar with a rectangular section between two points; `height` is measured in the plane
/// of the bar and the vertical.
void addBar(Mesh& mesh, int material, Vec3 from, Vec3 to, double width, double height,
            double bevel = 0);

/// A round rod between two points, its ends open.
void addRod(Mesh& mesh, int material, Vec3 from, Vec3 to, double radius, double sides = 10);

/// The transform that brings the y axis to the direction from `from` to `to`, and the origin to
/// `from`.
Transform standing(Vec3 from, Vec3 to);

} // namespace dirt::generate
