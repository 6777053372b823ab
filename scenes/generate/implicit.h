#pragma once

#include <functional>

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// A solid by its signed distance, negative inside; a bound of the distance is enough.
using Solid = std::function<double(Vec3)>;

/// Where and how finely a solid's surface is looked for.
struct SolidBox {
    Vec3 low;
    Vec3 high;
    double cell; ///< length of an edge at quality 1
    double area; ///< of the surface, about; meshes that only count rely on it
};

/// Triangulates a solid's surface by surface nets. Texture coordinates are metres in the plane
/// that each quad faces most.
void addSolid(Mesh& mesh, int material, const Solid& solid, const SolidBox& box);

/// Unites two distances, with a fillet of about `radius`.
double smoothUnion(double a, double b, double radius);

} // namespace dirt::generate
