#pragma once

#include "core/io/load.h"
#include "core/io/scene_builder.h"

#include <filesystem>
#include <span>

#include <glm/mat4x4.hpp>

namespace dirt {

/// A model file that is to be placed.
struct Placed {
    std::filesystem::path file;
    glm::dmat4 toSpace{1.0};
    uint32_t space = MovingSpace::kWorld;
    bool doubleSided = true;
    MaterialChoice materials = {};
};

/// Places \p uses, one for each of \p list, in a scene without geometry: the mesh and its
/// materials, what moves, the scene's origin, and cameras and lights of models. Their memory is
/// taken from \p budget before any is placed. \p builder is of that scene and \p report. Throws
/// InputError as SceneBuilder::add does, and where there is not the memory.
void placeModels(std::span<const Placed> list, std::span<const SceneBuilder::Use> uses,
                 const MemoryBudget& budget, SceneBuilder& builder, LoadReport& report,
                 LoadedScene& loaded);

} // namespace dirt
