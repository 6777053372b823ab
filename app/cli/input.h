#pragma once

#include "app/cli/options.h"
#include "core/base/executor.h"
#include "core/frame/backend.h"
#include "core/frame/precision.h"
#include "core/io/load_report.h"
#include "core/io/material_convention.h"
#include "core/io/model_views.h"
#include "core/io/read_all.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace dirt {

/// Bytes: what a scene may take in all, what of that its textures and geometry take, and a frame,
/// as far as is known before it is made.
struct MemoryUse {
    uint64_t limit = 0, scene = 0, frame = 0;
};

/// What a command with a scene works on.
struct Input {
    Scene scene;             ///< with a camera, and a light where the file is a bare model
    RenderSettings settings; ///< options over the scene file over the defaults
    bool tileChosen = false; ///< by the cost model, as nothing else says it
    bool binsChosen = false;
    int frame = 0;                                   ///< that the scene is at
    PrecisionReach precision;                        ///< of that frame
    std::set<PrecisionWarning::Cause> precisionSaid; ///< what warnings has of it
    std::vector<ModelCamera> cameras;                ///< that the files have
    std::optional<size_t> modelCamera;               ///< which of them the scene is seen by
    std::vector<Warning> warnings;
    std::vector<std::string> ignored; ///< names in the files that have no effect

    /// How the MTL files were taken.
    std::vector<MaterialFile> materialFiles;
    MemoryUse memory;
};

/// The threads of \p options.
std::unique_ptr<Executor> makeExecutor(const CommonOptions& options);

/// The backend of \p options. Throws CapabilityError where this build lacks it.
std::unique_ptr<Backend> makeBackend(const CommonOptions& options, Executor& executor);

/// Another one, for commands with several.
std::unique_ptr<Backend> makeBackend(BackendKind kind, const CommonOptions& options,
                                     Executor& executor);

/// Who looks at a scene while it is opened: see LoadOptions::progress and PartialLoad, whose scenes
/// come as \p part shows them, at the frame and with the camera that they will have. All may be
/// empty.
struct InputWatch {
    LoadProgress progress{};
    std::function<bool()> wanted{};
    std::function<void(Input)> part{};
};

/// Loads SCENE of \p options and brings it to their frame. Tile and bins that neither options nor
/// the scene's file give are the cost model's on the CPU. A scene without a camera gets one that
/// shows its frame 0; a bare model also a background, and a light where it has none. Says the
/// warnings, of which those of precision are of the frame, what is ignored, and the caches that it
/// left. Throws InputError.
Input openInput(const CommonOptions& options, Executor& executor, const InputWatch& watch = {});

/// Brings the scene of openInput to another frame. Throws InputError where that frame has no image:
/// a vertex leaves float32, or the camera has no direction.
void moveInput(Input& input, const CommonOptions& options, int frame, Executor& executor);

/// Warns where float32 resolves the frame at hand too coarsely, of each cause once in a run. With
/// --strict it throws InputError.
void checkPrecision(Input& input, const CommonOptions& options, Executor& executor);

} // namespace dirt
