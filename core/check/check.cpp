#include "core/check/check.h"

#include "core/check/compare.h"

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

/// A whole construction, as one backend has made it of its own triangle buffer.
struct Built {
    FrameGeometry geometry;
    Grid grid;
};

Built build(Backend& backend, const Mesh& mesh, const Camera& camera,
            const GridSettings& settings) {
    backend.build(mesh, camera, settings);
    return {backend.readGeometry(), backend.readGrid()};
}

/// Runs the passes of \p tested on the data of \p source.
class PassCheck {
public:
    PassCheck(const Camera& camera, Backend& tested, const std::string& source, const Built& built,
              int ulps, std::vector<CheckRow>& rows)
        : camera_(camera), tested_(tested), source_(source), built_(built), ulps_(ulps),
          rows_(rows) {}

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
        tested_.clear(camera_, built_.grid.settings);
        tested_.setGeometry(built_.geometry);
        tested_.fillDepth();
        compareLevel(built_.grid, tested_.readGrid(), 0, ulps_, row("FillDepth", "depth bounds"));
    }

    void fillDepthMipmap() {
        tested_.writeGrid(withoutLists(built_.grid, false));
        tested_.fillDepthMipmap();
        const Grid grid = tested_.readGrid();
        // Minima and maxima are inputs, whatever the arithmetic.
        for (size_t level = 1; level < built_.grid.pyramids[0].levels.size(); ++level)
            compareLevel(built_.grid, grid, level, 0,
                         row("FillDepthMipmap", "depth pyramid, level " + std::to_string(level)));
    }

    void fillPrimitives() {
        // A host backend keeps the fragments of FillDepth for this pass.
        tested_.clear(camera_, built_.grid.settings);
        tested_.fillDepth();
        tested_.writeGrid(withoutLists(built_.grid, true));
        tested_.fillPrimitives();
        const Grid grid = tested_.readGrid();
        compareLists(built_.geometry, built_.grid, grid, ulps_, row("FillPrimitives", "lists"));
        compareAtEye(built_.grid, grid, row("FillPrimitives", "triangles at the eye"));
    }

    const Camera& camera_;
    Backend& tested_;
    std::string source_;
    const Built& built_;
    int ulps_;
    std::vector<CheckRow>& rows_;
};

} // namespace

std::vector<CheckRow> checkConstruction(const Mesh& mesh, const Camera& camera,
                                        const GridSettings& settings, Backend& first,
                                        Backend& second) {
    const Built a = build(first, mesh, camera, settings);
    const Built b = build(second, mesh, camera, settings);
    const int ulps = first.isIeee() && second.isIeee() ? 0 : kUlps;
    std::vector<CheckRow> rows(1);
    rows[0].pass = "FillDepth";
    rows[0].buffer = "triangle buffer";
    rows[0].tested = second.name();
    rows[0].source = first.name();
    compareTriangles(a.geometry, b.geometry, rows[0]);
    PassCheck(camera, second, first.name(), a, ulps, rows).run();
    PassCheck(camera, first, second.name(), b, ulps, rows).run();
    return rows;
}

} // namespace dirt
