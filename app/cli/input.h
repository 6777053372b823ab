#pragma once

#include "app/cli/options.h"
#include "core/frame/backend.h"
#include "core/frame/settings.h"
#include "core/scene/scene.h"

#include <memory>

namespace dirt {

/// What a command with a scene works on.
struct Input {
    Scene scene;             ///< with a camera, and a light where the file is a bare OBJ
    RenderSettings settings; ///< options over the scene file over the defaults
};

/// Loads SCENE of \p options. Warnings go to standard error unless --quiet; with --strict they are
/// errors. A bare OBJ gets a camera and a light that show it. Throws InputError.
Input openInput(const CommonOptions& options);

/// The backend of \p options with its threads. Throws CapabilityError where this build lacks it.
std::unique_ptr<Backend> makeBackend(const CommonOptions& options);

} // namespace dirt
