#include "core/preview/ray_colours.h"

#include <algorithm>

namespace dirt {

namespace {
constexpr int kSwatch = 18; // pixels
constexpr int kBeforeWords = 10;
constexpr int kStep = 24; // from key to key
} // namespace

int drawKeys(Canvas& canvas, int x, int y, const std::vector<Key>& keys) {
    for (const Key& key : keys) {
        const glm::dvec2 middle(x + kSwatch / 2, y + kSwatch / 2);
        switch (key.shape) {
        case Key::Shape::box:
            canvas.fill({x, y, kSwatch, kSwatch}, key.fill);
            canvas.frame({x, y, kSwatch, kSwatch}, key.rim, 2);
            break;
        case Key::Shape::line:
            canvas.line(middle - glm::dvec2(kSwatch / 2, 0), middle + glm::dvec2(kSwatch / 2, 0),
                        key.fill, 2);
            break;
        case Key::Shape::cross:
            canvas.cross(middle, kSwatch / 3, key.fill);
            break;
        }
        canvas.text(x + kSwatch + kBeforeWords, y + 2, key.meaning, kWords);
        y += kStep;
    }
    return heightOf(keys);
}

int widthOf(const std::vector<Key>& keys) {
    int width = 0;
    for (const Key& key : keys)
        width = std::max(width, kSwatch + kBeforeWords + textWidth(key.meaning));
    return width;
}

int heightOf(const std::vector<Key>& keys) {
    return (int) keys.size() * kStep;
}

} // namespace dirt
