#include "core/io/place_mesh.h"

#include "core/io/ear_clipping.h"
#include "core/io/lost_area.h"
#include "core/io/number.h"
#include "core/scene/transform.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

namespace dirt {

namespace {

class MeshPlacer {
public:
    MeshPlacer(const ObjFile& obj, const glm::dmat4& toWorld, Mesh& mesh)
        : obj_(obj), toWorld_(toWorld), normalToWorld_(normalMatrix(glm::dmat3(toWorld))),
          mirrors_(glm::determinant(glm::dmat3(toWorld)) < 0.0), mesh_(mesh),
          positions_(obj.positions.size(), kPending), normals_(obj.normals.size(), kPending),
          texcoords_(obj.texcoords.size(), kPending) {}

    uint64_t place(const std::vector<uint32_t>& materials) {
        for (const ObjFile::Face& face : obj_.faces)
            placeFace(face, face.material == ObjFile::kNone ? materials.back()
                                                            : materials[face.material]);
        return lost_;
    }

private:
    static constexpr uint32_t kPending = kNoIndex - 1;

    void placeFace(const ObjFile::Face& face, uint32_t material) {
        polygon_.clear();
        corners_.clear();
        for (size_t i = 0; i < face.corners; ++i) {
            const ObjFile::Corner& corner = obj_.corners[face.firstCorner + i];
            corners_.push_back({position(corner.position, face.line), texcoord(corner.texcoord),
                                normal(corner.normal)});
            polygon_.push_back(mesh_.positions[corners_.back().position]);
        }
        for (const EarClipper::Ear& ear : clip_(polygon_)) {
            mesh_.triangles.push_back(gather(ear, &ObjFile::Corner::position));
            mesh_.texcoordIndices.push_back(allOrNone(gather(ear, &ObjFile::Corner::texcoord)));
            mesh_.normalIndices.push_back(allOrNone(gather(ear, &ObjFile::Corner::normal)));
            mesh_.materials.push_back(material);
            countLost(face, ear);
        }
    }

    void countLost(const ObjFile::Face& face, const EarClipper::Ear& ear) {
        std::array<glm::dvec3, 3> exact;
        std::array<glm::vec3, 3> rounded;
        for (size_t k = 0; k < 3; ++k) {
            exact[k] = inWorld(obj_.corners[face.firstCorner + ear[k]].position);
            rounded[k] = polygon_[ear[k]];
        }
        if (losesArea(exact, rounded)) ++lost_;
    }

    glm::dvec3 inWorld(uint32_t index) const {
        return glm::dvec3(toWorld_ * glm::dvec4(obj_.positions[index], 1.0));
    }

    Corners gather(const EarClipper::Ear& ear, uint32_t ObjFile::Corner::*attribute) const {
        return {corners_[ear[0]].*attribute, corners_[ear[mirrors_ ? 2 : 1]].*attribute,
                corners_[ear[mirrors_ ? 1 : 2]].*attribute};
    }

    static Corners allOrNone(const Corners& c) {
        const bool all = c[0] != kNoIndex && c[1] != kNoIndex && c[2] != kNoIndex;
        return all ? c : Corners{kNoIndex, kNoIndex, kNoIndex};
    }

    uint32_t position(uint32_t index, size_t line) {
        uint32_t& placed = positions_[index];
        if (placed != kPending) return placed;
        const glm::dvec3 p = inWorld(index);
        if (!fitsFloat(p))
            failAt(obj_.file, line,
                   "vertex " + std::to_string(index + 1ull) +
                       " does not fit in float32 after its transformation");
        placed = (uint32_t) mesh_.positions.size();
        mesh_.positions.emplace_back(p);
        if (!obj_.colors.empty()) {
            // What came from files without colours is white.
            mesh_.colors.resize(placed, glm::vec3(1.0f));
            mesh_.colors.push_back(obj_.colors[index]);
        }
        return placed;
    }

    uint32_t normal(uint32_t index) {
        if (index == ObjFile::kNone) return kNoIndex;
        uint32_t& placed = normals_[index];
        if (placed != kPending) return placed;
        const glm::dvec3 n = normalToWorld_ * obj_.normals[index];
        const double length = std::sqrt(glm::dot(n, n));
        if (!(length > 0.0 && std::isfinite(length))) return placed = kNoIndex;
        placed = (uint32_t) mesh_.normals.size();
        mesh_.normals.emplace_back(n / length);
        return placed;
    }

    uint32_t texcoord(uint32_t index) {
        if (index == ObjFile::kNone) return kNoIndex;
        uint32_t& placed = texcoords_[index];
        if (placed != kPending) return placed;
        const glm::dvec2 uv = obj_.texcoords[index];
        if (!fitsFloat(uv.x) || !fitsFloat(uv.y)) return placed = kNoIndex;
        placed = (uint32_t) mesh_.texcoords.size();
        mesh_.texcoords.emplace_back(uv);
        return placed;
    }

    const ObjFile& obj_;
    glm::dmat4 toWorld_;
    glm::dmat3 normalToWorld_;
    bool mirrors_; ///< front and back change places, so corners do
    Mesh& mesh_;
    /// Where each of the file's attributes is in the mesh; kPending before its first use.
    std::vector<uint32_t> positions_, normals_, texcoords_;
    uint64_t lost_ = 0; ///< triangles without area after the rounding
    EarClipper clip_;
    std::vector<glm::vec3> polygon_;       ///< corners of the face at hand
    std::vector<ObjFile::Corner> corners_; ///< and their places in the mesh
};

} // namespace

uint64_t placeMesh(const ObjFile& obj, const glm::dmat4& toWorld,
                   const std::vector<uint32_t>& materials, Mesh& mesh) {
    return MeshPlacer(obj, toWorld, mesh).place(materials);
}

} // namespace dirt
