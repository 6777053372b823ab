#include "core/io/place_models.h"

#include "core/io/mesh_size.h"
#include "core/io/scene_origin.h"

#include <map>
#include <string>

namespace dirt {

namespace {

namespace fs = std::filesystem;

/// Takes note of all positions and normals of \p mesh from the given ones on as what moves with a
/// space, in which \p origin is taken off them.
void addMovingPart(const Mesh& mesh, uint32_t space, const glm::dvec3& origin, size_t firstPosition,
                   size_t firstNormal, Animation& animation) {
    MovingPart& part = animation.parts.emplace_back();
    part.space = space;
    part.origin = origin;
    part.firstPosition = firstPosition;
    part.firstNormal = firstNormal;
    part.positions.assign(mesh.positions.begin() + (ptrdiff_t) firstPosition, mesh.positions.end());
    part.normals.assign(mesh.normals.begin() + (ptrdiff_t) firstNormal, mesh.normals.end());
}

/// Triangles of a file, as often as they are placed.
struct Rounded {
    uint64_t lost = 0; ///< without area in float32
    uint64_t triangles = 0;
};

void warnOfRounding(const fs::path& file, const Rounded& rounded, LoadReport& report) {
    if (rounded.lost > 0)
        report.warn(WarningKind::precision, file, 0,
                    std::to_string(rounded.lost) + " of " + std::to_string(rounded.triangles) +
                        " triangles are too small for float32 at their coordinates: they lose "
                        "their area");
}

/// Takes the memory of all that is placed, before any is, and makes room for it.
void makeRoom(std::span<const Placed> list, std::span<const SceneBuilder::Use> uses,
              const MemoryBudget& budget, Mesh& mesh) {
    MeshSize sum;
    for (size_t i = 0; i < list.size(); ++i) {
        const MeshSize size = placedSize(*uses[i].model);
        const bool moves = list[i].space != MovingSpace::kWorld;
        const uint64_t copied = moves ? size.positions + size.normals : 0;
        budget.spend(size.bytes() + copied * sizeof(glm::vec3), list[i].file,
                     "each of " + std::to_string(size.triangles) +
                         " triangles, as often as it is "
                         "placed,");
        sum += size;
    }
    reserve(sum, mesh);
}

} // namespace

void placeModels(std::span<const Placed> list, std::span<const SceneBuilder::Use> uses,
                 const MemoryBudget& budget, SceneBuilder& builder, LoadReport& report,
                 LoadedScene& loaded) {
    Scene& scene = loaded.scene;
    makeRoom(list, uses, budget, scene.mesh);
    OriginFinder origins(scene.animation);
    for (size_t i = 0; i < list.size(); ++i)
        origins.add(*uses[i].model, list[i].toSpace, list[i].space);
    scene.origin = origins.ofWorld();
    std::map<fs::path, Rounded> perFile;
    for (size_t i = 0; i < list.size(); ++i) {
        const Placed& placed = list[i];
        const size_t positions = scene.mesh.positions.size(), normals = scene.mesh.normals.size();
        const glm::dvec3 origin = origins.ofSpace(i);
        const size_t triangles = scene.mesh.triangles.size();
        Rounded& rounded = perFile[placed.file];
        rounded.lost +=
            builder.add(uses[i], relativeTo(origin, placed.toSpace), placed.doubleSided);
        rounded.triangles += scene.mesh.triangles.size() - triangles;
        if (placed.space != MovingSpace::kWorld)
            addMovingPart(scene.mesh, placed.space, origin, positions, normals, scene.animation);
        else
            placeModelViews(*uses[i].model, relativeTo(origin, placed.toSpace), report,
                            loaded.cameras, scene.lights);
    }
    for (const Placed& placed : list) warnOfRounding(placed.file, perFile[placed.file], report);
    loaded.materialFiles = builder.materialFiles();
}

} // namespace dirt
