#include "backend_cpu/image/depth_lists.h"

#include <algorithm>
#include <atomic>
#include <bit>

namespace dirt {
namespace {

constexpr size_t kTilesPerPiece = 512;

/// Depths are not negative, and the bits of such floats are in their order.
uint64_t key(const DepthEntry& entry) {
    return (uint64_t) std::bit_cast<uint32_t>(entry.near) << 32 | entry.item;
}

} // namespace

void sortIntoTiles(std::span<const FragmentPiece> pieces, size_t tiles, Executor& executor,
                   DepthLists& lists) {
    lists.heads.assign(tiles + 1, 0);
    const auto headOf = [&](const DepthFragment& fragment) {
        return std::atomic_ref<uint32_t>(lists.heads[fragment.tile]);
    };
    executor.forRange(pieces.size(), 1, [&](size_t i, size_t) {
        for (const DepthFragment& fragment : pieces[i].fragments)
            headOf(fragment).fetch_add(1, std::memory_order_relaxed);
    });
    uint32_t sum = 0;
    for (uint32_t& head : lists.heads) head = sum += head;
    lists.entries.resize(sum);
    // Each list is filled from its end, which leaves heads at the beginnings.
    executor.forRange(pieces.size(), 1, [&](size_t i, size_t) {
        for (const DepthFragment& fragment : pieces[i].fragments) {
            const uint32_t end = headOf(fragment).fetch_sub(1, std::memory_order_relaxed);
            lists.entries[end - 1] = {fragment.near, pieces[i].firstItem + fragment.item};
        }
    });
    executor.forRange(tiles, kTilesPerPiece, [&](size_t begin, size_t end) {
        for (size_t tile = begin; tile < end; ++tile)
            std::sort(lists.entries.begin() + lists.heads[tile],
                      lists.entries.begin() + lists.heads[tile + 1],
                      [](const DepthEntry& a, const DepthEntry& b) { return key(a) < key(b); });
    });
}

} // namespace dirt
