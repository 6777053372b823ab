#pragma once

#include "core/frame/executor.h"

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

/// The fragments of a frame in buckets of neighbouring tiles, each in the order of ids; so that
/// every bucket is some thread's own, and no list needs to be sorted.
class FragmentBuckets {
public:
    /// Takes the fragments of \p pieces, which follow one another in the order of ids. Keeps its
    /// memory.
    void fill(std::span<const RasterPiece> pieces, uint32_t tiles, Executor& executor);

    size_t count() const { return starts_.size() - 1; }
    uint32_t firstTile(size_t bucket) const { return (uint32_t) bucket << shift_; }
    uint32_t tiles(size_t bucket) const;
    std::span<const Fragment> operator[](size_t bucket) const {
        return {fragments_.data() + starts_[bucket], fragments_.data() + starts_[bucket + 1]};
    }
    uint64_t bytes() const { return fragments_.capacity() * sizeof(Fragment); }

private:
    static constexpr uint32_t kMaxBuckets = 256;

    uint32_t tiles_ = 0;
    unsigned shift_ = 0;               ///< tile to bucket
    std::vector<size_t> starts_ = {0}; ///< buckets + 1
    std::vector<size_t> places_;       ///< of the pieces' first fragments, bucket by bucket
    std::vector<Fragment> fragments_;
};

} // namespace dirt
