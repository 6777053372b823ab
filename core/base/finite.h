#pragma once

#include <cmath>

#include <glm/vec3.hpp>

namespace dirt {

/// Whether no component is a NaN or an infinity.
inline bool isFinite(glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace dirt
