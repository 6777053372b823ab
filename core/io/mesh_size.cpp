#include "core/io/mesh_size.h"

namespace dirt {

namespace {

MeshSize sizeOf(const ObjFile& obj) {
    MeshSize size;
    size.triangles = obj.corners.size() - 2 * obj.faces.size(); // n - 2 of n corners
    size.positions = obj.positions.size();
    size.normals = obj.normals.size();
    size.texcoords = obj.texcoords.size();
    size.colors = obj.colors.size();
    return size;
}

MeshSize sizeOf(const GltfFile& gltf) {
    std::vector<MeshSize> meshes;
    for (const auto& primitives : gltf.meshes) {
        MeshSize& size = meshes.emplace_back();
        for (const GltfFile::Primitive& primitive : primitives)
            size += {primitive.triangles.size(), primitive.positions.size(),
                     primitive.normals.size(), primitive.texcoords.size(), primitive.colors.size()};
    }
    MeshSize sum;
    for (const GltfFile::Instance& instance : gltf.instances) sum += meshes[instance.mesh];
    return sum;
}

} // namespace

MeshSize& MeshSize::operator+=(const MeshSize& other) {
    triangles += other.triangles;
    positions += other.positions;
    normals += other.normals;
    texcoords += other.texcoords;
    colors += other.colors;
    return *this;
}

uint64_t MeshSize::bytes() const {
    return triangles * (3 * sizeof(Corners) + sizeof(uint32_t)) +
           (positions + normals + colors) * sizeof(glm::vec3) + texcoords * sizeof(glm::vec2);
}

MeshSize placedSize(const Model& model) {
    if (const auto* obj = std::get_if<ObjFile>(&model.file)) return sizeOf(*obj);
    return sizeOf(std::get<GltfFile>(model.file));
}

void reserve(const MeshSize& more, Mesh& mesh) {
    const auto makeRoom = [](auto& array, uint64_t count) { array.reserve(array.size() + count); };
    makeRoom(mesh.triangles, more.triangles);
    makeRoom(mesh.normalIndices, more.triangles);
    makeRoom(mesh.texcoordIndices, more.triangles);
    makeRoom(mesh.materials, more.triangles);
    makeRoom(mesh.positions, more.positions);
    makeRoom(mesh.normals, more.normals);
    makeRoom(mesh.texcoords, more.texcoords);
    if (more.colors > 0) makeRoom(mesh.colors, more.positions);
}

} // namespace dirt
