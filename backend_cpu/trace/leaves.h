#pragma once

#include "core/base/executor.h"
#include "core/grid/grid.h"

#include <bit>
#include <cfloat>
#include <cstdint>
#include <vector>

namespace dirt {

/// Boxes of up to 16 things, in steps of a 254th of the whole or less, rounded outwards.
struct LeafBoxes {
    static constexpr int kChildren = 16;
    uint8_t bound[2][3][kChildren]; ///< low and high; axis; child
    float origin[3];
    uint8_t exponent[3]; ///< of the step, a power of two, as in the float's bits
    uint8_t children;

    float step(int axis) const { return std::bit_cast<float>((uint32_t) exponent[axis] << 23); }
};

/// Boxes of parts of one tile's lists. A part is a further node or a block; the nodes come first.
struct alignas(64) LeafNode : LeafBoxes {
    uint32_t firstNode, firstBlock;
    uint8_t nodes; ///< children that are nodes
    uint8_t unused[7] = {};
};

/// Boxes of up to 16 triangles' parts in their cells.
struct alignas(64) LeafBlock : LeafBoxes {
    uint32_t id[kChildren];
    uint32_t unused[4] = {};
};
static_assert(sizeof(LeafNode) == 128 && sizeof(LeafBlock) == 192);

/// The depths between which a tile holds anything that a ray hits, and which of 32 equal parts of
/// them do: most of what a ray passes in mid-air is a gap between a near and a far thing.
struct TileDepths {
    static constexpr int kParts = 32;
    float near = FLT_MAX, far = -FLT_MAX;
    float partsPerDepth = 0.0f;
    uint32_t occupied = 0; ///< a bit a part
    /// Where the tile's tree begins: a block with kBlock, a node without.
    uint32_t root = 0;
    static constexpr uint32_t kBlock = 1u << 31;

    TileDepths() = default;
    explicit TileDepths(const DepthBounds& bounds)
        : near(bounds.near), far(bounds.far), partsPerDepth(binsPerDepth(near, far, kParts)) {}

    /// The parts that depths [\p low, \p high] meet: monotone in both. A call would cost the walk
    /// more than this does.
    [[gnu::always_inline]] uint32_t parts(float low, float high) const {
        return (~0u << partOf(low)) & (~0u >> (kParts - 1 - partOf(high)));
    }

private:
    [[gnu::always_inline]] int partOf(float depth) const {
        return binOf(depth, near, partsPerDepth, kParts);
    }
};

/// The id buffer as it is traced. Each tile's lists stand in blocks of 16 neighbouring triangles or
/// some fewer, under a tree of nodes, whose boxes hold the triangles' parts in their cells; so a
/// ray tests few triangles. Those that no ray hits are left out: without area, or repeated (see
/// isRepeated).
struct Leaves {
    /// Sizes of one tile's tree, and where it lies.
    struct TreeSize {
        uint32_t blocks = 0, nodes = 0;
    };

    std::vector<TileDepths> tiles; ///< in the numbering over all views; empty without triangles
    std::vector<LeafNode> nodes;
    std::vector<LeafBlock> blocks;

    // Kept from frame to frame, while they are filled.
    std::vector<TreeSize> places;    ///< of the tiles' trees
    std::vector<uint8_t> unhittable; ///< per triangle: without area, or repeated

    bool leavesOutRepeated = false; ///< some are, which is right for the geometry's holes alone

    uint64_t bytes() const;
};

/// Lays out the lists of \p grid. The same bits for any number of threads.
void fillLeaves(const FrameGeometry& geometry, const Grid& grid, Executor& executor,
                Leaves& leaves);

} // namespace dirt
