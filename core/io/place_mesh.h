#pragma once

#include "core/io/obj.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>

namespace dirt {

/// Appends the faces of an OBJ file to a mesh: placed by \p toWorld (in double, rounded to float32
/// once), cut into triangles, without the vertices that no face uses. \p materials holds, for each
/// of the file's material names, its place in the scene, and last that of faces before the first
/// usemtl. A triangle has normals (texture coordinates) only if all its corners have finite ones,
/// and the normals are not zero. Positions of a file with
/// colours get theirs; those before them without, white. Returns how many triangles lose their area
/// in the rounding to float32. Throws InputError where a transformed position does not fit in
/// float32.
uint64_t placeMesh(const ObjFile& obj, const glm::dmat4& toWorld,
                   const std::vector<uint32_t>& materials, Mesh& mesh);

} // namespace dirt
