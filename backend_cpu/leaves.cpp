#include "backend_cpu/leaves.h"

#include "backend_cpu/leaf_boxes.h"
#include "core/trace/determinant.h"
#include "core/trace/ray.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace dirt {
namespace {

constexpr size_t kTilesPerPiece = 64;
constexpr uint32_t kWidth = LeafBlock::kTriangles;

/// Sizes of one list's tree.
struct TreeSize {
    uint32_t blocks = 0, nodes = 0;
};

/// Blocks of the parts into which a list of \p blocks blocks is cut: halves of halves, as equal as
/// can be, the larger ones first.
int childBlocks(uint32_t blocks, std::array<uint32_t, LeafNode::kChildren>& sizes) {
    const uint32_t count = std::min<uint32_t>(blocks, LeafNode::kChildren);
    for (uint32_t i = 0; i < count; ++i) sizes[i] = blocks / count + (i < blocks % count ? 1 : 0);
    return (int) count;
}

uint32_t nodesOver(uint32_t blocks) {
    if (blocks <= 1) return 0;
    std::array<uint32_t, LeafNode::kChildren> sizes;
    const int count = childBlocks(blocks, sizes);
    uint32_t nodes = 1;
    for (int i = 0; i < count; ++i) nodes += nodesOver(sizes[i]);
    return nodes;
}

/// Whether the triangle has no area, exactly. A component of the normal has two products of two
/// differences: below 2^-51 of them off in double.
bool hasNoArea(const Triangle& t) {
    for (int x = 0; x < 3; ++x) {
        const int y = (x + 1) % 3;
        const double bx = (double) t.b[x] - t.a[x], by = (double) t.b[y] - t.a[y];
        const double cx = (double) t.c[x] - t.a[x], cy = (double) t.c[y] - t.a[y];
        const double first = bx * cy, second = by * cx;
        if (std::abs(first - second) > 0x1p-49 * (std::abs(first) + std::abs(second))) return false;
    }
    for (const glm::vec3 axis : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)})
        if (directionDeterminantExact(axis, t.a, t.b, t.c) != 0.0) return false;
    return true;
}

/// Builds the tree of one cell's list into its place.
class TreeBuilder {
public:
    TreeBuilder(const FrameGeometry& geometry, Leaves& leaves, uint32_t firstBlock,
                uint32_t firstNode)
        : geometry_(geometry), leaves_(leaves), nextBlock_(firstBlock), nextNode_(firstNode) {}

    void build(std::vector<LeafItem>& items) {
        const uint32_t blocks = ((uint32_t) items.size() + kWidth - 1) / kWidth;
        if (blocks == 1) {
            writeBlock(leaves_.blocks[nextBlock_], items.data(), items.size());
            return;
        }
        node(nextNode_++, items.data(), items.size(), blocks);
    }

private:
    /// Brings the items into the order of the children: each half of them gets neighbours.
    void arrange(LeafItem* items, size_t count, const uint32_t* sizes, int children) {
        if (children == 1) return;
        const int half = children / 2;
        size_t split = 0;
        for (int i = 0; i < half; ++i) split += (size_t) sizes[i] * kWidth;
        const int axis = widestAxis(items, count);
        std::nth_element(items, items + split, items + count,
                         [axis](const LeafItem& a, const LeafItem& b) {
                             const float x = a.low[axis] + a.high[axis];
                             const float y = b.low[axis] + b.high[axis];
                             return x < y || (x == y && a.id < b.id);
                         });
        arrange(items, split, sizes, half);
        arrange(items + split, count - split, sizes + half, children - half);
    }

    void node(uint32_t index, LeafItem* items, size_t count, uint32_t blocks) {
        std::array<uint32_t, LeafNode::kChildren> sizes;
        const int children = childBlocks(blocks, sizes);
        arrange(items, count, sizes.data(), children);

        int inner = 0;
        while (inner < children && sizes[inner] > 1) ++inner;
        LeafNode& node = leaves_.nodes[index];
        node.children = (uint8_t) children;
        node.nodes = (uint8_t) inner;
        node.firstNode = nextNode_;
        node.firstBlock = nextBlock_;
        nextNode_ += (uint32_t) inner;
        nextBlock_ += (uint32_t) (children - inner);

        NodeBoxes boxes;
        LeafItem* item = items;
        for (int i = 0; i < children; ++i) {
            const size_t size = std::min((size_t) sizes[i] * kWidth, count - (item - items));
            boxes.add(item, size);
            if (i < inner)
                this->node(node.firstNode + i, item, size, sizes[i]);
            else
                writeBlock(leaves_.blocks[node.firstBlock + i - inner], item, size);
            item += size;
        }
        boxes.write(node);
    }

    void writeBlock(LeafBlock& block, const LeafItem* items, size_t count) {
        for (size_t i = 0; i < kWidth; ++i) {
            const uint32_t id = items[std::min(i, count - 1)].id;
            const Triangle& t = geometry_.triangles[id];
            const glm::vec3* const vertices[3] = {&t.a, &t.b, &t.c};
            for (int v = 0; v < 3; ++v)
                for (int axis = 0; axis < 3; ++axis)
                    block.vertex[v][axis][i] = (*vertices[v])[axis];
            block.id[i] = i < count ? id : kNoPrimitive;
        }
    }

    const FrameGeometry& geometry_;
    Leaves& leaves_;
    uint32_t nextBlock_, nextNode_;
};

/// Calls visit(view, tile in the view, tile over all views).
template <class Visit>
void forEachTile(const Grid& grid, Executor& executor, Visit&& visit) {
    executor.forRange(grid.firstTile.back(), kTilesPerPiece, [&](size_t begin, size_t end) {
        int view = 0;
        for (size_t tile = begin; tile < end; ++tile) {
            while (tile >= grid.firstTile[view + 1]) ++view;
            visit(view, (int) (tile - grid.firstTile[view]), tile);
        }
    });
}

} // namespace

float LeafNode::step(int axis) const {
    return std::bit_cast<float>((uint32_t) exponent[axis] << 23);
}

uint64_t Leaves::bytes() const {
    return roots.size() * sizeof(uint32_t) + tiles.size() * sizeof(TileDepths) +
           nodes.size() * sizeof(LeafNode) + blocks.size() * sizeof(LeafBlock);
}

void fillLeaves(const FrameGeometry& geometry, const Grid& grid, Executor& executor,
                Leaves& leaves) {
    const int bins = grid.settings.bins;
    const size_t tiles = grid.firstTile.back();
    std::vector<uint8_t> unhittable(geometry.triangles.size());
    executor.forRange(unhittable.size(), 16384, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) unhittable[i] = hasNoArea(geometry.triangles[i]);
    });

    // Sizes first, so that every tree has its place whichever thread builds it.
    std::vector<TreeSize> sizes(tiles * bins + 1);
    leaves.tiles.resize(tiles);
    forEachTile(grid, executor, [&](int view, int tileInView, size_t tile) {
        const DepthBounds& bounds = grid.bounds(view, tileInView);
        leaves.tiles[tile] = {bounds.near, bounds.far, BinMap(bounds, bins).scale};
        for (size_t cell = tile * bins; cell < (tile + 1) * bins; ++cell) {
            uint32_t count = 0;
            for (uint32_t i = grid.heads[cell]; i < grid.heads[cell + 1]; ++i)
                count += unhittable[grid.ids[i]] ? 0 : 1;
            const uint32_t blocks = (count + kWidth - 1) / kWidth;
            sizes[cell] = {blocks, nodesOver(blocks)};
        }
    });
    TreeSize sum;
    for (TreeSize& size : sizes) {
        const TreeSize own = size;
        size = sum;
        sum = {sum.blocks + own.blocks, sum.nodes + own.nodes};
    }
    leaves.roots.resize(tiles * bins);
    leaves.nodes.resize(sum.nodes);
    leaves.blocks.resize(sum.blocks);

    forEachTile(grid, executor, [&](int view, int tileInView, size_t tile) {
        thread_local std::vector<LeafItem> items;
        for (int bin = 0; bin < bins; ++bin) {
            const size_t cell = tile * bins + bin;
            const TreeSize place = sizes[cell];
            const bool isBlock = sizes[cell + 1].blocks - place.blocks == 1;
            leaves.roots[cell] = Leaves::kEmpty;
            if (sizes[cell + 1].blocks == place.blocks) continue;
            leaves.roots[cell] = isBlock ? place.blocks | Leaves::kBlock : place.nodes;
            const LeafItem cellBox = boxOfCell(grid, view, tileInView, bin);
            items.clear();
            for (uint32_t id : grid.list(view, tileInView, bin))
                if (!unhittable[id])
                    items.push_back(boxOfPart(geometry.triangles[id], id, cellBox));
            TreeBuilder(geometry, leaves, place.blocks, place.nodes).build(items);
        }
    });
}

} // namespace dirt
