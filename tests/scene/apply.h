#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace dirt::test {

/// A point, transformed.
inline glm::dvec3 apply(const glm::dmat4& m, glm::dvec3 p) {
    return glm::dvec3(m * glm::dvec4(p, 1.0));
}

} // namespace dirt::test
