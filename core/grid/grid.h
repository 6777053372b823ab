#pragma once

#include "core/grid/clip.h"
#include "core/grid/view.h"
#include "shaders/shared/bins.h"

#include <cfloat>
#include <cstdint>
#include <span>
#include <vector>

namespace dirt {

/// Nearest and farthest depth of any primitive part in a tile (or a block of tiles).
struct DepthBounds {
    float near = FLT_MAX;
    float far = -FLT_MAX;

    bool empty() const { return near > far; }
    void include(float lo, float hi) {
        near = lo < near ? lo : near;
        far = hi > far ? hi : far;
    }
};

/// The map from depth to bin of one tile, shared by construction and traversal (G3): monotone.
struct BinMap {
    float near, scale;
    int bins;

    BinMap(const DepthBounds& bounds, int bins)
        : near(bounds.near), scale(binsPerDepth(bounds.near, bounds.far, bins)), bins(bins) {}
    int operator()(float w) const { return binOf(w, near, scale, bins); }
};

/// Min-max mip chain over one view's tiles. Level 0 is the tiles' bounds; level L has
/// ceil(columns / 2^L) x ceil(rows / 2^L) cells, the last one is 1 x 1.
struct DepthPyramid {
    struct Level {
        int columns = 0, rows = 0;
        std::vector<DepthBounds> bounds; ///< row-major
        const DepthBounds& at(int column, int row) const {
            return bounds[(size_t) row * columns + column];
        }
    };
    std::vector<Level> levels;
};

/// The acceleration data structure: views, depth pyramids and the id buffer.
struct Grid {
    GridSettings settings;
    std::vector<View> views;
    std::vector<DepthPyramid> pyramids; ///< one per view

    /// Id buffer: the list of cell c is ids[heads[c]] … ids[heads[c + 1]), in increasing order.
    std::vector<uint32_t> heads; ///< cells + 1
    std::vector<uint32_t> ids;

    /// Triangles that hold the eye, in increasing order: a point of rays that is in no tile.
    std::vector<uint32_t> atEye;

    /// First tile of each view in the numbering over all views (views + 1 entries).
    std::vector<uint32_t> firstTile;

    const DepthBounds& bounds(int view, int tile) const {
        return pyramids[view].levels[0].bounds[tile];
    }
    size_t cell(int view, int tile, int bin) const {
        return ((size_t) firstTile[view] + tile) * settings.bins + bin;
    }
    /// The primitives listed in one bin of one tile.
    std::span<const uint32_t> list(int view, int tile, int bin) const {
        const size_t c = cell(view, tile, bin);
        return {ids.data() + heads[c], ids.data() + heads[c + 1]};
    }
};

/// At most this many (view, tile, bin) cells: their list heads alone take 4 GiB.
inline constexpr uint64_t kMaxCells = 1ull << 30;

/// Clear: views, and pyramids with nothing but empty tiles. Throws InputError where the cells
/// exceed kMaxCells.
Grid makeEmptyGrid(const Camera& camera, const GridSettings& settings);

/// Throws InputError where a list entry could not be addressed with 32 bits.
void checkEntryCount(uint64_t entries);

/// Whether the closed triangle holds the eye, exactly. (One without area may be taken for one that
/// does; no ray hits it.)
bool holdsEye(const Triangle& triangle);

/// The ids of all triangles that hold the eye.
std::vector<uint32_t> trianglesAtEye(const FrameGeometry& geometry);

/// FillDepthMipmap for one view: the levels above the tiles' bounds.
void buildPyramid(DepthPyramid& pyramid);

/// The whole construction, pass after pass, triangle after triangle: the readable definition and
/// the oracle of every other builder.
Grid buildGrid(const FrameGeometry& geometry, const Camera& camera, const GridSettings& settings);

} // namespace dirt
