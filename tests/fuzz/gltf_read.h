#pragma once

#include "core/io/gltf.h"
#include "core/io/place_gltf.h"
#include "tests/fuzz/fuzzer.h"

#include <cmath>

namespace dirt::fuzz {

/// Reads and places a glTF file; aborts where what it gives cannot be.
inline void readGltfWhole(const std::filesystem::path& file) {
    LoadReport report;
    const GltfFile gltf = readGltf(file, report);
    for (const auto& surface : gltf.surfaces)
        for (int i = 0; i < 3; ++i) // written so that NaN fails
            if (!(surface.material.diffuse[i] >= 0.0f && surface.material.emission[i] >= 0.0f))
                std::abort();
    // Many nodes may place many triangles, which is slow but no find.
    size_t triangles = 0;
    for (const auto& instance : gltf.instances)
        for (const auto& primitive : gltf.meshes[instance.mesh])
            triangles += primitive.triangles.size();
    if (triangles > 1'000'000) return;
    Mesh mesh;
    placeGltf(gltf, glm::dmat4(1.0), std::vector<uint32_t>(gltf.surfaces.size() + 1), mesh);
    if (mesh.triangles.size() != triangles) std::abort();
    for (const Corners& corners : mesh.triangles)
        for (const uint32_t corner : corners)
            if (!(corner < mesh.positions.size() && std::isfinite(mesh.positions[corner].x)))
                std::abort();
}

} // namespace dirt::fuzz
