// What a tile lists, beside what it should.

#include "core/explain/listing.h"

#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dirt {
namespace {

using namespace test;

class Listing : public testing::Test {
protected:
    Listing() {
        Random random(11);
        addSoup(random, geometry_.triangles, 100);
        GridSettings settings;
        settings.viewSize = 64;
        settings.bins = 4;
        grid_ = buildGrid(geometry_, Camera(), settings);
    }
    FrameGeometry geometry_;
    Grid grid_;
};

TEST_F(Listing, HasEveryEntryOnceFromBothSides) {
    size_t ofTiles = 0, ofPrimitives = 0;
    for (int v = 0; v < (int) grid_.views.size(); ++v)
        for (int row = 0; row < grid_.views[(size_t) v].rows; ++row)
            for (int column = 0; column < grid_.views[(size_t) v].columns; ++column)
                for (const TileEntry& entry : entriesOfTile(grid_, geometry_, v, column, row)) {
                    EXPECT_TRUE(entry.isRight());
                    ofTiles += entry.bins.size();
                }
    for (uint32_t id = 0; id < geometry_.triangles.size(); ++id)
        for (const TileEntry& entry : entriesOfPrimitive(grid_, geometry_, id)) {
            EXPECT_TRUE(entry.isRight());
            ofPrimitives += entry.bins.size();
        }
    EXPECT_EQ(ofTiles, grid_.ids.size());
    EXPECT_EQ(ofPrimitives, grid_.ids.size());
}

/// One id in a list becomes another: one entry is missing, one is not due.
TEST_F(Listing, FindsAnEntryThatIsWrong) {
    const size_t at = grid_.ids.size() / 2;
    const uint32_t lost = grid_.ids[at];
    uint32_t invented = 0;
    const size_t cell =
        (size_t) (std::upper_bound(grid_.heads.begin(), grid_.heads.end(), (uint32_t) at) -
                  grid_.heads.begin()) -
        1;
    const auto list = [&] {
        return std::span(grid_.ids).subspan(grid_.heads[cell],
                                            grid_.heads[cell + 1] - grid_.heads[cell]);
    };
    while (std::count(list().begin(), list().end(), invented) > 0) ++invented;
    grid_.ids[at] = invented;
    const auto wrongOf = [&](uint32_t id) {
        const auto entries = entriesOfPrimitive(grid_, geometry_, id);
        return std::count_if(entries.begin(), entries.end(),
                             [](const TileEntry& entry) { return !entry.isRight(); });
    };
    EXPECT_EQ(wrongOf(lost), 1);
    EXPECT_EQ(wrongOf(invented), 1);
}

} // namespace
} // namespace dirt
