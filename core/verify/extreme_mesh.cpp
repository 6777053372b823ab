#include "core/verify/extreme_mesh.h"

#include <algorithm>

namespace dirt {

Bounds boundsOf(const Mesh& mesh) {
    Bounds bounds;
    for (const Corners& corners : mesh.triangles)
        for (const uint32_t corner : corners) bounds.include(mesh.positions[corner]);
    return bounds;
}

double sizeOf(const Mesh& mesh) {
    const Bounds bounds = boundsOf(mesh);
    const glm::dvec3 edges = bounds.high - bounds.low;
    const double size = std::max({edges.x, edges.y, edges.z});
    return size > 0.0 ? size : 1.0;
}

std::vector<uint32_t> sampleTriangles(const Mesh& mesh, uint32_t most) {
    std::vector<uint32_t> ids;
    const uint64_t count = mesh.triangles.size(), samples = std::min<uint64_t>(count, most);
    for (uint64_t i = 0; i < samples; i++) ids.push_back((uint32_t) (i * count / samples));
    return ids;
}

uint32_t addGrey(Scene& scene) {
    scene.materials.emplace_back();
    return (uint32_t) scene.materials.size() - 1;
}

uint32_t addVertex(Mesh& mesh, glm::vec3 p) {
    mesh.positions.push_back(p);
    if (!mesh.colors.empty()) mesh.colors.emplace_back(1.0f);
    return (uint32_t) mesh.positions.size() - 1;
}

void addTriangle(Mesh& mesh, const Corners& corners, uint32_t material) {
    constexpr Corners kNone{kNoIndex, kNoIndex, kNoIndex};
    mesh.triangles.push_back(corners);
    mesh.normalIndices.push_back(kNone);
    mesh.texcoordIndices.push_back(kNone);
    mesh.materials.push_back(material);
}

void addTriangle(Mesh& mesh, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                 uint32_t material) {
    const uint32_t first = addVertex(mesh, glm::vec3(a));
    addVertex(mesh, glm::vec3(b));
    addVertex(mesh, glm::vec3(c));
    addTriangle(mesh, {first, first + 1, first + 2}, material);
}

} // namespace dirt
