// What leaves are made of, against what it has to hold: the box of a cell every depth of its bin,
// and which triangles no ray hits.

#include "backend_cpu/trace/leaf_boxes.h"
#include "backend_cpu/trace/without_area.h"
#include "core/trace/determinant.h"
#include "tests/support/nasty_rays.h"
#include "tests/support/print.h"
#include "tests/support/simd_targets.h"
#include "tests/support/views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace dirt::test {
namespace {

/// A grid of one tile a face, whose first has the given bounds.
Grid gridOf(DepthBounds bounds, int bins) {
    ViewSet set = fullViews(1, 1);
    set.settings.bins = bins;
    Grid grid = makeEmptyGrid(set.camera, set.settings);
    grid.pyramids[4].levels[0].bounds[0] = bounds;
    return grid;
}

/// Empty, or the depth near the border of two bins that the box of its bin does not hold.
std::string outside(DepthBounds bounds, int bins, int bin, int around) {
    const Grid grid = gridOf(bounds, bins);
    const BinMap map(bounds, bins);
    float w = (float) (bounds.near + bin * ((double) bounds.far - bounds.near) / bins);
    for (int i = 0; i < around; ++i) w = std::nextafter(w, 0.0f);
    for (int i = -around; i <= around; ++i, w = std::nextafter(w, 9.0f)) {
        if (w < bounds.near || w > bounds.far) continue;
        const LeafBox box = boxOfCell(grid, 4, 0, map(w)); // its frame is the grid's
        if (w < box.low.z || w > box.high.z)
            return hex(w) + " in bin " + std::to_string(map(w)) + " of " + std::to_string(bins) +
                   " from " + hex(bounds.near) + " to " + hex(bounds.far);
    }
    return "";
}

TEST(LeafBoxes, HoldEveryDepthOfTheirBins) {
    Random random(67);
    for (int i = 0; i < cases(20'000, 1'000'000); ++i) {
        const float far = (float) random.uniform(0.5, 2);
        const float near = far * (float) random.pick({random.uniform(), random.uniform(0.9, 1)});
        const int bins = random.range(2, 256);
        ASSERT_EQ(outside({near, far}, bins, random.range(1, bins - 1), 6), "");
    }
}

/// As exact arithmetic says, also where differences round.
TEST(WithoutArea, FindsAllWithoutAndNoOthers) {
    Random random(68);
    NastyRays nasty(random);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 20'000; ++i) triangles.push_back(nasty.triangle());
    for (int i = 0; i < 2'000; ++i) { // on a line through the origin, from beside it
        const float k = (float) random.range(2, 9), tiny = (float) random.wide(-17, -15);
        const float x = (float) random.range(1, 99), step = (float) random.range(1, 99);
        triangles.push_back({{tiny, tiny * k, 0}, {x, x * k, 0}, {x + step, (x + step) * k, 0}});
    }
    std::vector<uint8_t> expected;
    for (const Triangle& t : triangles) {
        bool area = false;
        for (const glm::vec3 axis : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)})
            area = area || directionDeterminantExact(axis, t.a, t.b, t.c) != 0.0;
        expected.push_back(!area);
    }
    forEachTarget([&] {
        std::vector<uint8_t> found(triangles.size());
        findWithoutArea(triangles, found.data());
        for (size_t i = 0; i < found.size(); ++i)
            ASSERT_EQ(found[i], expected[i]) << hex(triangles[i]);
    });
}

} // namespace
} // namespace dirt::test
