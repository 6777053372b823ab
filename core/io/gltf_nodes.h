#pragma once

#include "core/io/gltf.h"
#include "core/io/gltf_members.h"

namespace dirt {

/// Adds to \p gltf, whose meshes have been read, what the nodes of the file's scene place: meshes,
/// cameras and the spotlight. Without scenes all nodes that are no one's child are roots. Throws
/// InputError where a node is its own ancestor or has two parents, or there are absurdly many
/// triangles. \p memory takes what the instances need.
void placeGltfNodes(const GltfData& data, GltfFile& gltf, GltfIgnored& ignored,
                    MemoryClaim& memory);

} // namespace dirt
