#pragma once

#include "core/base/executor.h"

#include <cstdint>
#include <vector>

namespace dirt {

/// The indices of [0, \p count) for which \p keep(index) is true, in increasing order: the same
/// for any number of threads. \p keep is called once per index, in pieces of \p grain.
template <typename Predicate>
std::vector<uint32_t> compact(Executor& executor, size_t count, size_t grain,
                              const Predicate& keep) {
    const size_t pieces = (count + grain - 1) / grain;
    std::vector<uint8_t> kept(count);
    std::vector<size_t> first(pieces + 1, 0);
    executor.forRange(count, grain, [&](size_t begin, size_t end) {
        size_t survivors = 0;
        for (size_t i = begin; i < end; ++i) survivors += kept[i] = keep(i) ? 1 : 0;
        first[begin / grain + 1] = survivors;
    });
    for (size_t piece = 0; piece < pieces; ++piece) first[piece + 1] += first[piece];

    std::vector<uint32_t> indices(first[pieces]);
    executor.forRange(count, grain, [&](size_t begin, size_t end) {
        size_t out = first[begin / grain];
        for (size_t i = begin; i < end; ++i)
            if (kept[i]) indices[out++] = (uint32_t) i;
    });
    return indices;
}

} // namespace dirt
