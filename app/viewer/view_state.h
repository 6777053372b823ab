#pragma once

#include "app/cli/options.h"
#include "core/frame/settings.h"
#include "core/preview/preview.h"
#include "core/scene/camera.h"

#include <array>
#include <optional>

namespace dirt {

/// What the viewer shows and how: all that keys change. A scene's file and the options give the
/// first.
struct ViewState {
    Camera camera;
    RenderSettings settings; ///< the grid's width and height: of the picture at rest
    BackendKind backend = BackendKind::cpu;
    bool progressive = true; ///< samples add up while nothing changes; else one
    const PreviewKind* shown = previewKind("image");
    std::optional<std::array<int, 2>> ray; ///< pixel whose path is drawn over the picture
    float lensRadius = 0.0f;               ///< of the camera when depth of field is on
};

} // namespace dirt
