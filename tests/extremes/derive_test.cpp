// Each variant is what its name says, in the frame's geometry.

#include "core/grid/grid.h"
#include "core/verify/exact.h"
#include "core/verify/extreme_bodies.h"
#include "core/verify/extremes.h"
#include "tests/extremes/small_scene.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

namespace dirt {
namespace {

/// A variant of the small scene.
struct Variant {
    Scene scene = test::smallScene();
    GridSettings grid = test::smallSettings().grid;
    FrameGeometry geometry;
    size_t before = scene.mesh.triangles.size();

    explicit Variant(std::string_view name) {
        extremeByName(name)->derive(scene, grid);
        geometry = makeFrameGeometry(scene.mesh, scene.camera, grid.mode);
    }
    const std::vector<Triangle>& triangles() const { return geometry.triangles; }
    size_t added() const { return triangles().size() - before; }
    template <class Predicate>
    size_t count(Predicate predicate) const {
        return (size_t) std::count_if(triangles().begin(), triangles().end(), predicate);
    }
};

glm::vec3 corner(const Triangle& t, int i) {
    return i % 3 == 0 ? t.a : i % 3 == 1 ? t.b : t.c;
}

/// With one of the three corners first, whether \p predicate(a, b, c) holds.
template <class Predicate>
bool anyTurn(const Triangle& t, Predicate predicate) {
    for (int i = 0; i < 3; i++)
        if (predicate(glm::dvec3(corner(t, i)), glm::dvec3(corner(t, i + 1)),
                      glm::dvec3(corner(t, i + 2))))
            return true;
    return false;
}

/// Exactly.
bool hasArea(const Triangle& t) {
    const DyadicVector a(t.a);
    const DyadicVector n = cross(DyadicVector(t.b) - a, DyadicVector(t.c) - a);
    return n.x.sign() != 0 || n.y.sign() != 0 || n.z.sign() != 0;
}

double shortestEdge(const Triangle& t) {
    return std::min({glm::distance(glm::dvec3(t.a), {t.b}), glm::distance(glm::dvec3(t.b), {t.c}),
                     glm::distance(glm::dvec3(t.c), {t.a})});
}

double longestEdge(const Triangle& t) {
    return std::max({glm::distance(glm::dvec3(t.a), {t.b}), glm::distance(glm::dvec3(t.b), {t.c}),
                     glm::distance(glm::dvec3(t.c), {t.a})});
}

TEST(Derive, NamesAreUniqueAndFound) {
    std::map<std::string_view, int> names;
    for (const Extreme& extreme : extremes()) {
        EXPECT_EQ(names[extreme.name]++, 0) << extreme.name;
        EXPECT_EQ(extremeByName(extreme.name), &extreme);
    }
    EXPECT_EQ(extremeByName("sideways"), nullptr);
    for (const RayKind kind : kRayKinds)
        EXPECT_TRUE(extremeByName("rays-" + std::string(rayKindName(kind)))) << rayKindName(kind);
}

TEST(Derive, ScaledAndMovedScenesKeepWhatTheyShow) {
    const Variant plain("rays-primary");
    const double size = sizeOf(plain.scene.mesh);
    const auto check = [&](std::string_view name, double scale, double sizes) {
        const Variant variant(name);
        const Bounds bounds = boundsOf(variant.scene.mesh);
        // A rounding of the coordinate at either end.
        const double rounding = 2e-7 * sizes;
        EXPECT_NEAR(sizeOf(variant.scene.mesh) / (scale * size), 1.0, rounding + 1e-6) << name;
        EXPECT_NEAR(bounds.low.x / (scale * size), sizes, rounding + 1.0) << name;
        const auto ahead = [](const Camera& camera) {
            return glm::normalize(glm::dvec3(camera.target) - glm::dvec3(camera.eye));
        };
        EXPECT_LT(glm::distance(ahead(variant.scene.camera), ahead(plain.scene.camera)), 1e-6)
            << name;
        const Spotlight &light = variant.scene.lights[0], &before = plain.scene.lights[0];
        EXPECT_NEAR(light.flux / (before.flux * scale * scale), 1.0, 1e-6) << name;
    };
    check("scale-1e-6", 1e-6, 0);
    check("scale-1e-3", 1e-3, 0);
    check("scale-1e3", 1e3, 0);
    check("scale-1e6", 1e6, 0);
    check("moved-1e3", 1, 1e3);
    check("moved-1e5", 1, 1e5);
    check("moved-1e7", 1, 1e7);
    check("scale-1e-6-moved-1e7", 1e-6, 1e7);
    check("scale-1e6-moved-1e5", 1e6, 1e5);
}

TEST(Derive, TheEyeIsWhereItIsSaidToBeExactly) {
    for (const ViewMode mode : {ViewMode::full, ViewMode::single}) {
        const auto holds = [&](const char* name, auto&& predicate) {
            Variant variant(name);
            variant.geometry = makeFrameGeometry(variant.scene.mesh, variant.scene.camera, mode);
            return variant.count(
                       [&](const Triangle& t) { return hasArea(t) && anyTurn(t, predicate); }) > 0;
        };
        using P = const glm::dvec3&;
        const glm::dvec3 eye(0.0);
        EXPECT_TRUE(holds("eye-on-vertex", [&](P a, P, P) { return a == eye; }));
        EXPECT_TRUE(holds("eye-on-edge", [&](P a, P b, P) { return a == -b; }));
        if (mode == ViewMode::single) continue; // the rotation rounds sums
        EXPECT_TRUE(
            holds("eye-on-triangle", [&](P a, P b, P c) { return a + b + 2.0 * c == eye; }));
        EXPECT_TRUE(holds("eye-in-plane", [&](P a, P b, P c) { return b + c - a == eye; }));
    }
}

TEST(Derive, ATriangleLiesInABorderOfTilesOrFaces) {
    const auto inPlane = [](const Variant& variant, double slope) {
        return variant.count([&](const Triangle& t) {
            return hasArea(t) && t.a.x == slope * t.a.z && t.b.x == slope * t.b.z &&
                   t.c.x == slope * t.c.z;
        });
    };
    for (const auto& [name, slope] :
         {std::pair{"eye-on-tile-border", 0.5}, {"eye-on-middle-border", 0.0}}) {
        const Variant variant(name);
        EXPECT_GT(inPlane(variant, slope), 0u) << name;
        // x and z are a face's axes with w = z in face 4.
        const View view = makeViews(variant.grid, variant.scene.camera)[4];
        ASSERT_EQ(view.axisW, 2);
        EXPECT_TRUE(std::find(view.s.begin(), view.s.end(), (float) slope) != view.s.end()) << name;
    }
    const Variant diagonal("eye-on-face-diagonal");
    EXPECT_GT(inPlane(diagonal, 1.0), 0u);
    EXPECT_GT(diagonal.count([](const Triangle& t) {
        return anyTurn(t, [](const glm::dvec3& a, auto, auto) { return a.x == a.y && a.y == a.z; });
    }),
              0u);
}

TEST(Derive, DepthsAreInARatioOf1e8) {
    for (const char* name : {"near-1e-8", "far-1e8"}) {
        const Variant variant(name);
        double least = 1e30, most = 0.0;
        for (const Triangle& t : variant.triangles()) {
            const double distance = glm::length(glm::dvec3(t.a));
            least = std::min(least, distance), most = std::max(most, distance);
            EXPECT_TRUE(hasArea(t) || &t - variant.triangles().data() < (long) variant.before);
        }
        EXPECT_GT(most / least, 1e8) << name;
    }
}

TEST(Derive, AddedTrianglesAreAsThinAsTheyAreCalled) {
    const auto addedWith = [](const char* name, auto&& predicate) {
        const Variant variant(name);
        size_t count = 0;
        for (size_t i = variant.before; i < variant.triangles().size(); i++)
            count += predicate(variant.triangles()[i]);
        EXPECT_EQ(variant.added(), variant.before) << name;
        return count;
    };
    const size_t all = Variant("rays-primary").before;
    EXPECT_GT(addedWith("slivers",
                        [](const Triangle& t) {
                            const double area =
                                glm::length(glm::cross(glm::dvec3(t.b) - glm::dvec3(t.a),
                                                       glm::dvec3(t.c) - glm::dvec3(t.a)));
                            return area < 2e-5 * longestEdge(t) * longestEdge(t) &&
                                   shortestEdge(t) > 0.1 * longestEdge(t);
                        }),
              all * 9 / 10);
    EXPECT_GT(addedWith("needles",
                        [](const Triangle& t) { return shortestEdge(t) < 1e-5 * longestEdge(t); }),
              all * 9 / 10);
    const auto different = [](const Triangle& t) {
        return (t.a != t.b) + (t.b != t.c) + (t.c != t.a);
    };
    EXPECT_EQ(addedWith("points", [&](const Triangle& t) { return different(t) == 0; }), all);
    EXPECT_GT(addedWith("repeated", [&](const Triangle& t) { return different(t) == 2; }),
              all * 9 / 10);
    EXPECT_GT(
        addedWith("collinear", [&](const Triangle& t) { return different(t) == 3 && !hasArea(t); }),
        all / 4); // the others' corners have that coordinate in common
}

TEST(Derive, CoincidentTrianglesComeInEveryOrder) {
    const Variant variant("coincident");
    ASSERT_EQ(variant.added(), 6 * variant.before);
    std::map<std::vector<float>, int> orders;
    for (size_t i = variant.before; i < variant.before + 6; i++) {
        const Triangle& t = variant.triangles()[i];
        orders[{t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z}]++;
    }
    EXPECT_EQ(orders.size(), 6u);
}

TEST(Derive, CutEdgesMeetTheirNeighboursInAVertexOfTheirsAlone) {
    const Variant variant("t-junctions");
    EXPECT_EQ(variant.added(), variant.before);
    const Mesh &mesh = variant.scene.mesh, before = test::smallScene().mesh;
    for (size_t id = 0; id < variant.before; id++) {
        const Corners &first = mesh.triangles[id], &second = mesh.triangles[variant.before + id],
                      &whole = before.triangles[id];
        ASSERT_EQ(first, (Corners{whole[0], second[0], whole[2]}));
        ASSERT_EQ(second, (Corners{first[1], whole[1], whole[2]}));
    }
}

TEST(Derive, ABinIsCrowdedAndAViewCovered) {
    const Variant crowded("crowded-bin");
    EXPECT_EQ(crowded.added(), 10'000u);
    GridSettings grid{.mode = ViewMode::single, .width = 64, .height = 64, .tile = 16, .bins = 4};
    const auto longest = [&](const Variant& variant) {
        const FrameGeometry geometry =
            makeFrameGeometry(variant.scene.mesh, variant.scene.camera, grid.mode);
        const Grid built = buildGrid(geometry, variant.scene.camera, grid);
        size_t most = 0;
        for (int tile = 0; tile < built.views[0].tiles(); tile++)
            for (int bin = 0; bin < grid.bins; bin++)
                most = std::max(most, built.list(0, tile, bin).size());
        return most;
    };
    EXPECT_GT(longest(crowded), 9'000u);

    const Variant covering("covering");
    const FrameGeometry geometry =
        makeFrameGeometry(covering.scene.mesh, covering.scene.camera, grid.mode);
    const Grid built = buildGrid(geometry, covering.scene.camera, grid);
    const auto id = (uint32_t) covering.before;
    for (int tile = 0; tile < built.views[0].tiles(); tile++) {
        bool listed = false;
        for (int bin = 0; bin < grid.bins; bin++) {
            const auto list = built.list(0, tile, bin);
            listed |= std::find(list.begin(), list.end(), id) != list.end();
        }
        ASSERT_TRUE(listed) << tile;
    }
}

TEST(Derive, SettingsAreThoseOfTheName) {
    EXPECT_FLOAT_EQ(Variant("fov-0.01").scene.camera.verticalFov, 0.01f);
    EXPECT_FLOAT_EQ(Variant("fov-179.99").scene.camera.verticalFov, 179.99f);
    EXPECT_EQ(Variant("fov-179.99").grid.mode, ViewMode::single);
    const GridSettings wide = Variant("size-8192x1-single").grid;
    EXPECT_EQ(wide.width, 8192);
    EXPECT_EQ(wide.height, 1);
    EXPECT_EQ(wide.mode, ViewMode::single);
    EXPECT_EQ(Variant("size-1x1").grid.width, 1);
    EXPECT_EQ(Variant("size-1x8192").grid.mode, ViewMode::full);
    EXPECT_EQ(Variant("bins-1").grid.bins, 1);
    EXPECT_EQ(Variant("bins-256").grid.bins, 256);
    const GridSettings large = Variant("tile-beyond-image").grid;
    EXPECT_GT(large.tile, std::max(large.width, large.height));
}

TEST(Derive, TheBoxIsClosedAndHoldsTheScene) {
    for (const char* name : {"box-shared", "box-unshared", "box-shared-moved-1e5"}) {
        const Variant variant(name);
        ASSERT_EQ(variant.added(), 12u);
        const Mesh& mesh = variant.scene.mesh;
        const Room room = roomOf(mesh);
        const bool shared = std::string_view(name).find("unshared") == std::string_view::npos;
        std::map<std::pair<uint32_t, uint32_t>, int> edges;
        for (size_t i = 0; i < mesh.triangles.size(); i++)
            for (int k = 0; k < 3; k++) {
                const uint32_t a = mesh.triangles[i][k], b = mesh.triangles[i][(k + 1) % 3];
                if (i >= variant.before) {
                    edges[std::minmax(a, b)]++;
                    continue;
                }
                const glm::vec3 p = mesh.positions[a];
                for (int axis = 0; axis < 3; axis++)
                    ASSERT_TRUE(room.low[axis] < p[axis] && p[axis] < room.high[axis]) << name;
            }
        // 12 edges and 6 diagonals; or 6 diagonals, and each wall's own edges.
        EXPECT_EQ(edges.size(), shared ? 18u : 30u);
        EXPECT_EQ(std::count_if(edges.begin(), edges.end(), [](auto& e) { return e.second == 2; }),
                  shared ? 18 : 6);
        const glm::vec3 eye = variant.scene.camera.eye, light = variant.scene.lights[0].position;
        EXPECT_TRUE(glm::all(glm::lessThan(room.low, eye)) &&
                    glm::all(glm::lessThan(eye, room.high)));
        EXPECT_FALSE(glm::all(glm::lessThan(light, room.high)));
    }
}

TEST(Derive, TheBallIsClosed) {
    const Variant variant("ball");
    EXPECT_EQ(variant.triangles().size(), 80u);
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    for (const Corners& t : variant.scene.mesh.triangles)
        for (int k = 0; k < 3; k++) edges[std::minmax(t[k], t[(k + 1) % 3])]++;
    EXPECT_EQ(edges.size(), 120u);
    for (const auto& [edge, count] : edges) EXPECT_EQ(count, 2);
}

} // namespace
} // namespace dirt
