#pragma once

#include "core/io/gltf.h"
#include "core/io/gltf_members.h"

#include <span>
#include <vector>

namespace dirt {

/// The triangles of a mesh: lists, strips and fans, also compressed ones. Points and lines are
/// skipped; what checkVertices finds is \p faults. Throws InputError where a primitive is
/// malformed, or all that it is made of lies in an extension that is not known. \p memory takes
/// what they need.
std::vector<GltfFile::Primitive> gltfPrimitives(const GltfData& data, const JsonValue& mesh,
                                                std::span<const GltfFile::Surface> surfaces,
                                                GltfIgnored& ignored, FaultCounter& faults,
                                                MemoryClaim& memory);

} // namespace dirt
