// What stands below the cursor, wherever the picture does.

#include "app/viewer/inspect.h"

#include "app/viewer/placement.h"

#include <gtest/gtest.h>

namespace dirt {
namespace {

constexpr glm::dvec2 kPicture{200, 100}, kRoom{800, 600};

void expectAt(glm::dvec2 found, glm::dvec2 due) {
    EXPECT_NEAR(found.x, due.x, 1e-9);
    EXPECT_NEAR(found.y, due.y, 1e-9);
}

TEST(Placement, FillsTheWindowWithoutAnotherShape) {
    const Placement all = place(kPicture, kRoom, {});
    EXPECT_EQ(all.scale, 4.0);
    expectAt(all.corner, {0, 100});
    expectAt(all.toPicture({0, 100}), {0, 0});
    expectAt(all.toPicture({800, 500}), kPicture);
}

TEST(Placement, ZoomsAroundTheCursor) {
    Zoom zoom;
    const glm::dvec2 cursor(300, 250);
    const glm::dvec2 before = place(kPicture, kRoom, zoom).toPicture(cursor);
    for (int i = 0; i < 10; ++i) {
        zoomAt(zoom, 1.25, cursor, kPicture, kRoom);
        expectAt(place(kPicture, kRoom, zoom).toPicture(cursor), before);
    }
    EXPECT_NEAR(place(kPicture, kRoom, zoom).scale, 4.0 * std::pow(1.25, 10), 1e-6);
    // Out again no further than all of it, and in no further than can be seen.
    for (int i = 0; i < 20; ++i) zoomAt(zoom, 0.8, cursor, kPicture, kRoom);
    EXPECT_EQ(zoom.times, 1.0);
    expectAt(zoom.centre, {0.5, 0.5});
    for (int i = 0; i < 100; ++i) zoomAt(zoom, 1.25, cursor, kPicture, kRoom);
    EXPECT_LE(zoom.times, 4096.0);
}

TEST(Placement, MovesWithTheMouseUpToTheRim) {
    Zoom zoom;
    zoomAt(zoom, 4.0, {400, 300}, kPicture, kRoom);
    const glm::dvec2 before = place(kPicture, kRoom, zoom).toPicture({400, 300});
    moveZoom(zoom, {40, -16}, kPicture, kRoom);
    expectAt(place(kPicture, kRoom, zoom).toPicture({440, 284}), before);
    moveZoom(zoom, {1e6, 0}, kPicture, kRoom);
    EXPECT_EQ(place(kPicture, kRoom, zoom).corner.x, 0.0);
}

ViewPicture pictureOfCells() {
    ViewPicture shown;
    shown.picture = Picture(40, 10);
    for (int view : {0, 1}) {
        PictureValues part{{20 * view, 0, 20, 10}, 5, 1, {}, "entries a tile", view, 0};
        for (int i = 0; i < 8; ++i) part.numbers.push_back(10 * view + i);
        shown.values.push_back(part);
    }
    return shown;
}

TEST(Inspect, TellsTilesAndTheirValues) {
    ViewPicture shown = pictureOfCells();
    const Inspection there = inspect(shown, 20 + 2 * 5, 9);
    EXPECT_EQ(there.text, "view 1, tile (2, 1): 16 entries a tile");
    EXPECT_EQ(there.tile, (std::array{1, 2, 1}));
    EXPECT_FALSE(there.place);
    EXPECT_EQ(inspect(shown, 40, 3).text, "");
    EXPECT_EQ(inspect(shown, -1, 3).text, "");
    shown.values[1].level = 2; // cells, which list nothing
    const Inspection cell = inspect(shown, 20, 0);
    EXPECT_EQ(cell.text, "view 1, cell (0, 0) of level 2: 10 entries a tile");
    EXPECT_FALSE(cell.tile);
}

TEST(Inspect, TellsPixelsWhateverTheirPictureIsOf) {
    ViewPicture shown;
    shown.picture = Picture(2, 1);
    shown.width = 2, shown.height = 1;
    shown.image = {2, 1, {{0, 0, 0}, {0.1f, 2, 1e-30f}}};
    const Inspection pixel = inspect(shown, 1, 0);
    EXPECT_EQ(pixel.text, "pixel (1, 0): 0.1, 2, 1e-30");
    EXPECT_EQ(*pixel.place, glm::dvec2(0.75, 0.5));
    shown.image = {};
    shown.picture = Picture(8, 4); // enlarged
    shown.values = {{{0, 0, 8, 4}, 4, 1, {7, 8}, ""}};
    EXPECT_EQ(inspect(shown, 7, 3).text, "pixel (1, 0): 8");
    EXPECT_EQ(*inspect(shown, 0, 0).place, glm::dvec2(0.25, 0.5));
}

} // namespace
} // namespace dirt
