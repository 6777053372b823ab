#pragma once

#include <vector>

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// A moulding's outline, made of smooth pieces with creases between them. For lathes, x is the
/// radius and y the height; for sweeps, x is the projection out of the wall and y the height.
class Profile {
public:
    explicit Profile(Vec2 start) : end_(start) {}

    Profile& line(Vec2 to);

    /// A quarter or half round, bulging to the right of the way by `bulge` times the chord.
    Profile& bow(Vec2 to, double bulge);

    /// An S: leaves along `from`'s side and arrives flat, the classical cyma.
    Profile& cyma(Vec2 to, double strength = 0.35);

    /// One smooth curve through points (Catmull-Rom), beginning at the current end.
    Profile& spline(std::vector<Vec2> through);

    struct Piece {
        std::vector<Vec2> controls;
        double steps;  ///< wanted at quality 1
        double length; ///< along the curve, for texture coordinates
        Vec2 at(double t) const;
    };
    const std::vector<Piece>& pieces() const { return pieces_; }
    double length() const;

private:
    Profile& add(std::vector<Vec2> controls, double steps);

    Vec2 end_;
    std::vector<Piece> pieces_;
};

} // namespace dirt::generate
