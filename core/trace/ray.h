#pragma once

#include "shaders/shared/layouts.h"

#include <glm/vec3.hpp>

namespace dirt {

/// A ray in the grid frame: origin + t direction, 0 <= t. The direction need not have unit length.
struct Ray {
    glm::vec3 origin{0.0f};
    glm::vec3 direction{0.0f};
    /// Primitive the ray starts on. It is not hit, nor is any triangle with the same vertices.
    uint32_t skip = kNoPrimitive;
};

} // namespace dirt
