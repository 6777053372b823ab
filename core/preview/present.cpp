#include "core/preview/present.h"

#include "core/compare/colour_map.h"
#include "core/preview/paint.h"

#include <algorithm>

namespace dirt {

namespace {

// Pixels.
constexpr int kLeastSide = 768, kCaptionMargin = 12, kGap = 12;
constexpr int kBarWidth = 256, kBarHeight = 18;

/// How many times a picture is enlarged.
int timesOf(const PreviewPicture& picture) {
    if (picture.bare && picture.marks.empty()) return 1;
    const int side = std::max(picture.width, picture.height);
    return std::max((kLeastSide + side - 1) / side, 1);
}

/// The words beside the bar, on its left and on its right.
std::pair<std::string, std::string> wordsOf(const FalseColours& colours) {
    return {scaleNumber(colours.low),
            scaleNumber(colours.high) + " " + colours.unit + "; black: nothing"};
}

int scaleWidth(const PreviewPicture& picture) {
    if (!picture.colours) return textWidth(picture.scale);
    const auto [low, high] = wordsOf(*picture.colours);
    return textWidth(low) + kGap + kBarWidth + kGap + textWidth(high);
}

void drawScale(Canvas& canvas, int x, int y, const PreviewPicture& picture) {
    if (!picture.colours) {
        canvas.text(x, y + 2, picture.scale, kWords);
        return;
    }
    const auto [low, high] = wordsOf(*picture.colours);
    canvas.text(x, y + 2, low, kWords);
    x += textWidth(low) + kGap;
    for (int i = 0; i < kBarWidth; ++i)
        canvas.fill({x + i, y, 1, kBarHeight}, heatColour((double) i / (kBarWidth - 1)));
    canvas.text(x + kBarWidth + kGap, y + 2, high, kWords);
}

/// A line at the left and above each part, and its name where there is room.
void drawParts(Canvas& canvas, const PreviewPicture& picture, int times) {
    for (const auto& [pixels, name] : picture.parts) {
        const Box box{pixels.left * times, pixels.top * times, pixels.width * times,
                      pixels.height * times};
        if (box.left > 0) canvas.fill({box.left, box.top, 1, box.height}, kFaintWords);
        if (box.top > 0) canvas.fill({box.left, box.top, box.width, 1}, kFaintWords);
        if (box.width < 8 * textWidth(name)) continue;
        canvas.fill({box.left + 2, box.top + 2, textWidth(name) + 2, textHeight() - 2},
                    kBackground);
        canvas.text(box.left + 4, box.top + 4, name, kWords);
    }
}

bool hasScale(const PreviewPicture& picture) {
    return !picture.bare && !picture.scale.empty();
}

} // namespace

int captionWidth(const PreviewPicture& picture) {
    return std::max(hasScale(picture) ? scaleWidth(picture) : 0, widthOf(picture.marks.keys));
}

int captionHeight(const PreviewPicture& picture) {
    return (hasScale(picture) ? kBarHeight + kGap : 0) + heightOf(picture.marks.keys);
}

void drawCaption(Canvas& canvas, int x, int y, const PreviewPicture& picture) {
    if (hasScale(picture)) {
        drawScale(canvas, x, y, picture);
        y += kBarHeight + kGap;
    }
    drawKeys(canvas, x, y, picture.marks.keys);
}

std::vector<PictureValues> presentedValues(const PreviewPicture& picture) {
    std::vector<PictureValues> values = picture.values;
    const int times = timesOf(picture);
    for (PictureValues& part : values) {
        Box& box = part.pixels;
        box = {box.left * times, box.top * times, box.width * times, box.height * times};
        part.times *= times;
    }
    return values;
}

Picture present(const PreviewPicture& picture) {
    const int times = timesOf(picture);
    const int width = picture.width * times, height = picture.height * times;
    const int caption = captionHeight(picture);
    if (times == 1 && caption == 0 && picture.marks.empty()) return picture;
    Picture presented(std::max(width, captionWidth(picture) + 2 * kCaptionMargin),
                      height + (caption > 0 ? caption + kCaptionMargin : 0));
    Canvas canvas(presented);
    canvas.fill({0, 0, presented.width, presented.height}, kBackground);
    canvas.paste(picture, 0, 0, times);
    drawParts(canvas, picture, times);
    Canvas within = canvas.within({0, 0, width, height});
    drawMarks(within, picture.marks.marks, glm::dvec2(0.0), times);
    drawCaption(canvas, kCaptionMargin, height + kCaptionMargin, picture);
    return presented;
}

} // namespace dirt
