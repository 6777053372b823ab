// Pictures of rays show what the rays do.

#include "core/preview/ray_picture.h"

#include "core/preview/ray_colours.h"
#include "core/preview/ray_panels.h"
#include "tests/io/input_error.h"
#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dirt {
namespace {

using namespace test;

class RayPicture : public testing::Test {
protected:
    RayPicture() { build(64, 8); }

    void build(int viewSize, int tile, ViewMode mode = ViewMode::full) {
        Random random(7);
        geometry_.triangles.clear();
        addSoup(random, geometry_.triangles, 200);
        addRoom(random, geometry_.triangles);
        GridSettings settings;
        settings.viewSize = viewSize;
        settings.mode = mode;
        settings.width = 100; // of a single view, whose columns and rows differ
        settings.height = 60;
        settings.tile = tile;
        settings.bins = 4;
        grid_ = buildGrid(geometry_, Camera(), settings);
    }
    RayTrail trailOf(const Ray& ray) const { return closestTrail(grid_, geometry_, ray); }
    Ray randomRay() { return {uniformPoint(random_, 0.9), uniformPoint(random_, 1.0)}; }

    Random random_{3};
    FrameGeometry geometry_;
    Grid grid_;
};

/// In the middle between entering a tile and leaving it, a ray's image is in that tile; also where
/// the last tiles are cut.
TEST_F(RayPicture, HasTheImageInTheTilesThatAreVisited) {
    size_t checked = 0;
    for (const int viewSize : {64, 61, 0}) {
        build(viewSize, 8, viewSize == 0 ? ViewMode::single : ViewMode::full);
        for (int i = 0; i < 300; ++i) {
            const Ray ray = randomRay();
            for (const ViewTrail& trail : trailOf(ray).views)
                for (const TileTrail& tile : trail.tiles) {
                    if (!std::isfinite(tile.visit.end)) continue;
                    const double t = 0.5 * (tile.visit.begin + tile.visit.end);
                    const View& view = grid_.views[(size_t) tile.visit.view];
                    const auto at =
                        inTiles(view, glm::dvec3(ray.origin) + t * glm::dvec3(ray.direction));
                    ASSERT_TRUE(at.has_value());
                    // A visit that is short touches a border, to within rounding.
                    ASSERT_GE(at->x, tile.column - 1e-9);
                    ASSERT_LE(at->x, tile.column + 1 + 1e-9);
                    ASSERT_GE(at->y, tile.row - 1e-9);
                    ASSERT_LE(at->y, tile.row + 1 + 1e-9);
                    // The line that is drawn from there to there passes through it, too.
                    const auto image = imageOf(view, ray, t, tile.visit.end);
                    ASSERT_FALSE(image.empty());
                    EXPECT_NEAR(image.front().x, at->x, 1e-9);
                    EXPECT_NEAR(image.front().y, at->y, 1e-9);
                    ++checked;
                }
        }
    }
    EXPECT_GT(checked, 1000u);
}

TEST_F(RayPicture, OfARayFromTheEyeIsAPoint) {
    const View& view = grid_.views[0]; // +X: x is the world's y, y its z
    const auto image = imageOf(view, {{0, 0, 0}, {2, 1, 0}}, 0.0, INFINITY);
    ASSERT_EQ(image.size(), 1u);
    EXPECT_EQ(image[0], glm::dvec2(6.0, 4.0));
    EXPECT_TRUE(imageOf(view, {{0, 0, 0}, {-1, 0, 0}}, 0.0, INFINITY).empty());
}

/// Each tile has the colour of what became of it.
TEST_F(RayPicture, ColoursTheTiles) {
    size_t visited = 0, passed = 0, others = 0, hits = 0;
    for (int i = 0; i < 60; ++i) {
        const RayTrail trail = trailOf(randomRay());
        for (const ViewTrail& view : trail.views) {
            const View& seen = grid_.views[(size_t) view.span.view];
            ViewWindow window = windowOf(seen, view);
            ASSERT_EQ(window.columns, seen.columns);
            Picture picture(window.width(), window.height());
            drawTilesPanel(Canvas(picture), {grid_, geometry_, trail}, view, window);
            const auto hit = [&](int column, int row) {
                return trail.hit.found() && (int) trail.hit.view == view.span.view &&
                       (int) trail.hit.tile == row * seen.columns + column;
            };
            for (int row = 0; row < seen.rows; ++row)
                for (int column = 0; column < seen.columns; ++column) {
                    bool isVisited = false, isPassed = false;
                    for (const TileTrail& tile : view.tiles)
                        isVisited |= tile.column == column && tile.row == row;
                    for (const CellLook& cell : view.cells)
                        isPassed |= cell.passedOver && cell.column == column >> cell.level &&
                                    cell.row == row >> cell.level;
                    const Box box = window.cell(0, column, row);
                    size_t ofVisit = 0, ofPass = 0, ofHit = 0;
                    for (int y = box.top; y < box.bottom(); ++y)
                        for (int x = box.left; x < box.right(); ++x) {
                            const Colour colour = picture.at(x, y);
                            ofVisit += colour == kVisited;
                            ofPass += colour == kPassedOver;
                            ofHit += colour == kHitMark;
                        }
                    const size_t area = (size_t) (box.width * box.height);
                    EXPECT_EQ(ofVisit > area / 4, isVisited);
                    EXPECT_EQ(ofPass > area / 4, isPassed && !isVisited);
                    if (hit(column, row)) {
                        EXPECT_GT(ofHit, (size_t) (2 * box.width));
                    }
                    visited += isVisited;
                    passed += isPassed;
                    others += !isVisited && !isPassed;
                    hits += hit(column, row);
                }
        }
    }
    EXPECT_GT(visited, 100u);
    EXPECT_GT(passed, 100u);
    EXPECT_GT(others, 100u);
    EXPECT_GT(hits, 20u);
}

/// Of many tiles those are shown that the ray looks at.
TEST_F(RayPicture, ShowsAPartOfManyTiles) {
    build(512, 1);
    size_t parts = 0;
    for (int i = 0; i < 40; ++i) {
        const RayTrail trail = trailOf(randomRay());
        for (const ViewTrail& view : trail.views) {
            const ViewWindow window = windowOf(grid_.views[(size_t) view.span.view], view);
            parts += window.columns < 512;
            EXPECT_LE(window.width(), 1152);
            for (const TileTrail& tile : view.tiles) {
                EXPECT_GE(tile.column, window.column);
                EXPECT_LT(tile.column, window.column + window.columns);
                EXPECT_GE(tile.row, window.row);
                EXPECT_LT(tile.row, window.row + window.rows);
            }
        }
    }
    EXPECT_GT(parts, 10u);
}

size_t count(const Picture& picture, Colour colour) {
    size_t pixels = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) pixels += picture.at(x, y) == colour;
    return pixels;
}

/// The drawing in depth has the bars of the triangles that were tested, by what became of them.
TEST_F(RayPicture, DrawsTheTrianglesThatWereTested) {
    size_t withHit = 0, withMissed = 0, without = 0;
    for (int i = 0; i < 100; ++i) {
        const RayTrail trail = trailOf(randomRay());
        for (const ViewTrail& view : trail.views) {
            const int width = depthPanelWidth(view);
            ASSERT_EQ(width == 0, view.tiles.empty());
            if (width == 0) continue;
            Picture picture(width, 400);
            const DrawnRay ray{grid_, geometry_, trail};
            drawDepthPanel(Canvas(picture), ray, view, {0, 0, width, 400});
            bool missed = false, nearest = false, ends = false;
            for (const TileTrail& tile : view.tiles) {
                ends |= ray.hits() && tile.visit.begin <= ray.end() && ray.end() <= tile.visit.end;
                for (const BinTrail& bin : tile.bins)
                    for (const TriangleTrail& tested : bin.triangles) {
                        missed |= tested.result == Tested::missed;
                        nearest |= tested.result == Tested::nearest;
                    }
            }
            // Bars may hide each other where there are many.
            if (missed && !nearest) {
                EXPECT_GT(count(picture, kMissed), 0u);
            }
            if (!missed) {
                EXPECT_EQ(count(picture, kMissed), 0u);
            }
            if (!nearest && !ends) {
                EXPECT_EQ(count(picture, kHitMark), 0u);
            }
            if (ends) {
                EXPECT_GT(count(picture, kHitMark), 20u);
            }
            EXPECT_GT(count(picture, kVisitedRim), 0u);
            withHit += ends;
            withMissed += missed && !nearest;
            without += !nearest && !ends;
        }
    }
    EXPECT_GT(withHit, 20u);
    EXPECT_GT(withMissed, 20u);
    EXPECT_GT(without, 20u);
}

/// A ray from the eye touches all views there; only that in which it goes on is drawn.
TEST_F(RayPicture, LeavesOutViewsThatAreTouchedInTheEye) {
    const RayTrail trail = trailOf({{0, 0, 0}, {1.0f, 0.25f, 0.125f}});
    EXPECT_GT(trail.views.size(), 1u);
    const Picture picture = drawRay(grid_, geometry_, trail, "a");
    EXPECT_LT(picture.height, 2 * windowOf(grid_.views[0], trail.views[0]).height());
}

TEST_F(RayPicture, EndsWhereTheRayDoes) {
    const Ray ray = randomRay();
    RayTrail trail = trailOf(ray);
    ASSERT_TRUE(trail.hit.found());
    const DrawnRay drawn{grid_, geometry_, trail};
    EXPECT_TRUE(drawn.hits());
    EXPECT_EQ(drawn.end(), (double) trail.hit.t);
    const float beyond = 2.0f * trail.hit.t, before = 0.5f * trail.hit.t;
    const RayTrail blocked = anyTrail(grid_, geometry_, ray, beyond);
    EXPECT_LT((DrawnRay{grid_, geometry_, blocked}.end()), (double) beyond);
    const RayTrail open = anyTrail(grid_, geometry_, ray, before);
    EXPECT_FALSE((DrawnRay{grid_, geometry_, open}.hits()));
    EXPECT_EQ((DrawnRay{grid_, geometry_, open}.end()), (double) before);
}

/// All events below each other, or one; not more than fit.
TEST_F(RayPicture, StacksTheRaysOfAPath) {
    PathAccount account;
    account.geometry = geometry_;
    EXPECT_NE(inputError([&] { drawRays(account, "a", {}); }).find("no grid"), std::string::npos);
    account.grid = grid_;
    EXPECT_NE(inputError([&] { drawRays(account, "a", {}); }).find("no ray"), std::string::npos);
    for (int k = 0; k < 2; ++k) {
        EventAccount event;
        event.event = k;
        const Ray ray = randomRay();
        event.ray.origin = ray.origin;
        event.ray.direction = ray.direction;
        event.shadowRay = ShadowRay{randomRay(), 1.0f};
        account.events.push_back(event);
    }
    const Picture first = drawRays(account, "a", 0), second = drawRays(account, "a", 1),
                  all = drawRays(account, "a", {});
    EXPECT_EQ(all.height, first.height + second.height);
    EXPECT_EQ(all.width, std::max(first.width, second.width));
    for (int i = 0; i < 1000; ++i) account.events.push_back(account.events.front());
    EXPECT_NE(inputError([&] { drawRays(account, "a", {}); }).find("--event"), std::string::npos);
}

} // namespace
} // namespace dirt
