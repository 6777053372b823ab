#pragma once

#include "core/preview/preview.h"

namespace dirt {

/// A preview to be looked at: small pictures enlarged a whole number of times, marks over them, and
/// below what the colours stand for: false ones with a bar from the least number to the largest.
Picture present(const PreviewPicture& picture);

/// Its values, where they then stand.
std::vector<PictureValues> presentedValues(const PreviewPicture& picture);

/// The lines below a preview: its scale and the keys of its marks.
int captionWidth(const PreviewPicture& picture);
int captionHeight(const PreviewPicture& picture);
void drawCaption(Canvas& canvas, int x, int y, const PreviewPicture& picture);

} // namespace dirt
