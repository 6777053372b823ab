// The glTF reader, text and binary, and the placement of what it read.

#include "core/io/gltf.h"
#include "core/io/place_gltf.h"
#include "tests/fuzz/fuzzer.h"

#include <cmath>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    return dirt::fuzz::readBytes(data, size, [](const std::filesystem::path& file) {
        dirt::LoadReport report;
        const dirt::GltfFile gltf = dirt::readGltf(file, report);
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
        dirt::Mesh mesh;
        placeGltf(gltf, glm::dmat4(1.0), std::vector<uint32_t>(gltf.surfaces.size() + 1), mesh);
        if (mesh.triangles.size() != triangles) std::abort();
        for (const dirt::Corners& corners : mesh.triangles)
            for (const uint32_t corner : corners)
                if (!(corner < mesh.positions.size() && std::isfinite(mesh.positions[corner].x)))
                    std::abort();
    });
}
