// The OBJ reader, and the cutting of its polygons into triangles.

#include "core/io/obj.h"
#include "core/io/place_mesh.h"
#include "tests/fuzz/fuzzer.h"

#include <cmath>

namespace {

void check(bool holds) {
    if (!holds) std::abort();
}

/// What every user of a mesh relies on.
void checkMesh(const dirt::Mesh& mesh, size_t materials) {
    const size_t count = mesh.triangles.size();
    check(mesh.normalIndices.size() == count && mesh.texcoordIndices.size() == count &&
          mesh.materials.size() == count);
    const auto inRange = [](uint32_t index, size_t size) {
        return index == dirt::kNoIndex || index < size;
    };
    for (size_t i = 0; i < count; ++i) {
        check(mesh.materials[i] < materials);
        for (size_t k = 0; k < 3; ++k)
            check(mesh.triangles[i][k] < mesh.positions.size() &&
                  inRange(mesh.normalIndices[i][k], mesh.normals.size()) &&
                  inRange(mesh.texcoordIndices[i][k], mesh.texcoords.size()));
    }
    for (const glm::vec3& p : mesh.positions)
        check(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    return dirt::fuzz::readBytes(data, size, [](const std::filesystem::path& file) {
        dirt::LoadReport report;
        const dirt::ObjFile obj = dirt::readObj(file, report);
        std::vector<uint32_t> materials(obj.materialNames.size() + 1);
        for (size_t i = 0; i < materials.size(); ++i) materials[i] = (uint32_t) i;
        dirt::Mesh mesh;
        dirt::placeMesh(obj, glm::dmat4(1.0), materials, mesh);
        checkMesh(mesh, materials.size());
        // Every face of n corners gives n - 2 triangles.
        check(mesh.triangles.size() == obj.corners.size() - 2 * obj.faces.size());
    });
}
