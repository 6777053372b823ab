// The numbers behind a preview are those of the buffers, and stand where their colours do.

#include "core/explain/explained_ray.h"
#include "core/explain/path_account.h"
#include "core/frame/renderer.h"
#include "core/path/camera_rays.h"
#include "core/preview/path_marks.h"
#include "core/preview/present.h"
#include "tests/preview/preview_fixture.h"

#include <cmath>

#include <gtest/gtest.h>

namespace dirt {
namespace {

class PreviewValues : public test::PreviewFixture {
protected:
    PreviewPicture draw(const std::string& name, const PreviewRequest& request = {}) {
        return PreviewFixture::draw(cpu_, name, request);
    }
};

TEST_F(PreviewValues, OfCellsAreTheGridsByView) {
    for (const int level : {0, 1}) {
        PreviewRequest request;
        request.level = level;
        const PreviewPicture near = draw("near", request);
        const Grid grid = cpu_.readGrid();
        ASSERT_EQ(near.values.size(), grid.views.size());
        for (size_t view = 0; view < grid.views.size(); ++view) {
            const PictureValues& part = near.values[view];
            EXPECT_EQ(part.view, (int) view);
            EXPECT_EQ(part.level, level);
            const auto& cells = grid.pyramids[view].levels[(size_t) level];
            ASSERT_EQ(part.numbers.size(), cells.bounds.size());
            ASSERT_EQ(part.columns(), cells.columns);
            for (size_t i = 0; i < part.numbers.size(); ++i)
                if (cells.bounds[i].empty())
                    EXPECT_TRUE(std::isnan(part.numbers[i]));
                else
                    EXPECT_EQ(part.numbers[i], (double) cells.bounds[i].near);
        }
    }
}

TEST_F(PreviewValues, OfPixelsAreTheBuffers) {
    PreviewRequest request;
    request.event = 0;
    const PreviewPicture normals = draw("normal", request), ids = draw("primitive", request);
    const PathAccount account = accountOf(loaded_.scene, settings_, cpu_, 12 * 48 + 20, 0);
    const SurfacePoint& point = account.events[0].point;
    ASSERT_TRUE(point.found());
    const size_t at = 12 * 48 + 20;
    for (size_t c = 0; c < 3; ++c)
        EXPECT_EQ(normals.values[0].numbers[3 * at + c], (double) point.shadingNormal[(int) c]);
    EXPECT_EQ(ids.values[0].numbers[at], (double) point.primitive);
    EXPECT_EQ(ids.values[0].textOf({20, 12}), std::to_string(point.primitive));
}

/// Whatever stands at a pixel of the picture has one value, in the overview too.
TEST_F(PreviewValues, StandWhereTheirColoursDo) {
    const PreviewPicture entries = draw("entries"), overview = draw("overview");
    const Image image = Renderer(loaded_.scene, settings_, cpu_).render().image;
    for (const PreviewPicture* picture : {&entries, &overview}) {
        const Picture shown = present(*picture);
        const std::vector<PictureValues> values = presentedValues(*picture);
        ASSERT_EQ(values.size(), picture == &entries ? 6u : 7u);
        for (const PictureValues& part : values) {
            ASSERT_EQ(part.numbers.size(), (size_t) (part.columns() * part.rows() * part.channels));
            EXPECT_FALSE(part.elementAt(part.pixels.left - 1, part.pixels.top));
            EXPECT_FALSE(part.elementAt(part.pixels.right(), part.pixels.top));
            const auto last = part.elementAt(part.pixels.right() - 1, part.pixels.bottom() - 1);
            ASSERT_TRUE(last);
            EXPECT_EQ(*last, glm::ivec2(part.columns() - 1, part.rows() - 1));
            if (part.view < 0) continue;
            // Black is nothing, and nothing is black.
            for (int y = 0; y < part.rows(); ++y)
                for (int x = 0; x < part.columns(); ++x) {
                    const int t = part.times;
                    const Colour colour =
                        shown.at(part.pixels.left + x * t + t / 2, part.pixels.top + y * t + t / 2);
                    const bool nothing = part.textOf({x, y}) == "nothing";
                    EXPECT_TRUE(nothing || colour != Colour(0)) << x << ", " << y;
                }
        }
    }
    const PictureValues pixels = presentedValues(overview).back();
    EXPECT_EQ(pixels.numbers[3 * (12 * 48 + 20)], (double) image.pixels[12 * 48 + 20].x);
}

TEST_F(PreviewValues, TextsTellFloatsApart) {
    PictureValues values{{0, 0, 3, 1}, 1, 1, {0.1f, 0.1, NAN}, "entries a tile"};
    EXPECT_EQ(values.textOf({0, 0}), "0.1 entries a tile");
    EXPECT_EQ(values.textOf({1, 0}), "0.1 entries a tile");
    EXPECT_EQ(values.textOf({2, 0}), "nothing");
    values.numbers = {1.0 / 3.0, std::nextafter(0.1f, 1.0f), 16777215.0};
    EXPECT_EQ(values.textOf({0, 0}), "0.3333333333333333 entries a tile");
    EXPECT_EQ(values.textOf({1, 0}), "0.10000001 entries a tile");
    EXPECT_EQ(values.textOf({2, 0}), "16777215 entries a tile");
}

/// The hits of a pixel's path stand where the camera sees them: the first in the pixel itself.
TEST_F(PreviewValues, PathsAreMarkedInTheImage) {
    for (const ViewMode mode : {ViewMode::full, ViewMode::single}) {
        settings_.grid.mode = mode;
        settings_.primary = Primary::traced;
        const PathAccount account = accountOf(loaded_.scene, settings_, cpu_, 12 * 48 + 20, 0);
        const CameraRays camera(loaded_.scene.camera, 48, 24, mode);
        PathRequest path{{20, 12}, 0, 0};
        const Marks first = marksInImage(account, path, camera);
        ASSERT_EQ(first.marks.size(), 3u); // the pixel, the line, its end
        EXPECT_EQ(first.marks[2].shape, Mark::Shape::cross);
        EXPECT_NEAR(first.marks[2].from.x, 20.5, 0.501);
        EXPECT_NEAR(first.marks[2].from.y, 12.5, 0.501);
        // Further rays begin where the one before has ended.
        path.event = 1;
        ASSERT_GT(account.events.size(), 1u);
        const Marks second = marksInImage(account, path, camera);
        ASSERT_GT(second.marks.size(), 1u);
        EXPECT_NEAR(second.marks[1].from.x, first.marks[2].from.x, 0.01);
        EXPECT_NEAR(second.marks[1].from.y, first.marks[2].from.y, 0.01);
        path = {{20, 12}};
        EXPECT_GT(marksInImage(account, path, camera).marks.size(), second.marks.size());
    }
}

/// A path's tiles are marked where the picture has those tiles, among other pictures too.
TEST_F(PreviewValues, MarksFollowTheirViews) {
    const PathAccount account = accountOf(loaded_.scene, settings_, cpu_, 12 * 48 + 20, 0);
    const std::vector<Mark> marks = marksOfPath(account, {{20, 12}}, 0).marks;
    for (const char* name : {"entries", "overview"}) {
        const std::vector<PictureValues> parts = presentedValues(draw(name));
        const std::vector<Mark> placed = placeMarks(marks, *account.grid, parts);
        ASSERT_EQ(placed.size(), marks.size());
        std::vector<std::array<int, 3>> due, found;
        for (const EventAccount& event : account.events)
            for (const ExplainedRay& ray : raysOf(account, event))
                for (const ViewTrail& view : ray.trail->views)
                    for (const TileTrail& tile : view.tiles)
                        due.push_back({view.span.view, tile.column, tile.row});
        for (const Mark& mark : placed) {
            if (mark.shape != Mark::Shape::box) continue;
            const auto x = (int) mark.from.x, y = (int) mark.from.y;
            for (const PictureValues& part : parts)
                if (const auto at = part.elementAt(x, y))
                    found.push_back({part.view, at->x, at->y});
        }
        EXPECT_GT(due.size(), 3u);
        EXPECT_EQ(found, due) << name;
    }
}

} // namespace
} // namespace dirt
