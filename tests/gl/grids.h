#pragma once

#include "core/grid/grid.h"
#include "tests/support/print.h"

#include <gtest/gtest.h>

#include <bit>

/// Grids of two builders, compared bit for bit.
namespace dirt::test {

inline bool sameBits(float a, float b) {
    return std::bit_cast<uint32_t>(a) == std::bit_cast<uint32_t>(b);
}

/// Whether all depth bounds, lists and the list of the eye are equal; else what differs first.
inline testing::AssertionResult sameGrid(const Grid& a, const Grid& b) {
    for (size_t v = 0; v < a.pyramids.size(); ++v) {
        if (a.pyramids[v].levels.size() != b.pyramids[v].levels.size())
            return testing::AssertionFailure() << "levels of view " << v;
        for (size_t l = 0; l < a.pyramids[v].levels.size(); ++l) {
            const auto &x = a.pyramids[v].levels[l].bounds, &y = b.pyramids[v].levels[l].bounds;
            if (x.size() != y.size())
                return testing::AssertionFailure() << "size of level " << l << " of view " << v;
            for (size_t i = 0; i < x.size(); ++i)
                if (!sameBits(x[i].near, y[i].near) || !sameBits(x[i].far, y[i].far))
                    return testing::AssertionFailure()
                           << "view " << v << " level " << l << " cell " << i << ": "
                           << hex(x[i].near) << " " << hex(x[i].far) << " and " << hex(y[i].near)
                           << " " << hex(y[i].far);
        }
    }
    if (a.heads != b.heads) return testing::AssertionFailure() << "lengths of lists";
    if (a.ids != b.ids) return testing::AssertionFailure() << "entries of lists";
    if (a.atEye != b.atEye) return testing::AssertionFailure() << "triangles at the eye";
    return testing::AssertionSuccess();
}

} // namespace dirt::test
