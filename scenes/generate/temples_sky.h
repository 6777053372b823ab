#pragma once

#include "scenes/generate/model.h"

namespace dirt::generate {

/// Radiance of the evening's clear sky at an elevation in degrees.
glm::dvec3 skyRadiance(double elevation);

/// The sky as a material: its texture has the gradient and high clouds, for the texture
/// coordinates of `addSky`.
MaterialRecipe skyMaterial();

/// A dome around the origin.
void addSky(Mesh& mesh, int material, double radius);

} // namespace dirt::generate
