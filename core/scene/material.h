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
    glm::vec3 diffuse{0.8f};          ///< Kd, linear Rec.709
    glm::vec3 emission{0.0f};         ///< Ke, radiance
    uint32_t diffuseMap = kNoTexture; ///< map_Kd; multiplies nothing: it replaces Kd where present
};

} // namespace dirt
