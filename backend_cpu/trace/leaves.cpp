#include "backend_cpu/trace/leaves.h"

#include "backend_cpu/trace/leaf_boxes.h"
#include "backend_cpu/trace/without_area.h"
#include "core/grid/repeated.h"
#include "core/trace/ray.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <span>
#include <utility>

// Compiles what follows once for each instruction set that Highway knows on this architecture.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "backend_cpu/trace/leaves.cpp"
#include <hwy/foreach_target.h>

#include "backend_cpu/trace/leaf_items-inl.h"
#include "backend_cpu/trace/node_boxes-inl.h"

#ifndef DIRT_LEAVES_SIZES
#define DIRT_LEAVES_SIZES
namespace dirt {
namespace {

constexpr size_t kTilesPerPiece = 16;
constexpr size_t kBoxedPerPiece = 4096;
using TreeSize = Leaves::TreeSize;

constexpr uint32_t kWidth = LeafBoxes::kChildren;

using Sizes = std::array<uint32_t, kWidth>;

/// Cuts \p count things into at most 16 parts, as equal as can be, the larger ones first.
int cut(uint32_t count, Sizes& sizes) {
    const uint32_t parts = std::min(count, kWidth);
    for (uint32_t i = 0; i < parts; ++i) sizes[i] = count / parts + (i < count % parts ? 1 : 0);
    return (int) parts;
}

uint32_t blocksOf(uint32_t triangles) {
    return (triangles + kWidth - 1) / kWidth;
}

/// Nodes of the tree over blocks.
uint32_t nodesOver(uint32_t blocks) {
    if (blocks <= 1) return 0;
    Sizes sizes;
    const int count = cut(blocks, sizes);
    uint32_t nodes = 1;
    for (int i = 0; i < count && sizes[i] > 1; ++i) nodes += nodesOver(sizes[i]);
    return nodes;
}

/// Puts the lists of a tile's bins together where they fit into one block with their neighbours.
/// Calls visit(triangles) for each run of bins.
class Runs {
public:
    template <class Visit>
    void add(uint32_t listed, Visit&& visit) {
        if (size_ + listed > kWidth) end(visit);
        size_ += listed;
    }
    template <class Visit>
    void end(Visit&& visit) {
        if (size_ > 0) visit(std::exchange(size_, 0));
    }

private:
    uint32_t size_ = 0;
};

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

/// Builds the tree of one tile's runs into its place.
class TreeBuilder {
public:
    TreeBuilder(Leaves& leaves, LeafItems& items, std::vector<LeafBox>& boxes, TreeSize place)
        : leaves_(leaves), items_(items), boxes_(boxes), place_(place), nextNode_(place.nodes) {}

    /// Returns the root, as in TileDepths.
    uint32_t build(std::span<const uint32_t> runs) {
        boxes_.clear();
        uint32_t first = 0;
        for (const uint32_t count : runs) {
            const uint32_t inRun = blocksOf(count);
            const uint64_t* const order = items_.order(first, count);
            for (uint32_t i = 0; i < inRun; ++i) {
                const auto begin = (uint32_t) ((uint64_t) count * i / inRun);
                const auto end = (uint32_t) ((uint64_t) count * (i + 1) / inRun);
                addBlock(order + begin, end - begin);
            }
            first += count;
        }
        const uint32_t blocks = (uint32_t) boxes_.size();
        if (blocks == 1) return place_.blocks | TileDepths::kBlock;
        const uint32_t root = nextNode_++;
        overBlocks(leaves_.nodes[root], 0, blocks);
        return root;
    }

private:
    void addBlock(const uint64_t* order, uint32_t count) {
        LeafBlock& block = leaves_.blocks[place_.blocks + boxes_.size()];
        NodeBoxes boxes;
        for (uint32_t i = 0; i < count; ++i) {
            const LeafItem& item = items_[(uint32_t) order[i]];
            boxes.add(item.low, item.high);
            block.id[i] = item.id;
        }
        std::fill(block.id + count, block.id + kWidth, kNoPrimitive);
        boxes.write(block);
        boxes_.push_back(boxes.all());
    }

    /// The node over several blocks, counted from the first; returns the box around them.
    LeafBox overBlocks(LeafNode& node, uint32_t first, uint32_t blocks) {
        Sizes sizes;
        const int count = cut(blocks, sizes);
        int nodes = 0;
        while (nodes < count && sizes[nodes] > 1) ++nodes;
        node.nodes = (uint8_t) nodes;
        node.firstNode = nextNode_;
        nextNode_ += (uint32_t) nodes;

        NodeBoxes boxes;
        for (int i = 0; i < count; ++i) {
            if (i == nodes) node.firstBlock = place_.blocks + first;
            boxes.add(i < nodes ? overBlocks(leaves_.nodes[node.firstNode + i], first, sizes[i])
                                : boxes_[first]);
            first += sizes[i];
        }
        if (nodes == count) node.firstBlock = 0;
        boxes.write(node);
        return boxes.all();
    }

    Leaves& leaves_;
    LeafItems& items_;
    std::vector<LeafBox>& boxes_; ///< of the blocks
    TreeSize place_;
    uint32_t nextNode_;
};

/// The trees of tiles [begin, end), which lie in their places.
void BuildTrees(const FrameGeometry& geometry, const Grid& grid, Leaves& leaves, size_t begin,
                size_t end) {
    thread_local LeafItems items;
    thread_local std::vector<LeafBox> boxes;
    thread_local std::vector<uint32_t> runs;
    const int bins = grid.settings.bins;
    forEachTile(grid, begin, end, [&](int view, int tileInView, size_t tile) {
        const size_t cell = grid.cell(view, tileInView, 0);
        items.clear(grid.heads[cell + bins] - grid.heads[cell]);
        runs.clear();
        const auto addRun = [](uint32_t size) { runs.push_back(size); };
        Runs inBins;
        uint32_t count = 0;
        for (int bin = 0; bin < bins; ++bin) {
            const std::span<const uint32_t> list = grid.list(view, tileInView, bin);
            if (list.empty()) continue;
            const uint32_t first = count;
            count =
                items.add(count, list, geometry.triangles, boxOfCell(grid, view, tileInView, bin),
                          [&](uint32_t id) { return leaves.unhittable[id] != 0; });
            inBins.add(count - first, addRun);
        }
        inBins.end(addRun);
        TileDepths& depths = leaves.tiles[tile];
        if (count == 0) {
            depths = {}; // nothing that a ray hits
            return;
        }
        const View& v = grid.views[view];
        for (uint32_t i = 0; i < count; ++i) {
            const float low = items[i].low[v.axisW], high = items[i].high[v.axisW];
            depths.occupied |= v.signW > 0.0f ? depths.parts(low, high) : depths.parts(-high, -low);
        }
        depths.root = TreeBuilder(leaves, items, boxes, leaves.places[tile]).build(runs);
    });
}

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dirt {

HWY_EXPORT(BuildTrees);

uint64_t Leaves::bytes() const {
    return tiles.size() * sizeof(TileDepths) + nodes.size() * sizeof(LeafNode) +
           blocks.size() * sizeof(LeafBlock);
}

void fillLeaves(const FrameGeometry& geometry, const Grid& grid, Executor& executor,
                Leaves& leaves) {
    const int bins = grid.settings.bins;
    const size_t tiles = grid.firstTile.back(), count = geometry.triangles.size();
    leaves.unhittable.resize(count);
    std::atomic<bool> anyRepeated = false;
    executor.forRange(count, kBoxedPerPiece, [&](size_t begin, size_t end) {
        findWithoutArea({geometry.triangles.data() + begin, end - begin},
                        leaves.unhittable.data() + begin);
        for (size_t i = begin; i < end; ++i) {
            if (!isRepeated(geometry, i)) continue;
            leaves.unhittable[i] = 1;
            anyRepeated = true;
        }
    });
    leaves.leavesOutRepeated = anyRepeated;

    // Sizes first, so that every tree has its place whichever thread builds it.
    leaves.places.resize(tiles);
    leaves.tiles.resize(tiles);
    executor.forRange(tiles, kTilesPerPiece, [&](size_t begin, size_t end) {
        forEachTile(grid, begin, end, [&](int view, int tileInView, size_t tile) {
            leaves.tiles[tile] = TileDepths(grid.bounds(view, tileInView));
            TreeSize& size = leaves.places[tile] = {};
            const auto addRun = [&](uint32_t triangles) { size.blocks += blocksOf(triangles); };
            Runs inBins;
            for (int bin = 0; bin < bins; ++bin) {
                uint32_t listed = 0;
                for (const uint32_t id : grid.list(view, tileInView, bin))
                    listed += !leaves.unhittable[id];
                inBins.add(listed, addRun);
            }
            inBins.end(addRun);
            size.nodes = nodesOver(size.blocks);
        });
    });
    TreeSize sum;
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
