#pragma once

#include "core/io/gltf.h"

namespace dirt {

/// Looks through the vertices that \p primitive's triangles use. Normals that are not finite or
/// zero, and texture coordinates that are not finite, are \p faults, as placeGltf leaves them out;
/// so is a position that no triangle uses and that is not finite. Throws InputError at \p source
/// where a triangle uses one.
void checkVertices(const GltfFile::Primitive& primitive, const JsonValue& source,
                   FaultCounter& faults);

} // namespace dirt
