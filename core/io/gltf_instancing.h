#pragma once

#include "core/io/gltf_data.h"

#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>

namespace dirt {

/// Where EXT_mesh_gpu_instancing puts a node's mesh, relative to the node; nothing where it does
/// not. Throws InputError where an instance is not finite, or its attributes differ in length.
std::optional<std::vector<glm::dmat4>> gltfInstances(const GltfData& data, const JsonValue& node);

} // namespace dirt
