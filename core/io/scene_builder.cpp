#include "core/io/scene_builder.h"

#include "core/io/find_file.h"
#include "core/io/place_gltf.h"
#include "core/io/place_mesh.h"
#include "core/io/text_file.h"

#include <algorithm>
#include <optional>

namespace dirt {

namespace fs = std::filesystem;

void SceneBuilder::readTexturesAhead(const std::vector<Model>& models, Executor& executor,
                                     const LoadProgress& progress) {
    Scene scene;
    LoadReport report;
    SceneBuilder announcing(scene, report);
    announcing.textures_.announce();
    for (const Model& model : models)
        std::visit([&](const auto& file) { announcing.resolveMaterials(file, true); }, model.file);
    textures_.readAhead(announcing.textures_, executor, progress);
}

void SceneBuilder::add(const Model& model, const glm::dmat4& toWorld, bool doubleSided) {
    report_.append(model.report);
    if (const auto* obj = std::get_if<ObjFile>(&model.file))
        placeMesh(*obj, toWorld, resolveMaterials(*obj, doubleSided), scene_.mesh);
    else if (const auto* gltf = std::get_if<GltfFile>(&model.file))
        placeGltf(*gltf, toWorld, resolveMaterials(*gltf, doubleSided), scene_.mesh);
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
std::vector<uint32_t> SceneBuilder::resolveMaterials(const ObjFile& obj, bool doubleSided) {
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
        places[i] = found == library.end()
                        ? neutralMaterial(name.text, doubleSided)
                        : addMaterial(found->second.first, found->second.second, doubleSided);
    }
    if (used.back()) places.back() = neutralMaterial("", doubleSided);
    return places;
}

uint32_t SceneBuilder::neutralMaterial(const std::string& name, bool doubleSided) {
    const auto [entry, isNew] = materials_.try_emplace({std::string(), name, doubleSided},
                                                       (uint32_t) scene_.materials.size());
    if (isNew) {
        Material material;
        material.name = printable(name);
        material.doubleSided = doubleSided;
        scene_.materials.push_back(std::move(material));
    }
    return entry->second;
}

uint32_t SceneBuilder::addMaterial(const fs::path& library, const MtlMaterial& source,
                                   bool doubleSided) {
    const auto [entry, isNew] = materials_.try_emplace({library.string(), source.name, doubleSided},
                                                       (uint32_t) scene_.materials.size());
    if (!isNew) return entry->second;
    Material material = source.material;
    material.doubleSided = doubleSided;
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

/// The file that a texture statement of \p library names.
TextureLoader::Source SceneBuilder::sourceOf(const fs::path& library, const MtlMaterial::Map& map) {
    const auto file = findFile(library.parent_path(), map.file);
    return {file ? std::optional<ImageFile>(*file) : std::nullopt, map.file, library, map.line};
}

uint32_t SceneBuilder::loadTexture(const fs::path& library, const MtlMaterial::Map& map) {
    return map.file.empty() ? kNoTexture : textures_.colour(sourceOf(library, map));
}

uint32_t SceneBuilder::loadScalars(const fs::path& library, const MtlMaterial::Map& map) {
    return map.file.empty() ? kNoTexture : textures_.data(sourceOf(library, map));
}

/// The alpha of map_d, else map_d itself; without one, the alpha of map_Kd.
uint32_t SceneBuilder::loadOpacity(const fs::path& library, const MtlMaterial& source) {
    const auto loadAlpha = [&](const MtlMaterial::Map& map) {
        return map.file.empty() ? kNoTexture : textures_.alpha(sourceOf(library, map));
    };
    if (source.opacity.file.empty()) return loadAlpha(source.diffuse);
    const uint32_t alpha = loadAlpha(source.opacity);
    return alpha != kNoTexture ? alpha : loadScalars(library, source.opacity);
}

/// For each of the file's surfaces its place in the scene; last, that of none.
std::vector<uint32_t> SceneBuilder::resolveMaterials(const GltfFile& gltf, bool doubleSided) {
    std::vector<bool> used(gltf.surfaces.size() + 1, false);
    for (const GltfFile::Instance& instance : gltf.instances)
        for (const GltfFile::Primitive& primitive : gltf.meshes[instance.mesh])
            used[std::min<size_t>(primitive.surface, gltf.surfaces.size())] = true;
    std::vector<uint32_t> places(used.size(), 0);
    for (size_t i = 0; i < gltf.surfaces.size(); ++i)
        if (used[i]) places[i] = addSurface(gltf, i, doubleSided);
    if (used.back()) places.back() = neutralMaterial("", doubleSided);
    return places;
}

uint32_t SceneBuilder::addSurface(const GltfFile& gltf, size_t index, bool doubleSided) {
    const auto [entry, isNew] = materials_.try_emplace(
        {gltf.file.string(), "materials[" + std::to_string(index) + "]", doubleSided},
        (uint32_t) scene_.materials.size());
    if (!isNew) return entry->second;
    const GltfFile::Surface& surface = gltf.surfaces[index];
    Material material = surface.material;
    material.doubleSided |= doubleSided;
    const auto sourceOf = [&](uint32_t image) { return gltf.images[image].source(gltf.file); };
    if (surface.colourImage != GltfFile::kNone) {
        const auto source = sourceOf(surface.colourImage);
        material.diffuseMap = textures_.colour(source, surface.material.diffuse);
        if (surface.alphaLimit > 0.0f)
            material.opacityMap = textures_.alpha(source, surface.alphaLimit);
    }
    if (surface.emissionImage != GltfFile::kNone)
        material.emissionMap = textures_.colour(sourceOf(surface.emissionImage));
    // Without the texture there is no telling which part of the surface shines.
    if (surface.emissionImage != GltfFile::kNone && material.emissionMap == kNoTexture)
        material.emission = glm::vec3(0.0f);
    if (surface.roughnessImage != GltfFile::kNone)
        if (const auto means = textures_.means(sourceOf(surface.roughnessImage)))
            setMetallicRoughness(material, surface.metallic * means->z,
                                 surface.roughness * means->y);
    scene_.materials.push_back(std::move(material));
    return entry->second;
}

} // namespace dirt
