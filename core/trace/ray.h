#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

namespace dirt {

/// "No primitive": a ray that skips nothing, a hit that is none.
inline constexpr uint32_t kNoPrimitive = 0xffffffffu;

/// A ray in the grid frame: origin + t direction, 0 <= t. The direction need not have unit length.
struct Ray {
    glm::vec3 origin{0.0f};
    glm::vec3 direction{0.0f};
    /// Primitive the ray starts on. It is not hit, nor is any triangle with the same vertices.
    uint32_t skip = kNoPrimitive;
};

/// The nearest hit of a ray; at equal t the lowest primitive id.
struct Hit {
    uint32_t primitive = kNoPrimitive;
    float t = 0.0f;    ///< in units of the ray's direction
    float u = 0.0f;    ///< barycentric weight of vertex b
    float v = 0.0f;    ///< barycentric weight of vertex c
    uint32_t view = 0; ///< the view and
    uint32_t tile = 0; ///<   tile (row-major) whose visited interval holds t

    bool found() const { return primitive != kNoPrimitive; }
};

} // namespace dirt
