#include "core/io/material_convention.h"

namespace dirt {

std::string_view nameOf(MaterialConvention convention) {
    return convention == MaterialConvention::demo ? "demo" : "wavefront";
}

std::optional<MaterialConvention> parseMaterialConvention(std::string_view name) {
    for (const auto convention : {MaterialConvention::demo, MaterialConvention::wavefront})
        if (name == nameOf(convention)) return convention;
    return std::nullopt;
}

MaterialChoice MaterialChoice::inSceneFile(std::optional<MaterialConvention> world,
                                           std::optional<MaterialConvention> object) {
    if (object) return {By::object, *object};
    if (world) return {By::world, *world};
    return {By::sceneFile, MaterialConvention::demo};
}

MaterialFile decideConvention(const std::filesystem::path& file, const MaterialChoice& choice,
                              bool saysMetallic) {
    using By = MaterialChoice::By;
    switch (choice.by) {
    case By::option:
        return {file, choice.convention, "--materials says so"};
    case By::object:
        return {file, choice.convention, "its <object> says so"};
    case By::world:
        return {file, choice.convention, "<world> says so"};
    case By::sceneFile:
        break;
    case By::bareModel:
        break;
    }
    if (saysMetallic) return {file, MaterialConvention::demo, "it says metallic"};
    return {file, choice.convention,
            choice.by == By::sceneFile ? "it is of an object of a .scene file"
                                       : "it is of a model by itself"};
}

} // namespace dirt
