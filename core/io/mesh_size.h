#pragma once

#include "core/io/model.h"
#include "core/scene/scene.h"

#include <cstdint>

namespace dirt {

/// How much of a mesh a model becomes, at most: unused vertices, which are left out, count here.
struct MeshSize {
    uint64_t triangles = 0, positions = 0, normals = 0, texcoords = 0, colors = 0;

    MeshSize& operator+=(const MeshSize& other);
    uint64_t bytes() const;
};

/// Of one placement of \p model.
MeshSize placedSize(const Model& model);

/// Makes room for \p more in all of \p mesh.
void reserve(const MeshSize& more, Mesh& mesh);

} // namespace dirt
