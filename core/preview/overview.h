#pragma once

#include "core/preview/preview.h"

namespace dirt {

/// The image in the middle, the views of \p sheet around it: a picture of all tiles, or cells of
/// \p level, as drawTiles gives it. White lines in full views frame what the image shows.
PreviewPicture drawOverview(const PreviewPicture& image, const PreviewPicture& sheet,
                            const Grid& grid, const Camera& camera, int level);

} // namespace dirt
