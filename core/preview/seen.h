#pragma once

#include "core/frame/backend.h"
#include "core/preview/preview.h"

#include <optional>
#include <vector>

namespace dirt {

/// What a sample has left behind at the event that is asked for.
struct Seen {
    FrameGeometry geometry;
    std::optional<Grid> grid;
    PathBuffers paths;
    std::vector<float> shadowMap;
    std::vector<PathRay> rays; ///< of the event, whether they were traced or not
};

/// The pictures of a path event's rays and flags, of its surface points, and of the shadow map.
PreviewPicture drawPixels(const Seen& seen, const GridSettings& grid,
                          const PreviewRequest& request);
PreviewPicture drawPoints(const Seen& seen, const GridSettings& grid,
                          const PreviewRequest& request);
PreviewPicture drawShadowMap(const Seen& seen, const PreviewRequest& request);

/// Ends in one line that names what is to be shown.
[[noreturn]] void missing(const PreviewRequest& request, const std::string& why);

} // namespace dirt
