#pragma once

#include <functional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "scenes/generate/mesh.h"

namespace dirt::generate {

/// A seamless texture: sRGB colours in [0, 1] over the unit square.
struct TextureRecipe {
    int size = 512;
    std::function<glm::dvec3(Vec2 unit)> paint;
};

/// One entry of the MTL file. A material without a recipe has a plain colour.
struct MaterialRecipe {
    std::string name;
    glm::dvec3 diffuse = glm::dvec3(1);
    double reflectivity = 0; ///< Ks
    double gloss = 0;        ///< Ns, 0 to 127
    double metallic = 0;
    glm::dvec3 emission = glm::dvec3(0);
    double repeat = 1; ///< metres that one repeat of the texture covers
    TextureRecipe texture = {};
    TextureRecipe bump = {}; ///< height, as a grey
    double bumpHeight = 4;   ///< of white over black, in texels
    TextureRecipe glow = {}; ///< multiplies the emission
};

/// A scene's geometry and materials, before it is written.
struct Model {
    std::vector<MaterialRecipe> materials;
    Mesh mesh;
};

} // namespace dirt::generate
