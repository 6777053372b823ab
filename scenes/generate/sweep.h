#pragma once

#include <functional>

#include "scenes/generate/mesh.h"
#include "scenes/generate/profile.h"

namespace dirt::generate {

/// Turns a profile (radius, height), drawn upwards, about the Y axis.
void addLathe(Mesh& mesh, int material, const Profile& profile, int sides);

/// Like a lathe, with flat sides: an octagonal basin, a square plinth. The radius is that of the
/// inscribed circle.
void addPrism(Mesh& mesh, int material, const Profile& profile, int sides);

/// Draws a profile (projection x, height y), upwards, along the inside of a rectangle in the XZ
/// plane with mitred corners; a projection of x brings it x into the rectangle.
void addInnerRing(Mesh& mesh, int material, const Profile& profile, Vec2 halfExtent,
                  double stepsAlong = 4);

/// A place on a path: the profile's x goes along `x`, its y along `y`.
struct PathFrame {
    Vec3 origin;
    Vec3 x;
    Vec3 y;
    double length; ///< walked so far, for texture coordinates
};

/// Draws a profile along any path; outward is (along the path) × (along the profile).
void addSweep(Mesh& mesh, int material, const Profile& profile,
              const std::function<PathFrame(double)>& path, int steps);

/// A round tube whose radius may vary along its way.
void addTube(Mesh& mesh, int material, const std::function<Vec3(double)>& path,
             const std::function<double(double)>& radius, int steps, int sides);

} // namespace dirt::generate
