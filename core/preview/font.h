#pragma once

namespace dirt {

// Letters for words in pictures: five pixels wide, seven above the line and two below it.

inline constexpr int kGlyphWidth = 5, kGlyphHeight = 9;
inline constexpr int kAdvance = 6;     ///< from one letter to the next
inline constexpr int kLineHeight = 11; ///< from one line to the next

/// Whether pixel (\p x, \p y) of a letter is set. Letters that are not there have a box.
bool isSet(char letter, int x, int y);

} // namespace dirt
