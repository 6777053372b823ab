#pragma once

#include "core/preview/canvas.h"
#include "core/trace/traversal_watcher.h"

#include <string>
#include <utility>
#include <vector>

namespace dirt {

// Colours of pictures of rays. Most are Okabe and Ito's, which people tell apart whatever colours
// they see.

inline constexpr Colour kBackground{16, 16, 16}, kWords{230, 230, 230}, kFaintWords{150, 150, 150};
inline constexpr Colour kEmptyTile{26, 26, 28}, kFilledTile{52, 52, 56};
inline constexpr Colour kLookedInto{0, 114, 178};
inline constexpr Colour kPassedOver{0, 70, 52}, kPassedOverRim{0, 158, 115};
inline constexpr Colour kVisited{120, 82, 0}, kVisitedRim{230, 159, 0};
inline constexpr Colour kRayLine{255, 255, 255}, kRayBeyond{120, 120, 120};
inline constexpr Colour kHitMark{255, 70, 50};
inline constexpr Colour kMissed{165, 165, 165}, kFarther{86, 180, 233}, kRefused{204, 121, 167};

/// Around and between what is in a picture, in pixels.
inline constexpr int kPictureMargin = 16;

/// Of a triangle, by what became of it.
inline Colour colourOf(Tested result) {
    switch (result) {
    case Tested::missed:
        return kMissed;
    case Tested::farther:
        return kFarther;
    case Tested::nearest:
    case Tested::known:
        return kHitMark;
    default:
        return kRefused;
    }
}

/// How something is drawn, and what it is.
struct Key {
    enum class Shape { box, line, cross };
    Shape shape;
    Colour fill, rim; ///< of lines and crosses: \p fill
    std::string meaning;
};

/// Draws keys below each other from \p x, \p y. Gives the height that they take.
int drawKeys(Canvas& canvas, int x, int y, const std::vector<Key>& keys);
int widthOf(const std::vector<Key>& keys);
int heightOf(const std::vector<Key>& keys);

} // namespace dirt
