#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace dirt {

inline constexpr size_t kExamples = 3;

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
    std::vector<std::string> examples; ///< the first differences in words, kExamples at most

    /// Counts a difference; \p describe() says which.
    template <typename Describe>
    void differ(const Describe& describe) {
        ++different;
        if (examples.size() < kExamples) examples.push_back(describe());
    }
};

} // namespace dirt
