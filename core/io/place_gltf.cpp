#include "core/io/place_gltf.h"

#include "core/io/lost_area.h"
#include "core/io/number.h"
#include "core/scene/transform.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

namespace dirt {

namespace {

/// One primitive on its way into the mesh. Only vertices that a triangle has get there.
class PrimitivePlacer {
public:
    PrimitivePlacer(const GltfFile& gltf, const GltfFile::Primitive& source,
                    const glm::dmat4& toWorld, Mesh& mesh)
        : gltf_(gltf), source_(source), toWorld_(toWorld),
          normalToWorld_(normalMatrix(glm::dmat3(toWorld))),
          mirrors_(glm::determinant(glm::dmat3(toWorld)) < 0.0), mesh_(mesh),
          vertices_(source.positions.size()) {}

    void place(uint32_t material) {
        for (const auto& triangle : source_.triangles) {
            Corners positions, normals, texcoords;
            for (size_t i = 0; i < 3; ++i) {
                const Vertex& vertex = placed(triangle[mirrors_ && i > 0 ? 3 - i : i]);
                positions[i] = vertex.position;
                normals[i] = vertex.normal;
                texcoords[i] = vertex.texcoord;
            }
            mesh_.triangles.push_back(positions);
            mesh_.normalIndices.push_back(allOrNone(normals));
            mesh_.texcoordIndices.push_back(allOrNone(texcoords));
            mesh_.materials.push_back(material);
            countLost(triangle, positions);
        }
    }

    /// Triangles that lost their area in the rounding so far.
    uint64_t lost() const { return lost_; }

private:
    /// Where a vertex is in the mesh.
    struct Vertex {
        uint32_t position = kNoIndex; ///< before its first use
        uint32_t normal = kNoIndex, texcoord = kNoIndex;
    };

    static Corners allOrNone(const Corners& c) {
        const bool all = std::find(c.begin(), c.end(), kNoIndex) == c.end();
        return all ? c : Corners{kNoIndex, kNoIndex, kNoIndex};
    }

    void countLost(const std::array<uint32_t, 3>& triangle, const Corners& corners) {
        std::array<glm::dvec3, 3> exact;
        std::array<glm::vec3, 3> rounded;
        for (size_t i = 0; i < 3; ++i) {
            exact[i] = inWorld(triangle[mirrors_ && i > 0 ? 3 - i : i]);
            rounded[i] = mesh_.positions[corners[i]];
        }
        if (losesArea(exact, rounded)) ++lost_;
    }

    glm::dvec3 inWorld(uint32_t index) const {
        return glm::dvec3(toWorld_ * glm::dvec4(source_.positions[index], 1.0));
    }

    const Vertex& placed(uint32_t index) {
        Vertex& vertex = vertices_[index];
        if (vertex.position != kNoIndex) return vertex;
        const glm::dvec3 p = inWorld(index);
        if (!fitsFloat(p))
            failAt(gltf_.file, 0, "a vertex does not fit in float32 after its transformation");
        vertex.position = (uint32_t) mesh_.positions.size();
        mesh_.positions.emplace_back(p);
        if (!source_.colors.empty()) placeColour(source_.colors[index]);
        if (!source_.normals.empty()) placeNormal(source_.normals[index], vertex);
        if (!source_.texcoords.empty()) placeTexcoord(source_.texcoords[index], vertex);
        return vertex;
    }

    /// Vertices before it that have none are white.
    void placeColour(glm::vec3 colour) {
        mesh_.colors.resize(mesh_.positions.size() - 1, glm::vec3(1.0f));
        mesh_.colors.push_back(colour);
    }

    void placeNormal(glm::vec3 normal, Vertex& vertex) {
        const glm::dvec3 n = normalToWorld_ * glm::dvec3(normal);
        const double length = std::sqrt(glm::dot(n, n));
        if (!(length > 0.0 && std::isfinite(length))) return;
        vertex.normal = (uint32_t) mesh_.normals.size();
        mesh_.normals.emplace_back(n / length);
    }

    /// glTF's v runs downwards.
    void placeTexcoord(glm::vec2 uv, Vertex& vertex) {
        if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return;
        vertex.texcoord = (uint32_t) mesh_.texcoords.size();
        mesh_.texcoords.emplace_back(uv.x, 1.0f - uv.y);
    }

    const GltfFile& gltf_;
    const GltfFile::Primitive& source_;
    glm::dmat4 toWorld_;
    glm::dmat3 normalToWorld_;
    bool mirrors_; ///< front and back change places, so corners do
    Mesh& mesh_;
    std::vector<Vertex> vertices_;
    uint64_t lost_ = 0;
};

} // namespace

uint64_t placeGltf(const GltfFile& gltf, const glm::dmat4& toWorld,
                   const std::vector<uint32_t>& materials, Mesh& mesh) {
    uint64_t lost = 0;
    for (const GltfFile::Instance& instance : gltf.instances)
        for (const GltfFile::Primitive& primitive : gltf.meshes[instance.mesh]) {
            PrimitivePlacer placer(gltf, primitive, toWorld * instance.toFile, mesh);
            placer.place(primitive.surface == GltfFile::kNone ? materials.back()
                                                              : materials[primitive.surface]);
            lost += placer.lost();
        }
    return lost;
}

} // namespace dirt
