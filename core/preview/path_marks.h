#pragma once

#include "core/explain/path_account.h"
#include "core/path/camera_rays.h"
#include "core/preview/preview.h"

namespace dirt {

/// The tiles that the rays of a pixel visit, their images and hits, over a picture of all views'
/// cells of a \p level: of one event, or of all. \p account must have a grid.
Marks marksOfPath(const PathAccount& account, const PathRequest& path, int level);

/// Those marks, in the pixels of another picture of the same cells: where its \p parts stand.
std::vector<Mark> placeMarks(const std::vector<Mark>& marks, const Grid& grid,
                             const std::vector<PictureValues>& parts);

/// The same rays as the camera sees them, over a picture of the image's pixels: what of their way
/// is before the eye.
Marks marksInImage(const PathAccount& account, const PathRequest& path, const CameraRays& camera);

/// The pixel itself, over a picture of the image's pixels.
Marks marksOfPixel(const PathRequest& path);

} // namespace dirt
