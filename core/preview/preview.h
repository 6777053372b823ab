#pragma once

#include "core/frame/backend.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace dirt {

/// A picture of a buffer: rows of 8-bit R, G, B, the first on top.
struct PreviewPicture {
    int width = 0, height = 0;
    std::vector<uint8_t> rgb;
    std::string scale; ///< what the colours stand for: "0 to 37 entries a tile"
};

/// A buffer that has a picture.
struct PreviewKind {
    const char* name;
    const char* meaning;
    bool perView;  ///< tiles of the views, one beside the other; else pixels of the image
    bool perEvent; ///< of a path event
};

std::span<const PreviewKind> previewKinds();

/// What to draw.
struct PreviewRequest {
    const PreviewKind* kind = nullptr;
    int level = 0; ///< of the pyramid, for depths
    int bin = -1;  ///< whose lists are counted; -1: all
    int event = 0;
    uint32_t sample = 0;
};

/// Draws a buffer of one sample of the frame (the image: of all the settings' samples), as
/// \p backend has it: the passes Preview and Resolve. Equal buffers give equal pictures. Throws
/// InputError where the frame does not have the buffer.
PreviewPicture drawPreview(const Scene& scene, const RenderSettings& settings, Backend& backend,
                           const PreviewRequest& request, const std::function<bool()>& stop = {});

/// The tiles' pictures of \p kind alone, of a grid that has been built.
PreviewPicture drawTiles(const Grid& grid, const PreviewRequest& request);

} // namespace dirt
