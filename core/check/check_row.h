#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace dirt {

inline constexpr size_t kExamples = 3;

/// What a difference is of, in the words of `dirt explain`.
struct Place {
    enum class Kind {
        none,      ///< of no such thing
        primitive, ///< id
        tile,      ///< view, x (column), y (row)
        pixel,     ///< x, y
        texel      ///< of the shadow map: x, y
    };
    Kind kind = Kind::none;
    uint32_t id = 0;
    int view = 0, x = 0, y = 0;

    static Place ofPrimitive(uint32_t id) { return {Kind::primitive, id}; }
    static Place ofTile(int view, int x, int y) { return {Kind::tile, 0, view, x, y}; }
    static Place ofPixel(int x, int y) { return {Kind::pixel, 0, 0, x, y}; }
    static Place ofTexel(int x, int y) { return {Kind::texel, 0, 0, x, y}; }
};

/// One buffer of one pass as two backends have made it from the same data.
struct CheckRow {
    std::string pass;   ///< as design and paper name it
    int event = -1;     ///< path event; -1: a pass of the construction, or all events
    std::string buffer; ///< "depth bounds", "depth pyramid, level 3", …
    std::string tested; ///< the backend that ran the pass
    std::string source; ///< the backend whose data it got, and whose result it is compared with

    uint64_t compared = 0; ///< values, records, or entries that at least one of the two lists
    uint64_t equal = 0;    ///< to the bit, but for the signs of zeros
    uint64_t withinTolerance = 0; ///< unequal, but allowed (docs/check.md)
    uint64_t different = 0;
    Place first;                       ///< of the first difference
    std::vector<std::string> examples; ///< the first differences in words, kExamples at most

    /// Counts a difference at \p place; \p describe() says which.
    template <typename Describe>
    void differ(const Place& place, const Describe& describe) {
        if (different++ == 0) first = place;
        if (examples.size() < kExamples) examples.push_back(describe());
    }
};

} // namespace dirt
