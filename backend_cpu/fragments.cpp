#include "backend_cpu/fragments.h"

#include <algorithm>
#include <array>

namespace dirt {

uint32_t FragmentBuckets::tiles(size_t bucket) const {
    return std::min(1u << shift_, tiles_ - firstTile(bucket));
}

void FragmentBuckets::fill(std::span<const RasterPiece> pieces, uint32_t tiles,
                           Executor& executor) {
    tiles_ = tiles;
    shift_ = 0;
    while (tiles > 0 && (tiles - 1) >> shift_ >= kMaxBuckets) ++shift_;
    const size_t buckets = tiles == 0 ? 0 : ((tiles - 1) >> shift_) + 1;

    places_.resize(pieces.size() * buckets);
    executor.forRange(pieces.size(), 1, [&](size_t piece, size_t) {
        std::array<size_t, kMaxBuckets> counts{};
        for (const Fragment& fragment : pieces[piece].fragments) ++counts[fragment.tile >> shift_];
        std::copy_n(counts.begin(), buckets, places_.begin() + piece * buckets);
    });
    starts_.resize(buckets + 1);
    size_t sum = 0;
    for (size_t bucket = 0; bucket < buckets; ++bucket) {
        starts_[bucket] = sum;
        for (size_t piece = 0; piece < pieces.size(); ++piece) {
            size_t& place = places_[piece * buckets + bucket];
            const size_t count = place;
            place = sum;
            sum += count;
        }
    }
    starts_[buckets] = sum;

    fragments_.resize(sum);
    executor.forRange(pieces.size(), 1, [&](size_t piece, size_t) {
        std::array<size_t, kMaxBuckets> next;
        std::copy_n(places_.begin() + piece * buckets, buckets, next.begin());
        for (const Fragment& fragment : pieces[piece].fragments)
            fragments_[next[fragment.tile >> shift_]++] = fragment;
    });
}

} // namespace dirt
