#pragma once

#include "core/io/load_report.h"
#include "core/io/model.h"
#include "core/io/mtl.h"
#include "core/io/texture_loader.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>

namespace dirt {

/// Gathers OBJ and glTF files, their materials and textures into one Scene. A texture that several
/// materials name is loaded once; so is a material that several files use. Materials that no face
/// uses are not loaded.
class SceneBuilder {
public:
    SceneBuilder(Scene& scene, LoadReport& report)
        : scene_(scene), report_(report), textures_(scene, report) {}

    /// Reads the textures that the models' materials will ask for on threads, ahead of add().
    void readTexturesAhead(const std::vector<Model>& models, Executor& executor,
                           const LoadProgress& progress);

    /// Appends the triangles of a model, placed by \p toWorld: computed in double, rounded to
    /// float32 once. Throws InputError where an MTL file is bad (see readMtl) or a transformed
    /// vertex does not fit in float32. A missing MTL file, an undefined material and a missing or
    /// damaged texture are warnings; Material's defaults stand in.
    /// Its surfaces are all \p doubleSided, or those alone that a glTF file says are.
    void add(const Model& model, const glm::dmat4& toWorld, bool doubleSided);

private:
    using Library = std::map<std::string, std::pair<std::filesystem::path, MtlMaterial>>;

    Library readLibraries(const ObjFile& obj);
    void readLibrary(const std::filesystem::path& file, Library& library);
    std::vector<uint32_t> resolveMaterials(const ObjFile& obj, bool doubleSided);
    std::vector<uint32_t> resolveMaterials(const GltfFile& gltf, bool doubleSided);
    uint32_t addMaterial(const std::filesystem::path& library, const MtlMaterial& source,
                         bool doubleSided);
    uint32_t addSurface(const GltfFile& gltf, size_t index, bool doubleSided);
    uint32_t neutralMaterial(const std::string& name, bool doubleSided);
    static TextureLoader::Source sourceOf(const std::filesystem::path& library,
                                          const MtlMaterial::Map& map);
    uint32_t loadTexture(const std::filesystem::path& library, const MtlMaterial::Map& map);
    uint32_t loadScalars(const std::filesystem::path& library, const MtlMaterial::Map& map);
    uint32_t loadOpacity(const std::filesystem::path& library, const MtlMaterial& source);

    Scene& scene_;
    LoadReport& report_;
    /// By MTL file and name; without a file: the stand-ins.
    std::map<std::tuple<std::string, std::string, bool>, uint32_t> materials_;
    TextureLoader textures_;
};

} // namespace dirt
