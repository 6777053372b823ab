#pragma once

#include "core/io/gltf.h"
#include "core/io/load_report.h"
#include "core/io/mtl.h"
#include "core/io/obj.h"
#include "core/io/texture_loader.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>

namespace dirt {

/// Gathers OBJ and glTF files, their materials and textures into one Scene. A texture that several
/// materials name is loaded once; so is a material that several files use. Materials that no face
/// uses are not loaded.
class SceneBuilder {
public:
    /// \p cache: whether OBJ files are read through their caches (see readObjCached).
    SceneBuilder(Scene& scene, LoadReport& report, bool cache = false)
        : scene_(scene), report_(report), cache_(cache), textures_(scene, report) {}

    /// Appends the triangles of an OBJ file, placed by \p toWorld: computed in double, rounded to
    /// float32 once. Throws InputError where the file is bad (see readObj) or a transformed vertex
    /// does not fit in float32. A missing MTL file, an undefined material and a missing or damaged
    /// texture are warnings; Material's defaults stand in.
    void addObj(const std::filesystem::path& file, const glm::dmat4& toWorld);

    /// The same for a glTF file (see readGltf).
    void addGltf(const std::filesystem::path& file, const glm::dmat4& toWorld);

private:
    using Library = std::map<std::string, std::pair<std::filesystem::path, MtlMaterial>>;

    Library readLibraries(const ObjFile& obj);
    void readLibrary(const std::filesystem::path& file, Library& library);
    std::vector<uint32_t> resolveMaterials(const ObjFile& obj);
    uint32_t addMaterial(const std::filesystem::path& library, const MtlMaterial& source);
    uint32_t addSurface(const GltfFile& gltf, size_t index);
    uint32_t neutralMaterial(const std::string& name);
    static TextureLoader::Source sourceOf(const std::filesystem::path& library,
                                          const MtlMaterial::Map& map);
    uint32_t loadTexture(const std::filesystem::path& library, const MtlMaterial::Map& map);
    uint32_t loadScalars(const std::filesystem::path& library, const MtlMaterial::Map& map);
    uint32_t loadOpacity(const std::filesystem::path& library, const MtlMaterial& source);

    Scene& scene_;
    LoadReport& report_;
    bool cache_;
    /// By MTL file and name; without a file: the stand-ins.
    std::map<std::pair<std::string, std::string>, uint32_t> materials_;
    TextureLoader textures_;
};

} // namespace dirt
