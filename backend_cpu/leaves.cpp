#include "backend_cpu/leaves.h"

#include "backend_cpu/leaf_boxes.h"
#include "backend_cpu/without_area.h"
#include "core/trace/ray.h"

#include <algorithm>
#include <bit>
#include <span>
#include <utility>

// Compiles what follows once for each instruction set that Highway knows on this architecture.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "backend_cpu/leaves.cpp"
#include <hwy/foreach_target.h>

#include "backend_cpu/leaf_items-inl.h"
#include "backend_cpu/node_boxes-inl.h"

#ifndef DIRT_LEAVES_SIZES
#define DIRT_LEAVES_SIZES
namespace dirt {
namespace {

constexpr size_t kTilesPerPiece = 16;
constexpr size_t kTrianglesPerPiece = 4096;
using TreeSize = Leaves::TreeSize;

constexpr uint32_t kWidth = LeafBlock::kTriangles;

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

/// Calls visit(view, tile in the view, tile) for tiles [begin, end) over all views.
template <class Visit>
void forEachTile(const Grid& grid, size_t begin, size_t end, Visit&& visit) {
    int view = 0;
    for (size_t tile = begin; tile < end; ++tile) {
        while (tile >= grid.firstTile[view + 1]) ++view;
        visit(view, (int) (tile - grid.firstTile[view]), tile);
    }
}

} // namespace
} // namespace dirt
#endif

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

/// Builds the tree of one tile's lists into its place.
class TreeBuilder {
public:
    /// Items [begin, end), those of one list or of several neighbours.
    struct List {
        uint32_t begin, end;
        uint32_t size() const { return end - begin; }
    };

    TreeBuilder(const FrameGeometry& geometry, Leaves& leaves, LeafItems& items, TreeSize place)
        : geometry_(geometry), leaves_(leaves), items_(items), nextBlock_(place.blocks),
          nextNode_(place.nodes) {}

    /// The node over several lists, each of one bin; returns the box around them.
    LeafBox overLists(LeafNode& node, std::span<const List> lists) {
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
            const List all{parts[i].front().begin, parts[i].back().end};
            if (i >= node.nodes)
                boxes.add(writeBlock(leaves_.blocks[node.firstBlock + i - node.nodes], all));
            else if (parts[i].size() > 1)
                boxes.add(overLists(leaves_.nodes[node.firstNode + i], parts[i]));
            else
                boxes.add(overBlocks(leaves_.nodes[node.firstNode + i], all));
        }
        boxes.write(node);
        return boxes.all();
    }

private:
    /// The node over one list of more than one block.
    LeafBox overBlocks(LeafNode& node, List list) {
        Sizes sizes{};
        const int count = cut(blocksOf(list.size()), sizes);
        arrange(list, sizes.data(), count);
        int nodes = 0;
        while (nodes < count && sizes[nodes] > 1) ++nodes;
        start(node, count, nodes);

        NodeBoxes boxes;
        for (int i = 0; i < count; ++i) {
            const List part{list.begin, std::min(list.begin + sizes[i] * kWidth, list.end)};
            list.begin = part.end;
            if (i < nodes)
                boxes.add(overBlocks(leaves_.nodes[node.firstNode + i], part));
            else
                boxes.add(writeBlock(leaves_.blocks[node.firstBlock + i - nodes], part));
        }
        boxes.write(node);
        return boxes.all();
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
    void arrange(List list, const uint32_t* sizes, int parts) {
        if (parts == 1) return;
        const int half = parts / 2;
        uint32_t split = 0;
        for (int i = 0; i < half; ++i) split += sizes[i] * kWidth;
        items_.split(list.begin, list.end, split);
        arrange({list.begin, list.begin + split}, sizes, half);
        arrange({list.begin + split, list.end}, sizes + half, parts - half);
    }

    LeafBox writeBlock(LeafBlock& block, List list) {
        const uint32_t count = list.size();
        for (uint32_t i = 0; i < kWidth; ++i) {
            const uint32_t id = items_[list.begin + std::min(i, count - 1)].id;
            const Triangle& t = geometry_.triangles[id];
            const glm::vec3* const vertices[3] = {&t.a, &t.b, &t.c};
            for (int v = 0; v < 3; ++v)
                for (int axis = 0; axis < 3; ++axis)
                    block.vertex[v][axis][i] = (*vertices[v])[axis];
            block.id[i] = i < count ? id : kNoPrimitive;
        }
        return items_.box(list.begin, list.end);
    }

    const FrameGeometry& geometry_;
    Leaves& leaves_;
    LeafItems& items_;
    uint32_t nextBlock_, nextNode_;
};

/// The trees of tiles [begin, end), which lie in their places.
void BuildTrees(const FrameGeometry& geometry, const Grid& grid, Leaves& leaves, size_t begin,
                size_t end) {
    thread_local LeafItems items;
    thread_local std::vector<TreeBuilder::List> lists;
    const int bins = grid.settings.bins;
    forEachTile(grid, begin, end, [&](int view, int tileInView, size_t tile) {
        const size_t cell = grid.cell(view, tileInView, 0);
        items.reserve(grid.heads[cell + bins] - grid.heads[cell]);
        lists.clear();
        uint32_t count = 0;
        for (int bin = 0; bin < bins; ++bin) {
            const std::span<const uint32_t> list = grid.list(view, tileInView, bin);
            if (list.empty()) continue;
            const uint32_t first = count;
            const LeafBox cellBox = boxOfCell(grid, view, tileInView, bin);
            count = items.add(count, list, geometry.triangles, cellBox,
                              [&](uint32_t id) { return leaves.unhittable[id] != 0; });
            if (count == first) continue;
            lists.push_back({first, count});
        }
        TileDepths& depths = leaves.tiles[tile];
        if (lists.empty()) {
            depths = {}; // nothing that a ray hits
            return;
        }
        const View& v = grid.views[view];
        for (uint32_t i = 0; i < count; ++i) {
            const float low = items[i].low[v.axisW], high = items[i].high[v.axisW];
            depths.occupied |= v.signW > 0.0f ? depths.parts(low, high) : depths.parts(-high, -low);
        }
        TreeBuilder(geometry, leaves, items, leaves.places[tile])
            .overLists(leaves.nodes[tile], lists);
    });
}

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dirt {

HWY_EXPORT(BuildTrees);

float LeafNode::step(int axis) const {
    return std::bit_cast<float>((uint32_t) exponent[axis] << 23);
}

uint64_t Leaves::bytes() const {
    return tiles.size() * sizeof(TileDepths) + nodes.size() * sizeof(LeafNode) +
           blocks.size() * sizeof(LeafBlock);
}

void fillLeaves(const FrameGeometry& geometry, const Grid& grid, Executor& executor,
                Leaves& leaves) {
    const int bins = grid.settings.bins;
    const size_t tiles = grid.firstTile.back(), count = geometry.triangles.size();
    leaves.unhittable.resize(count);
    executor.forRange(count, kTrianglesPerPiece, [&](size_t begin, size_t end) {
        findWithoutArea({geometry.triangles.data() + begin, end - begin},
                        leaves.unhittable.data() + begin);
    });

    // Sizes first, so that every tree has its place whichever thread builds it.
    leaves.places.resize(tiles);
    leaves.tiles.resize(tiles);
    executor.forRange(tiles, kTilesPerPiece, [&](size_t begin, size_t end) {
        thread_local std::vector<uint32_t> blocks;
        forEachTile(grid, begin, end, [&](int view, int tileInView, size_t tile) {
            leaves.tiles[tile] = TileDepths(grid.bounds(view, tileInView));
            blocks.clear();
            TreeSize& size = leaves.places[tile] = {};
            for (int bin = 0; bin < bins; ++bin) {
                uint32_t listed = 0;
                for (const uint32_t id : grid.list(view, tileInView, bin))
                    listed += !leaves.unhittable[id];
                if (listed == 0) continue;
                blocks.push_back(blocksOf(listed));
                size.blocks += blocks.back();
            }
            size.nodes = nodesBelow(blocks);
        });
    });
    TreeSize sum{0, (uint32_t) tiles};
    for (TreeSize& size : leaves.places) {
        const TreeSize own = std::exchange(size, sum);
        sum = {sum.blocks + own.blocks, sum.nodes + own.nodes};
    }
    leaves.nodes.resize(sum.nodes);
    leaves.blocks.resize(sum.blocks);

    executor.forRange(tiles, kTilesPerPiece, [&](size_t begin, size_t end) {
        HWY_DYNAMIC_DISPATCH(BuildTrees)(geometry, grid, leaves, begin, end);
    });
}

} // namespace dirt
#endif // HWY_ONCE
