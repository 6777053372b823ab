// Pictures of tiles show the polygons and depths of what they list.

#include "core/preview/tile_picture.h"

#include "core/preview/paint.h"
#include "core/preview/ray_colours.h"
#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

namespace dirt {
namespace {

using namespace test;

constexpr int kSide = 576, kLeft = 16, kTop = 46, kRight = kLeft + kSide + 126;

/// Pixels of a colour in a square of the drawings' size.
size_t count(const Picture& picture, Colour colour, int left) {
    size_t pixels = 0;
    for (int y = kTop; y < kTop + kSide; ++y)
        for (int x = left; x < left + kSide; ++x) pixels += picture.at(x, y) == colour;
    return pixels;
}

TEST(TilePicture, ShowsWhatItLists) {
    FrameGeometry geometry;
    Random random(11);
    addSoup(random, geometry.triangles, 300);
    GridSettings settings;
    settings.viewSize = 64;
    settings.bins = 4;
    Grid grid = buildGrid(geometry, Camera(), settings);
    size_t drawn = 0, spoilt = 0;
    for (int view = 0; view < 6; ++view) {
        const std::vector<TileEntry> entries = entriesOfTile(grid, geometry, view, 1, 2);
        const Picture picture = drawEntries(grid, entries, view, 1, 2, "a");
        EXPECT_EQ(count(picture, kHitMark, kLeft) + count(picture, kHitMark, kRight), 0u);
        for (const TileEntry& entry : entries) {
            EXPECT_GT(count(picture, idColour(entry.id), kRight), 0u);
            drawn += count(picture, idColour(entry.id), kLeft) > 0; // others may hide it
        }
        if (entries.size() < 2) continue;
        // One that is in no list is red.
        std::vector<TileEntry> wrong = entries;
        wrong[0].bins.clear();
        EXPECT_GT(count(drawEntries(grid, wrong, view, 1, 2, "a"), kHitMark, kRight), 0u);
        ++spoilt;
    }
    EXPECT_GT(drawn, 10u);
    EXPECT_GT(spoilt, 2u);
}

/// A triangle across a tile's middle from corner to corner, at depths from 1 to 2.
TEST(TilePicture, DrawsThemWhereTheyAre) {
    FrameGeometry geometry; // before view 4, +Z, whose x and y are the frame's
    geometry.triangles.push_back({{-1.5f, -1.5f, 1.0f}, {3.0f, 3.0f, 2.0f}, {-3.0f, 3.0f, 2.0f}});
    GridSettings settings;
    settings.viewSize = 16;
    settings.bins = 4;
    const Grid grid = buildGrid(geometry, Camera(), settings);
    ASSERT_EQ(grid.views[4].columns, 1);
    const auto entries = entriesOfTile(grid, geometry, 4, 0, 0);
    ASSERT_EQ(entries.size(), 1u);
    const Picture picture = drawEntries(grid, entries, 4, 0, 0, "a");
    const Colour colour = idColour(0);
    // The edge from the upper left corner to the lower right one passes the middle.
    EXPECT_EQ(picture.at(kLeft + 288, kTop + 288), colour);
    EXPECT_EQ(picture.at(kLeft + 160, kTop + 160), colour);
    EXPECT_EQ(picture.at(kLeft + 288, kTop + 160), kEmptyTile);
    EXPECT_EQ(picture.at(kLeft + 160, kTop + 288), kEmptyTile);
    // Its depths are those of the tile.
    EXPECT_EQ(picture.at(kRight + 4, kTop + 4), colour);
    EXPECT_EQ(picture.at(kRight + 4, kTop + kSide - 4), colour);
    EXPECT_EQ(picture.at(kRight + 100, kTop + 100), kEmptyTile);
}

} // namespace
} // namespace dirt
