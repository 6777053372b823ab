#include "core/grid/scan.h"
#include "core/replay/dumped_view.h"
#include "core/replay/exact_part.h"
#include "core/replay/judge_structure.h"
#include "shaders/shared/layouts.h"

#include <cstdio>

namespace dirt {

namespace {

std::string number(double x) {
    char text[40];
    std::snprintf(text, sizeof text, "%.9g", x);
    return text;
}

std::string boundsText(const DepthBounds& bounds) {
    return bounds.empty() ? "no bounds" : number(bounds.near) + " to " + number(bounds.far);
}

bool same(const DepthBounds& a, const DepthBounds& b) {
    return (a.empty() && b.empty()) || (a.near == b.near && a.far == b.far);
}

/// A tile whose bounds are not those of core's definition.
struct Doubt {
    bool isOpen = false; ///< there is one
    /// The first triangle whose part in the tile itself the bounds leave out; and of which, of the
    /// part that has to be inside, only what is in the guard band.
    uint32_t cut = kNoPrimitive, cutInBand = kNoPrimitive;
    DepthBounds allowed; ///< of the parts that may be inside
};

/// Decides the doubtful tiles of one view.
class DepthDoubts {
public:
    DepthDoubts(const ReplayInput& input, uint32_t view, std::vector<Doubt>& doubts,
                JudgedPass& found)
        : input_(input), grid_(*input.grid), view_(view), doubts_(doubts), found_(found) {}

    void decide() {
        // Whatever is within kTight is proposed.
        const View wide = withGuardBand(grid_.views[view_], grid_.settings.tile, 2.0 * kTight);
        const auto& triangles = input_.geometry.triangles;
        for (uint32_t id = 0; id < triangles.size(); ++id)
            scanTriangle(
                triangles[id], wide, [&](int tile) { return doubts_[(size_t) tile].isOpen; },
                [&](int tile, DepthInterval) { weigh(id, (uint32_t) tile); });
        for (uint32_t tile = 0; tile < doubts_.size(); ++tile)
            if (doubts_[tile].isOpen) close(tile);
    }

private:
    const DepthBounds& bounds(uint32_t tile) const { return grid_.bounds((int) view_, (int) tile); }
    ReplayPlace place(uint32_t tile) const {
        ReplayPlace at;
        at.view = view_;
        at.tile = tile;
        return at;
    }

    ExactDepths part(uint32_t id, uint32_t tile, double widened) const {
        return exactPart(input_.geometry.triangles[id], grid_.views[view_], grid_.settings.tile,
                         tile, widened);
    }
    bool leavesOut(uint32_t tile, const ExactDepths& part) const {
        const DepthBounds& dumped = bounds(tile);
        return part.meets && (dumped.empty() || compare(dumped.near, part.near) > 0 ||
                              compare(dumped.far, part.far) < 0);
    }

    void weigh(uint32_t id, uint32_t tile) {
        Doubt& doubt = doubts_[tile];
        const ExactDepths may = part(id, tile, kTight);
        if (may.meets) doubt.allowed.include(floatBelow(may.near), floatAbove(may.far));
        if (doubt.cut != kNoPrimitive || !leavesOut(tile, part(id, tile, kComplete))) return;
        if (leavesOut(tile, part(id, tile, 0.0)))
            doubt.cut = id;
        else if (doubt.cutInBand == kNoPrimitive)
            doubt.cutInBand = id;
    }

    void close(uint32_t tile) {
        const Doubt& doubt = doubts_[tile];
        const DepthBounds &dumped = bounds(tile), &allowed = doubt.allowed;
        if (doubt.cut != kNoPrimitive) return cutShort(tile, doubt.cut, true);
        if (doubt.cutInBand != kNoPrimitive) return cutShort(tile, doubt.cutInBand, false);
        if (dumped.empty() ||
            (!allowed.empty() && dumped.near >= movedBy(allowed.near, -kDepthUlps) &&
             dumped.far <= movedBy(allowed.far, kDepthUlps))) {
            ++found_.right;
            return;
        }
        found_.fault("too wide", place(tile), [&] {
            return cellText(input_, place(tile)) + ": " + boundsText(dumped) +
                   (allowed.empty() ? ", where there is nothing"
                                    : " exceed the parts, which are at " + boundsText(allowed));
        });
    }

    void cutShort(uint32_t tile, uint32_t id, bool inTile) {
        ReplayPlace at = place(tile);
        at.primitive = id;
        found_.fault(inTile ? "cut short" : "cut short in the guard band", at, [&] {
            const ExactDepths left = part(id, tile, inTile ? 0.0 : kComplete);
            return cellText(input_, at) + ": " + boundsText(bounds(tile)) + " leave out triangle " +
                   std::to_string(id) + ", which is at " + number(left.near.value()) + " to " +
                   number(left.far.value()) + (inTile ? "" : " with the guard band");
        });
    }

    const ReplayInput& input_;
    const Grid& grid_;
    uint32_t view_;
    std::vector<Doubt>& doubts_;
    JudgedPass& found_;
};

/// One view's tiles.
JudgedPass judgeView(const ReplayInput& input, uint32_t view) {
    const Grid& grid = *input.grid;
    const auto tiles = (size_t) grid.views[view].tiles();
    std::vector<DepthBounds> defined(tiles);
    for (const Triangle& triangle : input.geometry.triangles)
        scanTriangle(triangle, grid.views[view], [&](int tile, DepthInterval depths) {
            defined[(size_t) tile].include(depths.near, depths.far);
        });
    JudgedPass found;
    found.compared = tiles;
    std::vector<Doubt> doubts(tiles);
    bool any = false;
    for (size_t tile = 0; tile < tiles; ++tile) {
        doubts[tile].isOpen = !same(defined[tile], grid.bounds((int) view, (int) tile));
        found.right += !doubts[tile].isOpen;
        any = any || doubts[tile].isOpen;
    }
    if (any) DepthDoubts(input, view, doubts, found).decide();
    return found;
}

} // namespace

std::string cellText(const ReplayInput& input, const ReplayPlace& place) {
    const Grid& grid = *input.grid;
    const uint32_t columns =
        (uint32_t) grid.pyramids[*place.view].levels[place.level.value_or(0)].columns;
    return "view " + input.manifest.viewNames[*place.view] +
           (place.level ? ", level " + std::to_string(*place.level) : "") + ", column " +
           std::to_string(*place.tile % columns) + ", row " +
           std::to_string(*place.tile / columns) +
           (place.bin ? ", bin " + std::to_string(*place.bin) : "");
}

JudgedPass judgeFillDepth(const ReplayInput& input, Executor& executor) {
    JudgedPass pass;
    pass.pass = "FillDepth";
    pass.buffer = "depth bounds";
    pass.addPieces(executor, input.grid->views.size(), 1,
                   [&](size_t view, size_t) { return judgeView(input, (uint32_t) view); });
    return pass;
}

JudgedPass judgeFillDepthMipmap(const ReplayInput& input) {
    JudgedPass pass;
    pass.pass = "FillDepthMipmap";
    pass.buffer = "depth pyramid";
    const Grid& grid = *input.grid;
    for (uint32_t view = 0; view < grid.views.size(); ++view) {
        const auto& levels = grid.pyramids[view].levels;
        for (uint32_t level = 1; level < levels.size(); ++level) {
            std::vector<DepthBounds> expected(levels[level].bounds.size());
            const DepthPyramid::Level& below = levels[level - 1];
            for (int y = 0; y < below.rows; ++y)
                for (int x = 0; x < below.columns; ++x) {
                    const DepthBounds& child = below.at(x, y);
                    expected[(size_t) (y / 2) * (size_t) levels[level].columns + (size_t) x / 2]
                        .include(child.near, child.far);
                }
            for (uint32_t cell = 0; cell < expected.size(); ++cell) {
                const DepthBounds& dumped = levels[level].bounds[cell];
                ++pass.compared;
                if (same(expected[cell], dumped)) {
                    ++pass.right;
                    continue;
                }
                ReplayPlace at;
                at.view = view;
                at.level = level;
                at.tile = cell;
                pass.fault("wrong", at, [&] {
                    return cellText(input, at) + ": " + boundsText(dumped) + ", not " +
                           boundsText(expected[cell]) + " as the level below has";
                });
            }
        }
    }
    return pass;
}

} // namespace dirt
