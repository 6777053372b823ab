#include "backend_cpu/leaves.h"

#include "backend_cpu/leaf_boxes.h"
#include "core/trace/determinant.h"
#include "core/trace/ray.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <span>
#include <utility>

namespace dirt {
namespace {

constexpr size_t kTilesPerPiece = 16;
constexpr uint32_t kWidth = LeafBlock::kTriangles;

/// Sizes of one tile's tree, without its root.
struct TreeSize {
    uint32_t blocks = 0, nodes = 0;
};

using Sizes = std::array<uint32_t, LeafNode::kChildren>;

/// Cuts \p count things into at most 16 parts, as equal as can be, the larger ones first.
int cut(uint32_t count, Sizes& sizes) {
    const uint32_t parts = std::min<uint32_t>(count, LeafNode::kChildren);
    for (uint32_t i = 0; i < parts; ++i) sizes[i] = count / parts + (i < count % parts ? 1 : 0);
    return (int) parts;
}

uint32_t blocksOf(size_t triangles) {
    return (uint32_t) ((triangles + kWidth - 1) / kWidth);
}

/// Nodes of the tree over one list.
uint32_t nodesOver(uint32_t blocks) {
    if (blocks <= 1) return 0;
    Sizes sizes;
    const int count = cut(blocks, sizes);
    uint32_t nodes = 1;
    for (int i = 0; i < count; ++i) nodes += nodesOver(sizes[i]);
    return nodes;
}

/// Nodes below that over several lists, with \p blocks blocks each.
uint32_t nodesBelow(std::span<const uint32_t> blocks) {
    Sizes sizes;
    const int count = cut((uint32_t) blocks.size(), sizes);
    uint32_t nodes = 0, list = 0;
    for (int i = 0; i < count; ++i) {
        nodes += sizes[i] == 1 ? nodesOver(blocks[list])
                               : 1 + nodesBelow(blocks.subspan(list, sizes[i]));
        list += sizes[i];
    }
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

/// Builds the tree of one tile's lists into its place.
class TreeBuilder {
public:
    using List = std::span<LeafItem>;

    TreeBuilder(const FrameGeometry& geometry, Leaves& leaves, TreeSize place)
        : geometry_(geometry), leaves_(leaves), nextBlock_(place.blocks), nextNode_(place.nodes) {}

    /// The node over several lists, each of one bin.
    void overLists(LeafNode& node, std::span<const List> lists) {
        Sizes sizes;
        const int count = cut((uint32_t) lists.size(), sizes);
        std::array<std::span<const List>, LeafNode::kChildren> parts;
        for (int i = 0, list = 0; i < count; list += (int) sizes[i++])
            parts[i] = lists.subspan(list, sizes[i]);
        const auto isNode = [](std::span<const List> part) {
            return part.size() > 1 || blocksOf(part[0].size()) > 1;
        };
        const auto end = std::stable_partition(parts.begin(), parts.begin() + count, isNode);
        start(node, count, (int) (end - parts.begin()));

        NodeBoxes boxes;
        for (int i = 0; i < count; ++i) {
            // Lists of neighbouring bins stand side by side.
            const List all(parts[i].front().data(),
                           parts[i].back().data() + parts[i].back().size());
            boxes.add(all);
            if (i >= node.nodes)
                writeBlock(leaves_.blocks[node.firstBlock + i - node.nodes], all);
            else if (parts[i].size() > 1)
                overLists(leaves_.nodes[node.firstNode + i], parts[i]);
            else
                overBlocks(leaves_.nodes[node.firstNode + i], all);
        }
        boxes.write(node);
    }

private:
    /// The node over one list of more than one block.
    void overBlocks(LeafNode& node, List items) {
        Sizes sizes{};
        const int count = cut(blocksOf(items.size()), sizes);
        arrange(items, sizes.data(), count);
        int nodes = 0;
        while (nodes < count && sizes[nodes] > 1) ++nodes;
        start(node, count, nodes);

        NodeBoxes boxes;
        for (int i = 0; i < count; ++i) {
            const List part = items.first(std::min<size_t>(sizes[i] * kWidth, items.size()));
            items = items.subspan(part.size());
            boxes.add(part);
            if (i < nodes)
                overBlocks(leaves_.nodes[node.firstNode + i], part);
            else
                writeBlock(leaves_.blocks[node.firstBlock + i - nodes], part);
        }
        boxes.write(node);
    }

    void start(LeafNode& node, int children, int nodes) {
        node.children = (uint8_t) children;
        node.nodes = (uint8_t) nodes;
        node.firstNode = nextNode_;
        node.firstBlock = nextBlock_;
        nextNode_ += (uint32_t) nodes;
        nextBlock_ += (uint32_t) (children - nodes);
    }

    /// Brings the items into the order of the parts: halves of halves, each of neighbours.
    void arrange(List items, const uint32_t* sizes, int parts) {
        if (parts == 1) return;
        const int half = parts / 2;
        size_t split = 0;
        for (int i = 0; i < half; ++i) split += (size_t) sizes[i] * kWidth;
        partition(items, split, widestAxis(items));
        arrange(items.first(split), sizes, half);
        arrange(items.subspan(split), sizes + half, parts - half);
    }

    /// Brings the items with the lowest middles along an axis to the front, \p split of them.
    void partition(List items, size_t split, int axis) {
        // Selected are numbers, which order like the middles and then the places; half as long as
        // to move the items about.
        keys_.resize(items.size());
        for (size_t i = 0; i < items.size(); ++i) {
            const float middle = items[i].low[axis] + items[i].high[axis];
            const uint32_t bits = std::bit_cast<uint32_t>(middle);
            const uint32_t ordered = bits ^ (bits >> 31 ? 0xffffffffu : 0x80000000u);
            keys_[i] = (uint64_t) ordered << 32 | i;
        }
        std::nth_element(keys_.begin(), keys_.begin() + split, keys_.end());
        moved_.assign(items.begin(), items.end());
        for (size_t i = 0; i < items.size(); ++i) items[i] = moved_[(uint32_t) keys_[i]];
    }

    void writeBlock(LeafBlock& block, List items) {
        const size_t count = items.size();
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
    std::vector<uint64_t> keys_;
    std::vector<LeafItem> moved_;
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
    return tiles.size() * sizeof(DepthBounds) + nodes.size() * sizeof(LeafNode) +
           blocks.size() * sizeof(LeafBlock);
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
    std::vector<TreeSize> sizes(tiles + 1);
    leaves.tiles.resize(tiles);
    forEachTile(grid, executor, [&](int view, int tileInView, size_t tile) {
        const DepthBounds& bounds = grid.bounds(view, tileInView);
        leaves.tiles[tile] = {bounds.near, bounds.far};
        thread_local std::vector<uint32_t> blocks;
        blocks.clear();
        for (int bin = 0; bin < bins; ++bin) {
            size_t count = 0;
            for (const uint32_t id : grid.list(view, tileInView, bin)) count += !unhittable[id];
            if (count == 0) continue;
            blocks.push_back(blocksOf(count));
            sizes[tile].blocks += blocks.back();
        }
        sizes[tile].nodes = nodesBelow(blocks);
    });
    TreeSize sum{0, (uint32_t) tiles};
    for (TreeSize& size : sizes) {
        const TreeSize own = std::exchange(size, sum);
        sum = {sum.blocks + own.blocks, sum.nodes + own.nodes};
    }
    leaves.nodes.resize(sum.nodes);
    leaves.blocks.resize(sum.blocks);

    forEachTile(grid, executor, [&](int view, int tileInView, size_t tile) {
        thread_local std::vector<LeafItem> items;
        thread_local std::vector<std::span<LeafItem>> lists;
        items.clear();
        lists.clear();
        items.reserve(grid.heads[grid.cell(view, tileInView, 0) + bins] -
                      grid.heads[grid.cell(view, tileInView, 0)]);
        for (int bin = 0; bin < bins; ++bin) {
            const LeafItem cellBox = boxOfCell(grid, view, tileInView, bin);
            const size_t first = items.size();
            for (const uint32_t id : grid.list(view, tileInView, bin))
                if (!unhittable[id])
                    items.push_back(boxOfPart(geometry.triangles[id], id, cellBox));
            if (items.size() > first) lists.emplace_back(items.begin() + first, items.end());
        }
        if (lists.empty())
            leaves.tiles[tile] = {}; // nothing that a ray hits
        else
            TreeBuilder(geometry, leaves, sizes[tile]).overLists(leaves.nodes[tile], lists);
    });
}

} // namespace dirt
