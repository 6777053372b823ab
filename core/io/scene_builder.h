#pragma once

#include "core/io/load_report.h"
#include "core/io/material_libraries.h"
#include "core/io/model.h"
#include "core/io/texture_loader.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include <glm/mat4x4.hpp>

namespace dirt {

/// Gathers OBJ and glTF files, their materials and textures into one Scene. A texture that several
/// materials name is loaded once; so is a material that several files use. Materials that no face
/// uses are not loaded.
class SceneBuilder {
public:
    SceneBuilder(Scene& scene, LoadReport& report, const MemoryBudget& budget = {})
        : scene_(scene), report_(report), libraries_(report, budget),
          textures_(scene, report, budget) {}

    /// Makes materials as if they named no textures, from now on.
    void leaveOutTextures() { textures_.announce(); }

    /// A model, and how its MTL files are to be taken.
    struct Use {
        const Model* model;
        MaterialChoice materials;
    };

    /// Reads the textures that the models' materials will ask for on threads, ahead of add().
    void readTexturesAhead(std::span<const Use> uses, Executor& executor,
                           const LoadProgress& progress);

    /// Appends the triangles of a model, placed by \p toWorld: computed in double, rounded to
    /// float32 once. Throws InputError where an MTL file cannot be read or a transformed vertex
    /// does not fit in float32. A missing MTL file, an undefined material and a missing or damaged
    /// texture are warnings; Material's defaults stand in.
    /// Its surfaces are all \p doubleSided, or those alone that a glTF file says are. Returns how
    /// many triangles lose their area in the rounding.
    uint64_t add(const Use& use, const glm::dmat4& toWorld, bool doubleSided);

    /// How the MTL files were taken, each way once.
    const std::vector<MaterialFile>& materialFiles() const { return libraries_.files(); }

private:
    /// Places in the scene of the model's materials, and last that of none. They are looked for
    /// once, however often the model is placed.
    const std::vector<uint32_t>& materialsOf(const Use& use, bool doubleSided);
    std::vector<uint32_t> resolveMaterials(const ObjFile& obj, const MaterialChoice& choice,
                                           bool doubleSided);
    std::vector<uint32_t> resolveMaterials(const GltfFile& gltf, bool doubleSided);
    uint32_t addMaterial(const MaterialLibraries::Entry& entry, bool doubleSided);
    void warnIfUnseen(const std::filesystem::path& library, const MtlMaterial& source,
                      float opacity);
    uint32_t addSurface(const GltfFile& gltf, size_t index, bool doubleSided);
    uint32_t neutralMaterial(const std::string& name, bool doubleSided);

    Scene& scene_;
    LoadReport& report_;
    MaterialLibraries libraries_;
    std::set<const Model*> reported_;
    /// By model, how its MTL files are taken, and whether all is double-sided.
    std::map<std::tuple<const Model*, MaterialChoice, bool>, std::vector<uint32_t>> resolved_;
    /// By file, name and convention (none for glTF); without a file: the stand-ins.
    std::map<std::tuple<std::string, std::string, std::optional<MaterialConvention>, bool>,
             uint32_t>
        materials_;
    TextureLoader textures_;
};

} // namespace dirt
