// Pictures of buffers show what the buffers hold, the same for every backend.

#include "core/preview/preview.h"

#include "core/explain/explained_ray.h"
#include "core/frame/renderer.h"
#include "core/path/tone_mapping.h"
#include "core/preview/paint.h"
#include "core/preview/present.h"
#include "tests/io/input_error.h"
#include "tests/preview/preview_fixture.h"

#ifdef DIRT_HAVE_EMBREE
#include "backend_embree/embree_backend.h"
#endif

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace dirt {
namespace {

using Of = PreviewKind::Of;

class Preview : public test::PreviewFixture {
protected:
    Preview() { settings_.primary = Primary::traced; }
};

size_t coloursIn(const PreviewPicture& picture) {
    std::set<std::array<uint8_t, 3>> colours;
    for (size_t i = 0; i + 2 < picture.rgb.size(); i += 3)
        colours.insert({picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]});
    return colours.size();
}

TEST_F(Preview, DrawsEveryKind) {
    for (const PreviewKind& kind : previewKinds()) {
        SCOPED_TRACE(kind.name);
        const std::string name = kind.name;
        settings_.visibility =
            name == "shadowmap" ? LightVisibility::shadowMap : LightVisibility::traced;
        PreviewRequest request;
        // From the eye all rays have one tile.
        request.event = kind.of == Of::event || kind.of == Of::point ? 1 : 0;
        const PreviewPicture picture = draw(cpu_, name, request);
        ASSERT_EQ(picture.rgb.size(), 3 * (size_t) picture.width * (size_t) picture.height);
        EXPECT_FALSE(picture.scale.empty());
        // Nothing shines in this scene, and all of its surfaces reflect.
        EXPECT_GE(coloursIn(picture), name == "emission" || name == "mask" ? 1u : 2u);
        if (kind.of == Of::event || kind.of == Of::point) {
            EXPECT_EQ(picture.width, 48);
        }
    }
}

TEST_F(Preview, TheImageIsThatOfRender) {
    const Image image = Renderer(loaded_.scene, settings_, cpu_).render().image;
    EXPECT_EQ(draw(cpu_, "image").rgb,
              DisplayEncoding(loaded_.scene.toneMapping).bytes(image.pixels));
}

/// The scale's end is the fullest tile, which has the brightest colour; empty ones are black.
TEST_F(Preview, CountsEntries) {
    const PreviewPicture picture = draw(cpu_, "entries");
    const Grid grid = cpu_.readGrid();
    size_t most = 0, emptyTiles = 0;
    int fullest = 0;
    for (int tile = 0; tile < grid.views[0].tiles(); ++tile) {
        size_t entries = 0;
        for (int bin = 0; bin < grid.settings.bins; ++bin)
            entries += grid.list(0, tile, bin).size();
        emptyTiles += entries == 0;
        if (entries > most) {
            most = entries;
            fullest = tile;
        }
    }
    ASSERT_EQ(grid.views.size(), 6u);
    EXPECT_EQ(picture.width, 3 * grid.views[0].columns);
    EXPECT_EQ(picture.height, 2 * grid.views[0].rows);
    const int column = fullest % grid.views[0].columns, row = fullest / grid.views[0].columns;
    const auto sum = [&](int x, int y) {
        const size_t at = 3 * (size_t) (y * picture.width + x);
        return picture.rgb[at] + picture.rgb[at + 1] + picture.rgb[at + 2];
    };
    size_t black = 0;
    int brightest = 0;
    for (int y = 0; y < grid.views[0].rows; ++y)
        for (int x = 0; x < grid.views[0].columns; ++x) {
            black += sum(x, y) == 0;
            brightest = std::max(brightest, sum(x, y));
        }
    EXPECT_EQ(black, emptyTiles);
    EXPECT_EQ(sum(column, row), brightest);
}

/// The three points of an event are the next ones of this event and the two before it.
TEST_F(Preview, DrawsAllThreePoints) {
    settings_.bounces = 3;
    for (const char* name : {"primitive", "barycentrics", "position", "normal", "geometric-normal",
                             "diffuse", "emission", "roughness", "reflectance", "metallic"}) {
        SCOPED_TRACE(name);
        const auto at = [&](int event, PointChoice point) {
            PreviewRequest request;
            request.event = event;
            request.point = point;
            return draw(cpu_, name, request).rgb;
        };
        EXPECT_EQ(at(2, PointChoice::previous), at(0, PointChoice::next));
        EXPECT_EQ(at(2, PointChoice::current), at(1, PointChoice::next));
        if (std::string(name) == "position") {
            EXPECT_NE(at(0, PointChoice::next), at(1, PointChoice::next));
        }
    }
    settings_.bounces = 1;
    PreviewRequest request;
    request.point = PointChoice::current; // kept for whoever asks
    EXPECT_EQ(draw(cpu_, "diffuse", request).scale, "0 to 1");
}

/// Barycentric weights lie where the surface point does.
TEST_F(Preview, DrawsBarycentrics) {
    const PreviewPicture picture = draw(cpu_, "barycentrics");
    const PreviewPicture ids = draw(cpu_, "primitive");
    size_t points = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const Colour weights = picture.at(x, y);
            const int sum = weights.x + weights.y + weights.z;
            if (ids.at(x, y) == Colour(0, 0, 0)) {
                EXPECT_EQ(sum, 0);
            } else {
                EXPECT_NEAR(sum, 255, 2); // each is rounded
                ++points;
            }
        }
    EXPECT_GT(points, 100u);
}

TEST_F(Preview, DrawsTimes) {
    const PreviewPicture picture = draw(cpu_, "time");
    ASSERT_TRUE(picture.colours.has_value());
    EXPECT_EQ(picture.colours->low, 0.0);
    EXPECT_GT(picture.colours->high, 0.0);
    EXPECT_EQ(picture.colours->unit, "nanoseconds a ray");
}

/// The marks of a path are the tiles that the definition visits, in the picture of all views.
TEST_F(Preview, MarksTheTilesOfAPath) {
    PreviewRequest request;
    request.path = PathRequest{{20, 12}, {}};
    request.sample = 1;
    const PreviewPicture all = draw(cpu_, "entries", request);
    const PathAccount account =
        accountOf(loaded_.scene, settings_, cpu_, 12 * 48 + 20, request.sample);
    std::vector<std::array<int, 2>> due, marked;
    const int columns = account.grid->views[0].columns, rows = account.grid->views[0].rows;
    for (const EventAccount& event : account.events)
        for (const ExplainedRay& ray : raysOf(account, event))
            for (const ViewTrail& view : ray.trail->views)
                for (const TileTrail& tile : view.tiles)
                    due.push_back({view.span.view % 3 * columns + tile.column,
                                   view.span.view / 3 * rows + tile.row});
    for (const Mark& mark : all.marks.marks)
        if (mark.shape == Mark::Shape::box)
            marked.push_back({(int) mark.from.x, (int) mark.from.y});
    EXPECT_GT(due.size(), 3u);
    EXPECT_EQ(marked, due);
    EXPECT_EQ(all.rgb, draw(cpu_, "entries").rgb);
    // One event has fewer; cells of a level are larger.
    request.path->event = 1;
    const PreviewPicture one = draw(cpu_, "entries", request);
    EXPECT_LT(one.marks.marks.size(), all.marks.marks.size());
    EXPECT_GT(one.marks.marks.size(), 0u);
    request.level = 1;
    const PreviewPicture coarse = draw(cpu_, "near", request);
    ASSERT_EQ(coarse.marks.marks.size(), one.marks.marks.size());
    for (size_t i = 0; i < coarse.marks.marks.size(); ++i) {
        const Mark &fine = one.marks.marks[i], &mark = coarse.marks.marks[i];
        if (fine.shape != Mark::Shape::box) continue;
        EXPECT_EQ((int) fine.from.x % columns / 2, (int) mark.from.x % ((columns + 1) / 2));
        EXPECT_EQ((int) fine.from.y % rows / 2, (int) mark.from.y % ((rows + 1) / 2));
    }
}

TEST_F(Preview, MarksThePixel) {
    PreviewRequest request;
    request.path = PathRequest{{20, 12}, {}};
    for (const char* name : {"image", "hits", "normal"}) {
        const PreviewPicture picture = draw(cpu_, name, request);
        ASSERT_EQ(picture.marks.marks.size(), 1u) << name;
        EXPECT_EQ(picture.marks.marks[0].from, glm::dvec2(20, 12));
        EXPECT_EQ(picture.rgb, draw(cpu_, name).rgb);
    }
}

/// Whether a picture stands in another, each of its pixels \p times as large.
bool stands(const Picture& part, const Picture& whole, int left, int top, int times) {
    for (int y = 0; y < part.height * times; ++y)
        for (int x = 0; x < part.width * times; ++x)
            if (!whole.holds(left + x, top + y) ||
                whole.at(left + x, top + y) != part.at(x / times, y / times))
                return false;
    return true;
}

TEST_F(Preview, ShowsTheViewsAroundTheImage) {
    settings_.grid.mode = ViewMode::single; // without the frame of what the image shows
    const PreviewPicture whole = draw(cpu_, "overview");
    const PreviewPicture image = draw(cpu_, "image"), entries = draw(cpu_, "entries");
    EXPECT_TRUE(whole.bare);
    EXPECT_EQ(whole.scale, entries.scale);
    const int times = 768 / image.width, cells = 768 / entries.width;
    EXPECT_TRUE(stands(entries, whole, 12, 12 + 22, cells));
    EXPECT_TRUE(stands(image, whole, 12, 12 + 22 + entries.height * cells + 12, times));
    // In full mode three views are above it and three below.
    settings_.grid.mode = ViewMode::full;
    const PreviewPicture full = draw(cpu_, "overview");
    const PreviewPicture fullImage = draw(cpu_, "image");
    bool found = false;
    for (int top = 0; top < full.height && !found; ++top)
        for (int left = 0; left < 100 && !found; ++left)
            found = stands(fullImage, full, left, top, times);
    EXPECT_TRUE(found);
}

/// Small pictures are enlarged; below is a bar from the least to the largest number.
TEST_F(Preview, IsPresentedWithItsScale) {
    const PreviewPicture entries = draw(cpu_, "entries");
    const Picture shown = present(entries);
    const int times = (768 + entries.width - 1) / entries.width;
    ASSERT_GE(shown.width, entries.width * times);
    // Each tile has its colour, but for the lines between the views and their names.
    size_t same = 0;
    for (int y = 0; y < entries.height * times; ++y)
        for (int x = 0; x < entries.width * times; ++x)
            same += shown.at(x, y) == entries.at(x / times, y / times);
    const size_t all = (size_t) (entries.width * times) * (size_t) (entries.height * times);
    EXPECT_GT(same, all * 98 / 100);
    EXPECT_EQ(entries.parts.size(), 6u);
    EXPECT_EQ(entries.parts[5].name, "-Z");
    EXPECT_EQ(shown.at(entries.parts[5].pixels.left * times, entries.parts[5].pixels.top * times),
              kFaintWords);
    const int bar = entries.height * times + 12 + 9; // through its middle
    int first = -1, last = -1;
    for (int x = 0; x < shown.width; ++x) {
        if (shown.at(x, bar) == heatColour(0.0) && first < 0) first = x;
        if (shown.at(x, bar) == heatColour(1.0)) last = x;
    }
    ASSERT_GE(first, 0);
    EXPECT_EQ(last - first, 255);
    // What explains itself stays as it is, unless something is marked in it.
    const PreviewPicture image = draw(cpu_, "image");
    EXPECT_EQ(present(image).rgb, image.rgb);
    PreviewRequest request;
    request.path = PathRequest{{20, 12}, {}};
    const Picture marked = present(draw(cpu_, "image", request));
    const int enlarged = 768 / image.width;
    EXPECT_GT(marked.height, image.height * enlarged);
    EXPECT_EQ(marked.at(20 * enlarged - 1, 12 * enlarged - 1), kWords);
    EXPECT_EQ(marked.at(20 * enlarged, 12 * enlarged), image.at(20, 12));
}

TEST_F(Preview, AsksForWhatThereIs) {
    PreviewRequest request;
    request.level = 13;
    EXPECT_NE(inputError([&] { draw(cpu_, "near", request); }).find("--level 13"),
              std::string::npos);
    EXPECT_NE(inputError([&] { draw(cpu_, "shadowmap"); }).find("has none"), std::string::npos);
    request.event = 40;
    EXPECT_NE(inputError([&] { draw(cpu_, "hits", request); }).find("path events"),
              std::string::npos);
}

#ifdef DIRT_HAVE_EMBREE
TEST_F(Preview, IsTheSameWithEmbree) {
    EmbreeBackend embree(pool_);
    for (const char* name :
         {"image", "hits", "distance", "visibility", "position", "normal", "geometric-normal",
          "diffuse", "roughness", "reflectance", "metallic", "primitive", "barycentrics"})
        EXPECT_EQ(draw(cpu_, name).rgb, draw(embree, name).rgb) << name;
    for (const char* name : {"near", "entries", "tests", "time", "overview"})
        EXPECT_NE(inputError([&] { draw(embree, name); }).find("no grid"), std::string::npos);
}
#endif

} // namespace
} // namespace dirt
