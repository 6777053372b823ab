#pragma once

#include "core/io/load_report.h"
#include "core/io/material_convention.h"
#include "core/io/memory_budget.h"
#include "core/io/model_views.h"
#include "core/io/read_all.h"
#include "core/io/scene_file.h"
#include "core/scene/scene.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dirt {

/// A scene, at frame 0 if it is animated, and what its file said besides.
struct LoadedScene {
    Scene scene;
    SceneSettings settings;
    bool hasCamera = false; ///< whether scene.camera stands where a file says
    bool hasLight = false;  ///< whether scene.lights comes from a file
    /// Of model files, in the order of objects, but where they move.
    std::vector<ModelCamera> cameras;
    /// Which of them scene.camera is: the first, where no scene file has one.
    std::optional<size_t> modelCamera;
    std::vector<Warning> warnings;
    std::vector<std::string> ignored;        ///< names of the files that have no effect, each once
    std::vector<std::string> caches;         ///< of models, which this load has written
    std::vector<MaterialFile> materialFiles; ///< how the MTL files were taken
};

/// Who looks at a scene while its files are read: on any thread, one call at a time. What is thrown
/// here ends the load.
struct PartialLoad {
    /// Asked when there is more to see than was shown last, before it is made; empty: always.
    std::function<bool()> wanted{};
    /// Given the scene as far as its models are there, without textures; empty: no one looks. Only
    /// of scene files that say where the camera stands, so that it is seen from where all of it
    /// will be; not without triangles, nor where SceneFile::showParts is false.
    std::function<void(LoadedScene part)> show{};
};

struct LoadOptions {
    bool strict = false; ///< what would be a warning is an InputError
    bool cache = false;  ///< OBJ files through their caches, but where a .scene file forbids it
    /// What the MTL files of all objects are taken for; none: what the files say.
    std::optional<MaterialConvention> materials{};
    Executor* executor = nullptr; ///< whose threads read files; none: one after the other
    /// For the files while they are read, and for what is kept of them; without a limit unless one
    /// is given. One for each scene.
    MemoryBudget memory{};
    /// Of models, then of textures; may be empty. What it throws ends the load.
    LoadProgress progress{};
    PartialLoad partial{}; ///< takes time, and does not change what is loaded
};

/// Loads a .scene, .obj, .gltf or .glb file with all that it names. Throws InputError, one line
/// with file and line, where the input is bad: see readSceneFile, readObj and readGltf; more than
/// LoadOptions::memory has; no triangles; an object that is not there; an unknown file type;
/// LoadOptions::materials where there is no OBJ file.
LoadedScene loadScene(const std::filesystem::path& file, const LoadOptions& options = {});

} // namespace dirt
