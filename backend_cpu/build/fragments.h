#pragma once

#include "core/base/executor.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace dirt {

/// A triangle's part in one tile, as the software rasterizer finds it.
struct Fragment {
    uint32_t tile; ///< in the numbering over all views (Grid::firstTile)
    uint32_t id;
    float near, far;
};

/// What the rasterizer finds of a piece of the triangles. Its memory is kept from one use to the
/// next.
struct RasterPiece {
    std::vector<Fragment> fragments; ///< of any one tile, in the order of ids
    std::vector<uint32_t> atEye;     ///< triangles that hold the eye, in increasing order
};

/// Fragments of a frame in buckets of neighbouring tiles, each in the order of ids; so that every
/// bucket is some thread's own, and no list needs to be sorted. Or anything in buckets of
/// neighbouring values of whatever member \p tile is.
template <class AnyFragment, uint32_t AnyFragment::*tile = &AnyFragment::tile>
class FragmentBuckets {
public:
    /// Takes the fragments of \p pieces, which follow one another in the order of ids. Keeps its
    /// memory.
    template <class Piece>
    void fill(const std::vector<Piece>& pieces, uint32_t tiles, Executor& executor);

    size_t count() const { return starts_.size() - 1; }
    uint32_t firstTile(size_t bucket) const { return (uint32_t) bucket << shift_; }
    uint32_t tiles(size_t bucket) const {
        return std::min(1u << shift_, tiles_ - firstTile(bucket));
    }
    /// Fragments in all buckets before \p bucket, which may be count().
    size_t before(size_t bucket) const { return starts_[bucket]; }
    std::span<const AnyFragment> operator[](size_t bucket) const {
        return {fragments_.data() + starts_[bucket], fragments_.data() + starts_[bucket + 1]};
    }
    uint64_t bytes() const { return fragments_.capacity() * sizeof(AnyFragment); }

private:
    static constexpr uint32_t kMaxBuckets = 256;

    uint32_t tiles_ = 0;
    unsigned shift_ = 0;               ///< tile to bucket
    std::vector<size_t> starts_ = {0}; ///< buckets + 1
    std::vector<size_t> places_;       ///< of the pieces' first fragments, bucket by bucket
    std::vector<AnyFragment> fragments_;
};

template <class AnyFragment, uint32_t AnyFragment::*tile>
template <class Piece>
void FragmentBuckets<AnyFragment, tile>::fill(const std::vector<Piece>& pieces, uint32_t tiles,
                                              Executor& executor) {
    tiles_ = tiles;
    shift_ = 0;
    while (tiles > 0 && (tiles - 1) >> shift_ >= kMaxBuckets) ++shift_;
    const size_t buckets = tiles == 0 ? 0 : ((tiles - 1) >> shift_) + 1;

    places_.resize(pieces.size() * buckets);
    executor.forRange(pieces.size(), 1, [&](size_t piece, size_t) {
        std::array<size_t, kMaxBuckets> counts{};
        for (const AnyFragment& fragment : pieces[piece].fragments)
            ++counts[fragment.*tile >> shift_];
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
        for (const AnyFragment& fragment : pieces[piece].fragments)
            fragments_[next[fragment.*tile >> shift_]++] = fragment;
    });
}

} // namespace dirt
