#pragma once

#include "core/io/gltf.h"
#include "core/scene/scene.h"

#include <vector>

namespace dirt {

/// Appends the triangles of a glTF file to \p mesh, placed by \p toWorld over their nodes: computed
/// in double, rounded to float32 once. \p materials has each surface's place in the scene, and last
/// that of none. Returns how many triangles lose their area in the rounding. Throws InputError
/// where a transformed vertex does not fit in float32.
uint64_t placeGltf(const GltfFile& gltf, const glm::dmat4& toWorld,
                   const std::vector<uint32_t>& materials, Mesh& mesh);

} // namespace dirt
