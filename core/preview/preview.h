#pragma once

#include "core/frame/backend.h"
#include "core/preview/marks.h"
#include "core/preview/picture.h"
#include "core/preview/picture_values.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dirt {

/// False colours from the least number to the largest; black is nothing.
struct FalseColours {
    double low = 0.0, high = 0.0;
    std::string unit; ///< "entries a tile"
};

/// A part of a picture that has a name: a view.
struct NamedPart {
    Box pixels;
    std::string name;
};

/// The picture of a buffer: a pixel for each of its elements. present.h makes it fit to be looked
/// at.
struct PreviewPicture : Picture {
    std::string scale;                   ///< what the colours stand for: "0 to 37 entries a tile"
    std::optional<FalseColours> colours; ///< where they are false
    std::vector<PictureValues> values;   ///< what it stands for, of each of its parts
    Marks marks;
    std::vector<NamedPart> parts; ///< where it has several
    bool bare = false;            ///< it explains itself: shown without its scale
};

/// A buffer that has a picture.
struct PreviewKind {
    enum class Of {
        image,   ///< what the frame gives
        views,   ///< tiles of the views, one beside the other
        event,   ///< pixels of the image at a path event
        point,   ///< likewise, of one of the three surface points
        light,   ///< what it sees
        overview ///< the image, and a buffer of the views around it
    };
    const char* name;
    const char* meaning;
    Of of;
};

std::span<const PreviewKind> previewKinds();

/// The one of that name; null: there is none.
const PreviewKind* previewKind(std::string_view name);

/// Surface points of path event k: G[k-1], G[k] and G[k+1].
enum class PointChoice { previous, current, next };

/// The rays of a pixel that are drawn over the picture.
struct PathRequest {
    std::array<int, 2> pixel{};
    std::optional<int> event{}; ///< none: all
    std::optional<int> ray{};   ///< of an event, as raysOf has them; none: all
};

/// What to draw.
struct PreviewRequest {
    const PreviewKind* kind = nullptr;
    int level = 0; ///< of the pyramid, for depths
    int bin = -1;  ///< whose lists are counted; -1: all
    int event = 0;
    uint32_t sample = 0;
    PointChoice point = PointChoice::next;
    const PreviewKind* around = nullptr; ///< of an overview: the buffer of the views
    std::optional<PathRequest> path;
};

/// Draws a buffer of one sample of the frame (the image: of all the settings' samples), as
/// \p backend has it: the passes Preview and Resolve. Equal buffers give equal pictures, but for
/// those of time. Throws InputError where the frame does not have the buffer.
PreviewPicture drawPreview(const Scene& scene, const RenderSettings& settings, Backend& backend,
                           const PreviewRequest& request, const std::function<bool()>& stop = {});

/// The tiles' pictures of \p kind alone, of a grid that has been built.
PreviewPicture drawTiles(const Grid& grid, const PreviewRequest& request);

} // namespace dirt
