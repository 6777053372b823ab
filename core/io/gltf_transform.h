#pragma once

#include "core/io/json_value.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace dirt {

/// A scale, then a rotation, then a translation. Throws InputError at \p from where the rotation
/// has no length.
glm::dmat4 gltfTransform(const JsonValue& from, glm::dvec3 translation, glm::dquat rotation,
                         glm::dvec3 scale);

/// What a node says of where it is in its parent. Throws InputError where a matrix is not affine,
/// as far as float32 tells.
glm::dmat4 gltfTransformOf(const JsonValue& node);

} // namespace dirt
