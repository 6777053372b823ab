// The polygon that is told of a triangle in a tile is what the clip takes the depths of.

#include "core/explain/clip_polygon.h"

#include "shaders/shared/tile_clip.h"
#include "tests/support/nasty_triangles.h"
#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace dirt {
namespace {

using namespace test;
using Polygon = std::vector<glm::dvec3>;

/// The interval that the clip would make of a polygon's corners.
bool depthsOf(const Polygon& polygon, glm::vec2& interval) {
    ClippedDepths depths;
    for (const glm::dvec3& corner : polygon) includeDepth(depths, corner.z);
    return listedDepths(depths, interval);
}

TEST(ClippedPolygon, HasTheDepthsOfTheClip) {
    Random random(5);
    const std::vector<ViewSet> sets = variousViews(random);
    NastyTriangles nasty(random, sets);
    size_t found = 0, none = 0;
    for (int i = 0; i < cases(40000, 1000000); ++i) {
        const TileCase c = nasty.next();
        ViewTriangle setup;
        if (!setUpTriangle(c.triangle, *c.view, setup)) continue;
        DepthInterval depths;
        const bool listed = clipToTile(setup, *c.view, c.column, c.row, depths);
        const Polygon polygon = clippedPolygon(setup, *c.view, c.column, c.row);
        ASSERT_EQ(polygon.empty(), !listed) << c.kind;
        (listed ? found : none) += 1;
        if (!listed) continue;
        glm::vec2 interval;
        ASSERT_TRUE(depthsOf(polygon, interval)) << c.kind;
        ASSERT_EQ(interval.x, depths.near) << c.kind;
        ASSERT_EQ(interval.y, depths.far) << c.kind;
    }
    EXPECT_GT(found, 5000u);
    EXPECT_GT(none, 5000u);
}

/// Cuts a polygon by a plane after the other, the plain way.
Polygon cutByPlanes(const ViewTriangle& triangle, const View& view, int column, int row) {
    Polygon polygon;
    for (const glm::vec3& vertex : triangle.vertices) polygon.emplace_back(vertex);
    for (int side = 0; side < 4; ++side) {
        const int axis = side >> 1;
        const auto& borders =
            axis == 0 ? (side & 1 ? view.sHi : view.sLo) : (side & 1 ? view.tHi : view.tLo);
        const double slope = (double) borders[(size_t) (axis == 0 ? column : row)];
        const auto inside = [&](const glm::dvec3& p) {
            return (p[axis] - slope * p.z) * (side & 1 ? -1.0 : 1.0);
        };
        Polygon rest;
        for (size_t i = 0; i < polygon.size(); ++i) {
            const glm::dvec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
            const double da = inside(a), db = inside(b);
            if (da >= 0.0) rest.push_back(a);
            if ((da < 0.0) != (db < 0.0)) rest.push_back(a + (b - a) * (da / (da - db)));
        }
        polygon = rest;
    }
    return polygon;
}

/// Its area, if its corners are in their order; and its length around.
std::pair<double, double> sizeOf(const Polygon& polygon) {
    glm::dvec3 area(0.0);
    double around = 0.0;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        area += 0.5 * glm::cross(a - polygon[0], b - polygon[0]);
        around += glm::length(b - a);
    }
    return {glm::length(area), around};
}

/// A corner is good for about 2^-24 of its distance from the eye; what that changes of an area is
/// below its length around times four times as much.
TEST(ClippedPolygon, IsWhatPlanesLeaveOfTheTriangle) {
    Random random(6);
    std::vector<Triangle> triangles;
    addSoup(random, triangles, 300);
    const ViewSet set = fullViews(64, 4);
    size_t corners[8] = {};
    for (const Triangle& triangle : triangles)
        for (const View& view : set.views) {
            ViewTriangle setup;
            if (!setUpTriangle(triangle, view, setup)) continue;
            const TileRange range = tileRange(setup, view);
            for (int row = range.row0; row <= range.row1; ++row)
                for (int column = range.column0; column <= range.column1; ++column) {
                    const Polygon polygon = clippedPolygon(setup, view, column, row);
                    const auto [area, around] = sizeOf(polygon);
                    const auto [plain, plainAround] = sizeOf(cutByPlanes(setup, view, column, row));
                    double farthest = 0.0;
                    for (const glm::dvec3& p : polygon)
                        farthest = std::max(farthest, glm::length(p));
                    ASSERT_NEAR(area, plain, (around + plainAround) * farthest * 0x1p-22);
                    ++corners[std::min<size_t>(polygon.size(), 7)];
                }
        }
    for (const size_t count : {3, 4, 5, 6}) EXPECT_GT(corners[count], 20u) << count;
}

} // namespace
} // namespace dirt
