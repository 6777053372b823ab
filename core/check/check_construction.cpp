#include "core/check/check_construction.h"

#include "core/check/compare_structure.h"

namespace dirt {
namespace {

/// What depths may be off where arithmetic is not IEEE (G2).
constexpr int kUlps = 16;

/// A grid's depth bounds of the tiles, and of the levels above them if \p pyramid; all lists empty.
Grid withoutLists(const Grid& grid, bool pyramid) {
    Grid bounds;
    bounds.settings = grid.settings;
    bounds.views = grid.views;
    bounds.firstTile = grid.firstTile;
    bounds.pyramids = grid.pyramids;
    bounds.heads.resize(grid.heads.size(), 0); // a backend may prepare lists for tracing
    if (!pyramid)
        for (DepthPyramid& levels : bounds.pyramids) levels.levels.resize(1);
    return bounds;
}

/// Runs the passes of \p tested on the data of \p source.
class PassCheck {
public:
    PassCheck(const Camera& camera, Backend& tested, const std::string& source,
              const BuiltStructure& built, int ulps, std::vector<CheckRow>& rows)
        : camera_(camera), tested_(tested), source_(source), geometry_(built.geometry),
          grid_(*built.grid), ulps_(ulps), rows_(rows) {}

    void run() {
        fillDepth();
        fillDepthMipmap();
        fillPrimitives();
    }

private:
    CheckRow& row(const char* pass, const std::string& buffer) {
        CheckRow row;
        row.pass = pass;
        row.buffer = buffer;
        row.tested = tested_.name();
        row.source = source_;
        return rows_.emplace_back(std::move(row));
    }

    void fillDepth() {
        tested_.clear(camera_, grid_.settings);
        tested_.setGeometry(geometry_);
        tested_.fillDepth();
        compareLevel(grid_, tested_.readGrid(), 0, ulps_, row("FillDepth", "depth bounds"));
    }

    void fillDepthMipmap() {
        tested_.writeGrid(withoutLists(grid_, false));
        tested_.fillDepthMipmap();
        const Grid grid = tested_.readGrid();
        // Minima and maxima are inputs, whatever the arithmetic.
        for (size_t level = 1; level < grid_.pyramids[0].levels.size(); ++level)
            compareLevel(grid_, grid, level, 0,
                         row("FillDepthMipmap", "depth pyramid, level " + std::to_string(level)));
    }

    void fillPrimitives() {
        // A host backend keeps the fragments of FillDepth for this pass.
        tested_.clear(camera_, grid_.settings);
        tested_.fillDepth();
        tested_.writeGrid(withoutLists(grid_, true));
        tested_.fillPrimitives();
        const Grid grid = tested_.readGrid();
        compareLists(geometry_, grid_, grid, ulps_, row("FillPrimitives", "lists"));
        compareAtEye(grid_, grid, row("FillPrimitives", "triangles at the eye"));
    }

    const Camera& camera_;
    Backend& tested_;
    std::string source_;
    const FrameGeometry& geometry_;
    const Grid& grid_;
    int ulps_;
    std::vector<CheckRow>& rows_;
};

} // namespace

std::vector<CheckRow> checkConstruction(const BuiltStructure& a, const BuiltStructure& b,
                                        const Camera& camera, Backend& first, Backend& second) {
    const int ulps = first.isIeee() && second.isIeee() ? 0 : kUlps;
    std::vector<CheckRow> rows(1);
    rows[0].pass = "FillDepth";
    rows[0].buffer = "triangle buffer";
    rows[0].tested = second.name();
    rows[0].source = first.name();
    compareTriangles(a.geometry, b.geometry, rows[0]);
    if (!a.grid || !b.grid) return rows;
    PassCheck(camera, second, first.name(), a, ulps, rows).run();
    PassCheck(camera, first, second.name(), b, ulps, rows).run();
    return rows;
}

} // namespace dirt
