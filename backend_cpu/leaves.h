#pragma once

#include "core/frame/executor.h"
#include "core/grid/grid.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cstdint>
#include <vector>

namespace dirt {

/// Eight triangles, coordinate by coordinate, for one SIMD test. A list that does not fill its
/// last block repeats a triangle there, under the id kNoPrimitive.
struct alignas(64) LeafBlock {
    static constexpr int kTriangles = 8;
    float vertex[3][3][kTriangles]; ///< vertex, axis of the grid frame, triangle
    uint32_t id[kTriangles];

    Triangle triangle(size_t i) const {
        const auto corner = [&](int v) {
            return glm::vec3(vertex[v][0][i], vertex[v][1][i], vertex[v][2][i]);
        };
        return {corner(0), corner(1), corner(2)};
    }
};

/// Boxes of up to 16 parts of one tile's lists, in steps of a 254th of the whole or less, rounded
/// outwards. A part is a further node or a block; the nodes come first.
struct alignas(64) LeafNode {
    static constexpr int kChildren = 16;
    uint8_t bound[2][3][kChildren]; ///< low and high; axis; child
    float origin[3];
    uint8_t exponent[3]; ///< of the step, a power of two, as in the float's bits
    uint8_t children;
    uint32_t firstNode, firstBlock;
    uint8_t nodes; ///< children that are nodes

    float step(int axis) const;
};
static_assert(sizeof(LeafNode) == 128 && sizeof(LeafBlock) == 320);

/// The depths between which a tile holds anything that a ray hits, and which of 32 equal parts of
/// them do: most of what a ray passes in mid-air is a gap between a near and a far thing.
struct TileDepths {
    static constexpr int kParts = 32;
    float near = FLT_MAX, far = -FLT_MAX;
    float partsPerDepth = 0.0f;
    uint32_t occupied = 0; ///< a bit a part

    TileDepths() = default;
    explicit TileDepths(const DepthBounds& bounds)
        : near(bounds.near), far(bounds.far), partsPerDepth(BinMap(bounds, kParts).scale) {}

    /// The parts that depths [\p low, \p high] meet: monotone in both.
    uint32_t parts(float low, float high) const {
        return (~0u << partOf(low)) & (~0u >> (kParts - 1 - partOf(high)));
    }

private:
    int partOf(float depth) const {
        const float part = (depth - near) * partsPerDepth;
        return (int) std::min(std::max(part, 0.0f), (float) (kParts - 1));
    }
};

/// The id buffer as it is traced. Each cell's list stands in blocks of eight neighbouring
/// triangles, and each tile's lists under a tree of nodes, bin by bin at its top, whose boxes hold
/// the triangles' parts in their cells; so a ray tests few of them. Triangles without area, which
/// no ray hits, are left out.
struct Leaves {
    /// Sizes of one tile's tree without its root, and where it lies.
    struct TreeSize {
        uint32_t blocks = 0, nodes = 0;
    };

    std::vector<TileDepths> tiles; ///< in the numbering over all views; empty without triangles
    std::vector<LeafNode> nodes;   ///< those of the tiles first, in the same numbering
    std::vector<LeafBlock> blocks;

    // Kept from frame to frame, while they are filled.
    std::vector<TreeSize> places;    ///< of the tiles' trees
    std::vector<uint8_t> unhittable; ///< per triangle: without area

    uint64_t bytes() const;
};

/// Lays out the lists of \p grid. The same bits for any number of threads.
void fillLeaves(const FrameGeometry& geometry, const Grid& grid, Executor& executor,
                Leaves& leaves);

} // namespace dirt
