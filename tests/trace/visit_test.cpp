#include "core/trace/traverse.h"
#include "tests/support/border_rays.h"
#include "tests/support/exact_point.h"
#include "tests/support/grid_rays.h"
#include "tests/support/print.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <string>
#include <unordered_set>

// T1 and T2: every point of a ray lies in a visited cell, and cells are visited in the order of t.
// The grids here are not built from triangles: every cell of them is non-empty, and their depth
// bounds are arbitrary.

namespace dirt::test {
namespace {

/// Every list holds one id; bounds wide, narrow, of no length, or (some tiles) empty.
Grid madeGrid(Random& random, const ViewSet& set) {
    Grid grid = makeEmptyGrid(set.camera, set.settings);
    const double gaps = random.pick({0.0, 0.0, 0.3, 0.9});
    const int kind = random.below(4);
    for (DepthPyramid& pyramid : grid.pyramids) {
        for (DepthBounds& bounds : pyramid.levels[0].bounds) {
            if (random.chance(gaps)) continue;
            const float a = (float) std::pow(10.0, random.uniform(-6, 0.3));
            const float b = (float) std::pow(10.0, random.uniform(-6, 0.3));
            switch (kind) {
            case 0:
                bounds = {0.0f, 4.0f};
                break;
            case 1:
                bounds = {1e-7f, 4.0f};
                break;
            case 2:
                bounds = {std::min(a, b), std::max(a, b)};
                break;
            default:
                bounds = {0.25f * a, random.chance(0.1) ? 0.25f * a : 0.25f * a + b};
            }
        }
        buildPyramid(pyramid);
    }
    const size_t cells = (size_t) grid.firstTile.back() * set.settings.bins;
    grid.ids.assign(cells, 0);
    grid.heads.resize(cells + 1);
    std::iota(grid.heads.begin(), grid.heads.end(), 0u);
    return grid;
}

struct Visited {
    int view, tile, bin;
};

struct VisitTest {
    const ViewSet& set;
    const Grid& grid;
    Random& random;

    /// Empty, or why the point at \p t is lost: all tiles around it might hold a primitive there,
    /// and none is visited with the bin of its depth.
    std::string lost(const ExactRay& ray, const ExactRay::Parameter& t,
                     const std::unordered_set<size_t>& cells) const {
        const IntegerVector p = ray.at(t);
        bool possible = true, any = false, seen = false;
        std::string where;
        for (size_t v = 0; v < set.views.size(); ++v) {
            const View& view = set.views[v];
            const IntegerVector q = ExactRay::toView(view, p);
            tilesAround(view, set.tileSize(view), q, 1.0 / 512, [&](int tile) {
                any = true;
                const Fraction depth{q.z, t.denominator, ray.unit};
                const DepthBounds& bounds = grid.bounds((int) v, tile);
                possible = possible && !bounds.empty() && compare(bounds.near, depth) <= 0 &&
                           compare(bounds.far, depth) >= 0;
                if (!possible || seen) return;
                // A primitive at this depth is listed in the bins of both floats around it.
                const BinMap bin(bounds, set.settings.bins);
                for (float w : {floatBelow(depth), floatAbove(depth)})
                    seen = seen || cells.contains(grid.cell((int) v, tile, bin(w)));
                where += " (view " + std::to_string(v) + " tile " + std::to_string(tile) + " w " +
                         hex(depth.value()) + ")";
            });
        }
        return any && possible && !seen ? "lost at" + where : "";
    }

    /// A few parameters at which to look: borders, beside borders, and anywhere.
    ExactRay::Parameter pickParameter(const ExactRay& ray, const std::vector<Visited>& visited) {
        ExactRay::Parameter t;
        const int choice = random.below(4);
        if (choice < 3) {
            int v = random.below((int) set.views.size()), axis = random.below(2), border;
            if (!visited.empty() && random.chance(0.8)) {
                const Visited& cell = visited[random.below((int) visited.size())];
                v = cell.view;
                const int columns = set.views[v].columns;
                border = (axis ? cell.tile / columns : cell.tile % columns) + random.below(2);
            } else
                border = random.below((int) (axis ? set.views[v].t : set.views[v].s).size());
            const View& view = set.views[v];
            if (ray.crossing(view, axis, axis ? view.t[border] : view.s[border], t)) {
                if (choice == 2) { // beside it, by a relative 2^-12 to 2^-60
                    const int shift = random.range(12, 60);
                    t.numerator =
                        (t.numerator << shift) + (random.chance(0.5) ? t.numerator : -t.numerator);
                    t.denominator <<= shift;
                }
                return t;
            }
        }
        return ray.parameter(random.chance(0.1) ? 0.0 : std::pow(10.0, random.uniform(-8, 1)));
    }
};

/// Settings of every kind, small enough that each cell can be filled.
std::vector<ViewSet> smallViews(Random& random) {
    std::vector<ViewSet> sets;
    for (int size : {1, 2, 3, 5, 8, 16, 33, 64}) sets.push_back(fullViews(size, 1));
    sets.push_back(fullViews(64, 16));
    sets.push_back(fullViews(51, 16));
    sets.push_back(fullViews(512, 16));
    sets.push_back(fullViews(517, 64));
    for (float fov : {1.0f, 45.0f, 120.0f, 170.0f}) {
        sets.push_back(singleView(1023, 517, 32, fov));
        sets.push_back(singleView(random.range(1, 60), random.range(1, 60), 1, fov));
    }
    sets.push_back(singleView(1, 1, 1, 53.0f));
    sets.push_back(singleView(4096, 3, 1, 100.0f));
    for (ViewSet& set : sets) {
        set.settings.bins = random.pick({1, 2, 3, 16, 44, 256});
        if (set.views[0].tiles() > 4000) set.settings.bins = random.pick({1, 5, 16});
        if (random.chance(0.25)) set.settings.traversal = Traversal::linear;
        set.settings.maxMip = random.range(-1, 7);
    }
    return sets;
}

std::string visitText(const ViewSet& set, const Grid& grid, const GridRay& r) {
    return test::describe(set) + " bins " + std::to_string(set.settings.bins) + " maxMip " +
           std::to_string(set.settings.maxMip) +
           (set.settings.traversal == Traversal::linear ? " linear" : " hierarchical") +
           " bounds " + hex(grid.bounds(0, 0).near) + " " + hex(grid.bounds(0, 0).far) + "\n" +
           hex(r.ray) + " (" + r.kind + ")";
}

/// Whether T1 speaks of this point (times any factor). A single view, of rays that start inside it,
/// until they leave it.
bool concerns(const ViewSet& set, const IntegerVector& p) {
    if (set.settings.mode == ViewMode::full) return true;
    bool inside = false;
    tilesAround(set.views[0], set.tileSize(set.views[0]), p, 0.0, [&](int) { inside = true; });
    return inside;
}

TEST(Visit, EveryPointOfTheRayIsInAVisitedCell) {
    Random random(1);
    std::map<std::string, int> failures;
    long points = 0, visits = 0;
    for (int round = 0; round < cases(3, 30); ++round)
        for (const ViewSet& set : smallViews(random)) {
            const Grid grid = madeGrid(random, set);
            GridRays rays(random, set);
            VisitTest test{set, grid, random};
            for (int i = 0; i < cases(60, 300); ++i) {
                const GridRay r = rays.next();
                const ExactRay exact(r.ray);
                std::vector<Visited> visited;
                std::unordered_set<size_t> cells;
                visitCells(grid, r.ray, [&](int view, int tile, int bin) {
                    visited.push_back({view, tile, bin});
                    cells.insert(grid.cell(view, tile, bin));
                });
                visits += (long) visited.size();
                if (!concerns(set, exact.origin)) continue;
                for (int k = 0; k < 24; ++k) {
                    const ExactRay::Parameter t = test.pickParameter(exact, visited);
                    if (!concerns(set, exact.at(t))) continue;
                    const std::string wrong = test.lost(exact, t, cells);
                    ++points;
                    if (!wrong.empty() && ++failures[r.kind] <= 2)
                        ADD_FAILURE() << wrong << " t "
                                      << hex(Fraction{t.numerator, t.denominator,
                                                      exact.unit - exact.directionUnit}
                                                 .value())
                                      << "\n"
                                      << visitText(set, grid, r);
                }
            }
        }
    for (const auto& [kind, count] : failures)
        ADD_FAILURE() << count << " points lost, rays " << kind;
    EXPECT_GT(points, 10'000);
    EXPECT_GT(visits, points);
}

TEST(Visit, RaysAlongABorderAreFollowedUntilTheyCrossIt) {
    Random random(4);
    int points = 0;
    for (int i = 0; i < cases(200, 2000); ++i) {
        ViewSet set = fullViews(random.pick({37, 64, 100, 256}), 1);
        set.settings.bins = random.pick({1, 16});
        set.settings.traversal = random.chance(0.3) ? Traversal::linear : Traversal::hierarchical;
        const Grid grid = madeGrid(random, set);
        const VisitTest test{set, grid, random};
        const int v = random.below(6);
        const View& view = set.views[(size_t) v];
        const float side = random.chance(0.5) ? 1.0f : -1.0f;
        const float slope = (float) random.sign() * random.pick({1.0f, 1.0f, 0.5f, 0.25f});
        const Ray r = rayAlong(view, slope, random.chance(0.5), random.range(-24, -19),
                               (float) random.range(-3, 3) * 0.25f, side);
        const ExactRay exact(r);
        std::unordered_set<size_t> cells;
        visitCells(grid, r,
                   [&](int view, int tile, int bin) { cells.insert(grid.cell(view, tile, bin)); });
        for (int k = 0; k < 64; ++k) {
            // Up to the crossing at t = 1, in steps of a fraction of the view.
            const double before = std::pow(2.0, random.uniform(-30, -17));
            const std::string wrong = test.lost(exact, exact.parameter(1.0 - before), cells);
            ASSERT_EQ(wrong, "") << visitText(set, grid, {r, "along a border"}) << " t 1 - "
                                 << before;
            ++points;
        }
    }
    EXPECT_GT(points, 1000);
}

/// Of the cells whose interior the ray passes; where it only touches one, or runs along a border
/// between views, any order will do. A hit is final at err(t) before the end of what was visited,
/// so two cells may change places where their parameters differ by less than that.
TEST(Visit, CellsComeInTheOrderOfT) {
    Random random(2);
    std::map<std::string, int> failures;
    for (int round = 0; round < cases(3, 30); ++round)
        for (const ViewSet& set : smallViews(random)) {
            const Grid grid = madeGrid(random, set);
            GridRays rays(random, set);
            for (int i = 0; i < cases(40, 300); ++i) {
                const GridRay r = rays.next();
                const ExactRay exact(r.ray);
                double latest = 0.0;
                Visited last{-1, -1, -1};
                std::string wrong;
                visitCells(grid, r.ray, [&](int v, int tile, int bin) {
                    const View& view = set.views[v];
                    const float dw = view.signW * r.ray.direction[view.axisW];
                    if (last.view == v && last.tile == tile) {
                        if (dw >= 0 ? bin <= last.bin : bin >= last.bin)
                            wrong = "bins out of order";
                    } else {
                        const ParameterSpan span =
                            spanInside(exact, view,
                                       ExactCone(view, tile % view.columns, tile / view.columns,
                                                 set.tileSize(view), 0.0));
                        if (!span.empty()) {
                            if (span.to < latest * (1.0 - 0x1p-23))
                                wrong = "tile " + std::to_string(tile) + " of view " +
                                        std::to_string(v) + " ends at " + hex(span.to) +
                                        ", after one that begins at " + hex(latest);
                            latest = std::max(latest, span.from);
                        }
                    }
                    last = {v, tile, bin};
                });
                if (!wrong.empty() && ++failures[r.kind] <= 2)
                    ADD_FAILURE() << wrong << "\n" << visitText(set, grid, r);
            }
        }
    for (const auto& [kind, count] : failures)
        ADD_FAILURE() << count << " rays out of order: " << kind;
}

TEST(Visit, NothingForRaysThatAreNone) {
    Random random(3);
    const ViewSet set = fullViews(16, 1);
    const Grid grid = madeGrid(random, set);
    const float nan = std::nanf(""), inf = INFINITY;
    for (float bad : {nan, inf, -inf})
        for (int i = 0; i < 6; ++i) {
            Ray ray{{0.1f, 0.2f, 0.3f}, {1, 1, 1}};
            (i < 3 ? ray.origin : ray.direction)[i % 3] = bad;
            visitCells(grid, ray, [](int, int, int) { ADD_FAILURE() << "a cell is visited"; });
        }
    visitCells(grid, {{0, 0, 0}, {0, 0, 0}},
               [](int, int, int) { ADD_FAILURE() << "a cell is visited"; });
}

} // namespace
} // namespace dirt::test
