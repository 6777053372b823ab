#pragma once

#include "core/frame/backend.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dirt {

/// One buffer of one pass as two backends have made it from the same data.
struct CheckRow {
    std::string pass;   ///< as design and paper name it
    std::string buffer; ///< "depth bounds", "depth pyramid, level 3", …
    std::string tested; ///< the backend that ran the pass
    std::string source; ///< the backend whose data it got, and whose result it is compared with

    uint64_t compared = 0;        ///< values, or entries that at least one of the two lists
    uint64_t equal = 0;           ///< to the bit
    uint64_t withinTolerance = 0; ///< unequal, but allowed (see checkConstruction)
    uint64_t different = 0;
    std::vector<std::string> examples; ///< the first differences in words, kExamples at most
};

inline constexpr size_t kExamples = 3;

/// Builds the structure of \p mesh on two backends and compares every buffer. Each pass of each
/// backend runs on the other's data, so that one fault does not hide the next.
///
/// Everything has to be equal. Only where one of the backends is not isIeee() depths may be off by
/// 16 ulp (G2), and lists by the entries in bins whose border is that near to an end of the
/// triangle's depths in that tile.
std::vector<CheckRow> checkConstruction(const Mesh& mesh, const Camera& camera,
                                        const GridSettings& settings, Backend& first,
                                        Backend& second);

} // namespace dirt
