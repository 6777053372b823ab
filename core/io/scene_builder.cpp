#include "core/io/scene_builder.h"

#include "core/io/load_gltf_material.h"
#include "core/io/mtl_material.h"
#include "core/io/mtl_textures.h"
#include "core/io/place_gltf.h"
#include "core/io/place_mesh.h"

#include <algorithm>
#include <cstdio>
#include <optional>

namespace dirt {

namespace fs = std::filesystem;

void SceneBuilder::readTexturesAhead(std::span<const Use> uses, Executor& executor,
                                     const LoadProgress& progress) {
    Scene scene;
    LoadReport report;
    SceneBuilder announcing(scene, report, textures_.budget());
    announcing.leaveOutTextures();
    for (const Use& use : uses) announcing.materialsOf(use, true);
    textures_.readAhead(announcing.textures_, executor, progress);
}

uint64_t SceneBuilder::add(const Use& use, const glm::dmat4& toWorld, bool doubleSided) {
    if (reported_.insert(use.model).second) report_.append(use.model->report);
    const std::vector<uint32_t>& materials = materialsOf(use, doubleSided);
    if (const auto* obj = std::get_if<ObjFile>(&use.model->file))
        return placeMesh(*obj, toWorld, materials, scene_.mesh);
    return placeGltf(std::get<GltfFile>(use.model->file), toWorld, materials, scene_.mesh);
}

const std::vector<uint32_t>& SceneBuilder::materialsOf(const Use& use, bool doubleSided) {
    const auto [known, isNew] = resolved_.try_emplace({use.model, use.materials, doubleSided});
    if (!isNew) return known->second;
    if (const auto* obj = std::get_if<ObjFile>(&use.model->file))
        return known->second = resolveMaterials(*obj, use.materials, doubleSided);
    return known->second = resolveMaterials(std::get<GltfFile>(use.model->file), doubleSided);
}

/// For each of the file's material names its place in the scene; last, that of unnamed ones.
std::vector<uint32_t>
SceneBuilder::resolveMaterials(const ObjFile& obj, const MaterialChoice& choice, bool doubleSided) {
    const MaterialLibraries::Library library = libraries_.of(obj, choice);
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
        places[i] = found == library.end() ? neutralMaterial(name.text, doubleSided)
                                           : addMaterial(found->second, doubleSided);
    }
    if (used.back()) places.back() = neutralMaterial("", doubleSided);
    return places;
}

uint32_t SceneBuilder::neutralMaterial(const std::string& name, bool doubleSided) {
    const auto [entry, isNew] = materials_.try_emplace(
        {std::string(), name, std::nullopt, doubleSided}, (uint32_t) scene_.materials.size());
    if (isNew) {
        Material material;
        material.name = printable(name);
        material.doubleSided = doubleSided;
        scene_.materials.push_back(std::move(material));
    }
    return entry->second;
}

uint32_t SceneBuilder::addMaterial(const MaterialLibraries::Entry& entry, bool doubleSided) {
    const MtlMaterial& source = *entry.material;
    const fs::path& library = entry.file->file;
    const auto [place, isNew] =
        materials_.try_emplace({library.string(), source.name, entry.convention, doubleSided},
                               (uint32_t) scene_.materials.size());
    if (!isNew) return place->second;
    Material material = materialOf(source, entry.convention);
    material.doubleSided = doubleSided;
    warnIfUnseen(library, source, material.opacity);
    addTextures(entry, textures_, report_, material);
    scene_.materials.push_back(std::move(material));
    return place->second;
}

/// A number that says how transparent a surface is may well hide all of a model.
void SceneBuilder::warnIfUnseen(const fs::path& library, const MtlMaterial& source, float opacity) {
    if (opacity == 1.0f) return;
    char number[32];
    std::snprintf(number, sizeof number, "%g", source.opacity ? opacity : 1.0f - opacity);
    const std::string said = std::string(source.opacity ? "d " : "Tr ") + number;
    if (opacity < 0.5f)
        report_.warn(WarningKind::unseenMaterial, library, source.opacityLine,
                     "material " + inQuotes(source.name) + " has " + said +
                         ": more transparent than not, it is not shown at all");
    else
        report_.ignore("MTL d from 1/2 to 1, taken as opaque");
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
    const std::string place = "materials[" + std::to_string(index) + "]";
    const auto [entry, isNew] = materials_.try_emplace(
        {gltf.file.string(), place, std::nullopt, doubleSided}, (uint32_t) scene_.materials.size());
    if (!isNew) return entry->second;
    Material material = loadGltfMaterial(gltf, index, textures_);
    material.doubleSided |= doubleSided;
    if (material.opacity < 0.5f)
        report_.warn(WarningKind::unseenMaterial, gltf.file, 0,
                     place + " has an alpha below its cutoff: more transparent than "
                             "not, it is not shown at all");
    if (doubleSided && gltf.surfaces[index].saysOneSided)
        report_.ignore("glTF material doubleSided false");
    scene_.materials.push_back(std::move(material));
    return entry->second;
}

} // namespace dirt
