#include "core/io/scene_builder.h"

#include "core/io/error.h"
#include "core/io/find_file.h"
#include "core/io/place_mesh.h"
#include "core/io/text_file.h"
#include "core/io/texture_file.h"

#include <optional>

namespace dirt {

namespace fs = std::filesystem;

void SceneBuilder::addObj(const fs::path& file, const glm::dmat4& toWorld) {
    const ObjFile obj = readObj(file, report_);
    placeMesh(obj, toWorld, resolveMaterials(obj), scene_.mesh);
}

/// Every material of the files that mtllib names; of equal names the first counts.
SceneBuilder::Library SceneBuilder::readLibraries(const ObjFile& obj) {
    Library library;
    const fs::path folder = obj.file.parent_path();
    for (const ObjFile::Name& name : obj.libraries) {
        // A name may hold blanks; but blanks may also separate several names.
        if (const auto whole = findFile(folder, name.text)) {
            readLibrary(*whole, library);
            continue;
        }
        std::vector<std::string> missing;
        bool found = false;
        std::string_view rest = name.text;
        for (auto word = takeWord(rest); !word.empty(); word = takeWord(rest)) {
            if (const auto part = findFile(folder, word)) {
                readLibrary(*part, library);
                found = true;
            } else {
                missing.emplace_back(word);
            }
        }
        if (!found) missing = {name.text};
        for (const std::string& text : missing)
            report_.warn(WarningKind::missingMaterialLibrary, obj.file, name.line,
                         "material file " + inQuotes(text) + " not found");
    }
    return library;
}

void SceneBuilder::readLibrary(const fs::path& file, Library& library) {
    for (MtlMaterial& material : readMtl(file, report_)) {
        std::string name = material.name;
        library.try_emplace(std::move(name), file, std::move(material));
    }
}

/// For each of the file's material names its place in the scene; last, that of unnamed ones.
std::vector<uint32_t> SceneBuilder::resolveMaterials(const ObjFile& obj) {
    const Library library = readLibraries(obj);
    std::vector<bool> used(obj.materialNames.size() + 1, false);
    for (const ObjFile::Face& face : obj.faces)
        used[face.material == ObjFile::kNone ? used.size() - 1 : face.material] = true;

    std::vector<uint32_t> places(used.size(), 0);
    for (size_t i = 0; i < obj.materialNames.size(); ++i) {
        const ObjFile::Name& name = obj.materialNames[i];
        const auto found = library.find(name.text);
        if (found == library.end())
            report_.warn(WarningKind::undefinedMaterial, obj.file, name.line,
                         "material " + inQuotes(name.text) + " is not defined");
        if (!used[i]) continue;
        places[i] = found == library.end() ? neutralMaterial(name.text)
                                           : addMaterial(found->second.first, found->second.second);
    }
    if (used.back()) places.back() = neutralMaterial("");
    return places;
}

uint32_t SceneBuilder::neutralMaterial(const std::string& name) {
    const auto [entry, isNew] =
        materials_.try_emplace({std::string(), name}, (uint32_t) scene_.materials.size());
    if (isNew) {
        Material material;
        material.name = printable(name);
        scene_.materials.push_back(std::move(material));
    }
    return entry->second;
}

uint32_t SceneBuilder::addMaterial(const fs::path& library, const MtlMaterial& source) {
    const auto [entry, isNew] =
        materials_.try_emplace({library.string(), source.name}, (uint32_t) scene_.materials.size());
    if (!isNew) return entry->second;
    Material material = source.material;
    material.diffuseMap = loadTexture(library, source.diffuse);
    // Kd says nothing of what the texture would have shown; often it is black.
    if (!source.diffuse.file.empty() && material.diffuseMap == kNoTexture)
        material.diffuse = Material().diffuse;
    material.emissionMap = loadTexture(library, source.emission);
    material.reflectanceMap = loadScalars(library, source.reflectance);
    material.bumpMap = loadScalars(library, source.bump);
    material.opacityMap = loadOpacity(library, source);
    scene_.materials.push_back(std::move(material));
    return entry->second;
}

template <typename T, typename Read>
uint32_t SceneBuilder::loadMap(const fs::path& library, const MtlMaterial::Map& map,
                               const char* what, std::vector<T>& textures, const Read& read) {
    if (map.file.empty()) return kNoTexture;
    const fs::path folder = library.parent_path();
    const std::optional<fs::path> file = findFile(folder, map.file);
    const std::string key = file ? file->string() : (folder / map.file).string();
    const auto [entry, isNew] = textures_.try_emplace({key, what}, kNoTexture);
    if (!isNew) return entry->second;

    const std::string name = "texture " + inQuotes(map.file);
    if (!file) {
        report_.warn(WarningKind::unusableTexture, library, map.line, name + " not found");
        return kNoTexture;
    }
    try {
        std::optional<T> texture = read(*file);
        if (!texture) return kNoTexture;
        textures.push_back(std::move(*texture));
        entry->second = (uint32_t) textures.size() - 1;
    } catch (const InputError& error) {
        report_.warn(WarningKind::unusableTexture, library, map.line, name + ": " + error.what());
    }
    return entry->second;
}

uint32_t SceneBuilder::loadTexture(const fs::path& library, const MtlMaterial::Map& map) {
    return loadMap(library, map, "colour", scene_.textures,
                   [](const fs::path& file) { return std::optional(readTexture(file)); });
}

uint32_t SceneBuilder::loadScalars(const fs::path& library, const MtlMaterial::Map& map) {
    return loadMap(library, map, "data", scene_.scalarTextures,
                   [](const fs::path& file) { return std::optional(readScalarTexture(file)); });
}

/// The alpha of map_d, else map_d itself; without one, the alpha of map_Kd.
uint32_t SceneBuilder::loadOpacity(const fs::path& library, const MtlMaterial& source) {
    const auto loadAlpha = [&](const MtlMaterial::Map& map) {
        return loadMap(library, map, "alpha", scene_.scalarTextures, readAlpha);
    };
    if (source.opacity.file.empty()) return loadAlpha(source.diffuse);
    const uint32_t alpha = loadAlpha(source.opacity);
    return alpha != kNoTexture ? alpha : loadScalars(library, source.opacity);
}

} // namespace dirt
