#pragma once

#include "core/scene/texture.h"

#include <cstdint>
#include <string>

#include <glm/vec3.hpp>

namespace dirt {

/// "No texture" in a Material.
inline constexpr uint32_t kNoTexture = 0xffffffffu;

/// Surface description, as far as the light transport uses it.
struct Material {
    std::string name;
    glm::vec3 diffuse{0.8f};  ///< Kd, linear Rec.709
    glm::vec3 emission{0.0f}; ///< Ke, radiance
    float reflectance = 0.0f; ///< Ks, its first component, in [0, 1]; 0: no microfacets
    float metallic = 0.0f;    ///< in [0, 1]
    float roughness = 1.0f;   ///< 1 - Ns / 127, the width of the microfacets' distribution
    float opacity = 1.0f;     ///< d; below 0.5 the surface is not there
    float bumpScale = 1.0f;   ///< -bm of map_bump
    float normalScale = 1.0f; ///< how far normalMap tilts: times its x and y

    // In Scene::textures.
    uint32_t diffuseMap = kNoTexture;  ///< map_Kd: replaces Kd where present, times ...
    glm::vec3 diffuseMapFactor{1.0f};  ///< ... this
    uint32_t emissionMap = kNoTexture; ///< map_Ke, times Ke
    /// Normals (2 c - 1 of a texel's linear channels) in the frame of the image's u and v, which
    /// runs upwards, and of the surface's normal. Where there is one, bumpMap does not count.
    uint32_t normalMap = kNoTexture;

    // In Scene::scalarTextures.
    uint32_t reflectanceMap = kNoTexture; ///< map_Ks, times Ks
    uint32_t roughnessMap = kNoTexture;   ///< its square, times roughness
    /// Times metallic. Where there is one, reflectance is what the surface has where it is no
    /// metal, and grows with metallic to 1 (metalReflectance).
    uint32_t metallicMap = kNoTexture;
    uint32_t bumpMap = kNoTexture;    ///< map_bump: heights; 1 is as high as a texel is wide
    uint32_t opacityMap = kNoTexture; ///< map_d, else the alpha of map_Kd, times d

    /// Whether Fetch needs texture coordinates.
    bool isTextured() const {
        return (diffuseMap & emissionMap & normalMap & reflectanceMap & roughnessMap & metallicMap &
                bumpMap) != kNoTexture;
    }
    /// Whether the surface is there for rays that come from behind; the corners of a triangle are
    /// seen counterclockwise from its front.
    bool doubleSided = true;

    /// Whether parts of the surface are not there, or not for every ray.
    bool hasCutOuts() const { return opacityMap != kNoTexture || opacity < 0.5f || !doubleSided; }
};

} // namespace dirt
