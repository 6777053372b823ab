#pragma once

#include "app/cli/options.h"
#include "core/frame/settings.h"
#include "core/preview/preview.h"
#include "core/scene/camera.h"

#include <array>
#include <optional>

namespace dirt {

/// What the viewer shows and how: all that keys and the panel change. A scene's file and the
/// options give the first.
struct ViewState {
    Camera camera;
    RenderSettings settings; ///< the grid's width and height: of the picture at rest
    ToneMapping toneMapping;
    BackendKind backend = BackendKind::cpu;
    unsigned threads = 0;    ///< 0: all cores
    bool progressive = true; ///< samples add up while nothing changes; else one
    int frame = 0;           ///< of a scene that moves
    bool playing = false;    ///< which then goes on by itself

    const PreviewKind* shown = previewKind("image");
    int level = 0; ///< of the pyramid, where depths are shown
    int bin = -1;  ///< whose entries are counted; -1: all
    int event = 0; ///< whose rays and points are shown

    std::optional<std::array<int, 2>> ray;  ///< pixel whose path is drawn over the picture
    std::optional<std::array<int, 3>> tile; ///< view, column and row: whose lists are told
    float lensRadius = 0.0f;                ///< of the camera when depth of field is on
};

/// Draws all rays of the pixel at this part of the image's width and height.
void showRay(ViewState& state, double x, double y);

} // namespace dirt
