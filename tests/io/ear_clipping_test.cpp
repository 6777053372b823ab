#include "core/io/ear_clipping.h"
#include "tests/support/processor_time.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace dirt {
namespace {

using Polygon = std::vector<glm::vec3>;
using Ears = std::vector<EarClipper::Ear>;

Ears clip(const Polygon& polygon) {
    EarClipper clipper;
    const auto ears = clipper(polygon);
    return {ears.begin(), ears.end()};
}

double cross(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Checks a polygon in the plane z = 0 with integer coordinates below 2^20, which runs
/// counter-clockwise and does not cross itself: its n - 2 triangles cover it exactly. How often
/// triangles, counted with sign, cover a point is how often the polygon winds around it: here once
/// or never. So it is enough that none of them is turned or without area.
void expectExactCover(const Polygon& polygon) {
    const Ears ears = clip(polygon);
    ASSERT_EQ(ears.size(), polygon.size() - 2);
    double sum = 0.0, area = 0.0;
    for (const auto& ear : ears) {
        const double piece = cross(polygon[ear[0]], polygon[ear[1]], polygon[ear[2]]);
        EXPECT_GT(piece, 0.0) << ear[0] << ' ' << ear[1] << ' ' << ear[2];
        sum += piece;
    }
    for (size_t i = 1; i + 1 < polygon.size(); ++i)
        area += cross(polygon[0], polygon[i], polygon[i + 1]);
    EXPECT_EQ(sum, area); // sums of integers below 2^53: exact
}

TEST(EarClipping, MakesAFanOfConvexPolygons) {
    EXPECT_EQ(clip({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}), (Ears{{0, 1, 2}}));
    EXPECT_EQ(clip({{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {2, 2, 0}, {0, 2, 0}}),
              (Ears{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

/// So that a ray near one corner does not meet most of the triangles.
TEST(EarClipping, SharesTheEarsOfManyCornersOut) {
    Polygon parabola;
    for (int x = -1000; x <= 1000; ++x) parabola.emplace_back(x, x * x, 0);
    expectExactCover(parabola);
    std::vector<int> triangles(parabola.size());
    for (const auto& ear : clip(parabola))
        for (const uint32_t corner : ear) ++triangles[corner];
    // Two for each time that half of the corners go.
    EXPECT_LE(*std::max_element(triangles.begin(), triangles.end()), 2 * 11);
}

TEST(EarClipping, NeedsThreeCorners) {
    EXPECT_TRUE(clip({}).empty());
    EXPECT_TRUE(clip({{0, 0, 0}, {1, 0, 0}}).empty());
}

TEST(EarClipping, KeepsConcaveShapes) {
    expectExactCover({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 1, 0}});                       // dart
    expectExactCover({{3, 1, 0}, {0, 0, 0}, {4, 0, 0}, {4, 4, 0}});                       // shifted
    expectExactCover({{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 4, 0}, {0, 4, 0}}); // L
    expectExactCover({{0, 0, 0},
                      {9, 0, 0},
                      {9, 5, 0},
                      {6, 5, 0},
                      {6, 1, 0},
                      {3, 1, 0},
                      {3, 5, 0},
                      {0, 5, 0}}); // U
    expectExactCover({{0, 0, 0},
                      {8, 0, 0},
                      {8, 8, 0},
                      {1, 8, 0},
                      {1, 2, 0},
                      {6, 2, 0},
                      {6, 6, 0},
                      {3, 6, 0},
                      {3, 5, 0},
                      {5, 5, 0},
                      {5, 3, 0},
                      {2, 3, 0},
                      {2, 7, 0},
                      {7, 7, 0},
                      {7, 1, 0},
                      {0, 1, 0}}); // spiral
}

TEST(EarClipping, GivesCornersInLineAreaWhereItCan) {
    expectExactCover({{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 4, 0}, {0, 4, 0}});
    expectExactCover({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 3, 0}});
}

TEST(EarClipping, KeepsHolesThatAreReachedOverADoubleEdge) {
    // An outer square, an inner one run through the other way, and the way there and back.
    expectExactCover({{0, 0, 0},
                      {6, 0, 0},
                      {6, 6, 0},
                      {0, 6, 0},
                      {0, 0, 0},
                      {2, 2, 0},
                      {2, 4, 0},
                      {4, 4, 0},
                      {4, 2, 0},
                      {2, 2, 0}});
}

TEST(EarClipping, KeepsRandomStarPolygons) {
    std::mt19937 random(1);
    for (int round = 0; round < 300; ++round) {
        // Corners in the order of their angle around the origin, at random distances.
        const int count = 4 + (int) (random() % 60);
        Polygon polygon;
        for (int i = 0; i < count; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / count;
            const double radius = 1000.0 + (double) (random() % 100000);
            polygon.emplace_back(std::round(radius * std::cos(angle)),
                                 std::round(radius * std::sin(angle)), 0.0);
        }
        expectExactCover(polygon);
        if (testing::Test::HasFailure()) FAIL() << "round " << round;
    }
}

TEST(EarClipping, KeepsRandomRings) {
    std::mt19937 random(3);
    for (int round = 0; round < 300; ++round) {
        // Two star polygons around the origin, the inner one run through the other way; the way
        // between them follows the ray of angle 0.
        const int count = 3 + (int) (random() % 12);
        const auto corner = [&](int i, unsigned nearest) {
            const double angle = 2.0 * std::numbers::pi * i / count;
            const double radius = nearest + (double) (random() % 20000);
            return glm::vec3(std::round(radius * std::cos(angle)),
                             std::round(radius * std::sin(angle)), 0.0);
        };
        Polygon polygon, hole;
        // Half of the outer radius is left between neighbours 120 degrees apart.
        for (int i = 0; i < count; ++i) polygon.push_back(corner(i, 60000));
        for (int i = 0; i < count; ++i) hole.push_back(corner(i, 5000));
        polygon.push_back(polygon[0]);
        polygon.push_back(hole[0]);
        polygon.insert(polygon.end(), hole.rbegin(), hole.rend());
        polygon.pop_back();
        polygon.push_back(hole[0]);
        // Begin anywhere.
        std::rotate(polygon.begin(), polygon.begin() + random() % polygon.size(), polygon.end());
        expectExactCover(polygon);
        if (testing::Test::HasFailure()) FAIL() << "round " << round;
    }
}

TEST(EarClipping, KeepsRingsWithManyCornersInLine) {
    // A square of side 6 around one of side 2, with a corner at every step of 1.
    Polygon outer, ring;
    const auto walk = [](Polygon& to, glm::vec3 from, int side) {
        const glm::vec3 steps[] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
        for (const glm::vec3& step : steps)
            for (int i = 0; i < side; ++i, from += step) to.push_back(from);
    };
    Polygon hole;
    walk(outer, {0, 0, 0}, 6);
    walk(hole, {2, 2, 0}, 2);
    for (size_t start = 0; start < outer.size() + hole.size() + 2; ++start) {
        ring = outer;
        ring.push_back(outer[0]);
        ring.push_back(hole[0]);
        ring.insert(ring.end(), hole.rbegin(), hole.rend());
        std::rotate(ring.begin(), ring.begin() + (ptrdiff_t) start, ring.end());
        expectExactCover(ring);
    }
}

TEST(EarClipping, DoesNotDependOnThePlaneOrItsSide) {
    const Polygon shape = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}, {0, 4, 0}};
    const Ears expected = clip(shape);
    const auto map = [&](auto&& f) {
        Polygon mapped;
        for (const glm::vec3& p : shape) mapped.push_back(f(p));
        return clip(mapped);
    };
    EXPECT_EQ(map([](glm::vec3 p) { return glm::vec3(p.y, p.x, 0); }), expected);
    EXPECT_EQ(map([](glm::vec3 p) { return glm::vec3(0, p.x, p.y); }), expected);
    EXPECT_EQ(map([](glm::vec3 p) { return glm::vec3(p.x, 0, p.y); }), expected);
    EXPECT_EQ(map([](glm::vec3 p) { return glm::vec3(p.x, p.y, 3 * p.x + p.y); }), expected);
    EXPECT_EQ(map([](glm::vec3 p) { return p + glm::vec3(1 << 20, -(1 << 20), 7); }), expected);
    EXPECT_EQ(map([](glm::vec3 p) { return p * 1e-20f; }), expected);
    EXPECT_EQ(map([](glm::vec3 p) { return p * 1e30f; }), expected);
}

TEST(EarClipping, NeverDropsATriangle) {
    const Polygon degenerate[] = {
        {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}},            // a point
        {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}},                       // a line
        {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}},                       // a bow tie
        {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 1, 0}}, // to and fro
        {{0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {2, -2, 0}, {3, 3, 0}},           // a pentagram
    };
    for (const Polygon& polygon : degenerate) {
        const Ears ears = clip(polygon);
        EXPECT_EQ(ears.size(), polygon.size() - 2);
        std::vector<bool> used(polygon.size(), false);
        for (const auto& ear : ears) {
            EXPECT_TRUE(ear[0] != ear[1] && ear[1] != ear[2] && ear[2] != ear[0]);
            for (uint32_t corner : ear) used[corner] = true;
        }
        EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
    }
}

TEST(EarClipping, TakesRandomGarbage) {
    std::mt19937 random(2);
    for (int round = 0; round < 2000; ++round) {
        Polygon polygon(3 + random() % 30);
        for (glm::vec3& p : polygon)
            p = {(float) (random() % 5), (float) (random() % 5), (float) (random() % 2)};
        EXPECT_EQ(clip(polygon).size(), polygon.size() - 2);
    }
}

/// The method without its short cuts: corners are looked at in turn, each against all others. Of
/// polygons in the plane z = 0 that run counter-clockwise.
class PlainClipper {
public:
    explicit PlainClipper(const Polygon& polygon) {
        for (uint32_t i = 0; i < polygon.size(); ++i) corners_.push_back(i);
        for (const glm::vec3& p : polygon) positions_.emplace_back(p.x, p.y);
    }

    Ears clip() {
        Ears ears;
        size_t at = 1, refused = 0;
        for (int rule = 0; corners_.size() > 3;) {
            if (!isEar(at, rule)) {
                if (++refused == corners_.size()) ++rule, refused = 0;
                at = (at + 1) % corners_.size();
                continue;
            }
            ears.push_back({corner(at, -1), corner(at, 0), corner(at, 1)});
            corners_.erase(corners_.begin() + (ptrdiff_t) at);
            at %= corners_.size();
            refused = 0;
        }
        ears.push_back({corner(at, -1), corner(at, 0), corner(at, 1)});
        return ears;
    }

private:
    uint32_t corner(size_t at, int step) const {
        return corners_[(at + corners_.size() + (size_t) step) % corners_.size()];
    }
    double turnAt(size_t at) const {
        return cross(positions_[corner(at, -1)], positions_[corner(at, 0)],
                     positions_[corner(at, 1)]);
    }
    bool isEar(size_t at, int rule) const {
        if (rule == 3) return true;
        if (rule == 2) return turnAt(at) >= 0.0;
        if (!(turnAt(at) > 0.0)) return false;
        const glm::dvec2 a = positions_[corner(at, -1)], b = positions_[corner(at, 0)],
                         c = positions_[corner(at, 1)];
        for (size_t i = 0; i < corners_.size(); ++i) {
            const glm::dvec2 p = positions_[corner(i, 0)];
            if (turnAt(i) > 0.0 || p == a || p == b || p == c) continue;
            const double least = std::min({cross(a, b, p), cross(b, c, p), cross(c, a, p)});
            if (rule == 0 ? least >= 0.0 : least > 0.0) return false;
        }
        return true;
    }

    std::vector<uint32_t> corners_; ///< that are left
    std::vector<glm::dvec2> positions_;
};

double area(const Polygon& polygon) {
    double sum = 0.0;
    for (size_t i = 1; i + 1 < polygon.size(); ++i)
        sum += cross(polygon[0], polygon[i], polygon[i + 1]);
    return sum;
}

TEST(EarClipping, IsThePlainMethod) {
    std::mt19937 random(4);
    for (int round = 0; round < test::cases(3000, 100000); ++round) {
        const size_t count = 4 + random() % (round % 50 == 0 ? 300 : 40);
        const unsigned range = 2 + random() % (round % 2 == 0 ? 5 : 500); // most cross themselves
        Polygon polygon(count);
        for (size_t i = 0; i < count; ++i) {
            const double angle = 2.0 * std::numbers::pi * (double) i / (double) count;
            const double radius = 10.0 + (double) (random() % range);
            if (round % 3 == 0)
                polygon[i] = {(float) (random() % range), (float) (random() % range), 0.0f};
            else
                polygon[i] = {std::round(radius * std::cos(angle)),
                              std::round(radius * std::sin(angle)), 0.0};
        }
        if (area(polygon) < 0.0) std::reverse(polygon.begin(), polygon.end());
        if (area(polygon) == 0.0) continue; // another projection
        ASSERT_EQ(clip(polygon), PlainClipper(polygon).clip()) << "round " << round;
    }
}

/// Of \p count corners, by \p corner(i), from 0 on.
template <typename Corner>
Polygon polygonOf(size_t count, const Corner& corner) {
    Polygon polygon;
    for (size_t i = 0; i < count; ++i) {
        const glm::dvec2 p = corner((double) i / (double) count, i);
        polygon.emplace_back(p.x, p.y, 0.0);
    }
    return polygon;
}

TEST(EarClipping, TakesPolygonsOfManyCorners) {
    constexpr size_t kCorners = 100'000;
    const auto onCircle = [](double turn, double radius) {
        const double angle = 2.0 * std::numbers::pi * turn;
        return glm::dvec2(radius * std::cos(angle), radius * std::sin(angle));
    };
    std::mt19937 random(5);
    const std::pair<const char*, Polygon> polygons[] = {
        {"convex", polygonOf(kCorners, [&](double part, size_t) { return onCircle(part, 1.0); })},
        {"star",
         polygonOf(kCorners,
                   [&](double part, size_t i) { return onCircle(part, i % 2 == 0 ? 1.0 : 0.1); })},
        {"ragged", polygonOf(kCorners,
                             [&](double part, size_t) {
                                 return onCircle(part, 10.0 + (double) (random() % 1000));
                             })},
        {"spiral", polygonOf(kCorners,
                             [&](double part, size_t) {
                                 const double way = 200.0 * (part < 0.5 ? part : 1.0 - part);
                                 return onCircle(way, way + (part < 0.5 ? 0.5 : 0.0));
                             })},
        {"skyline", polygonOf(kCorners,
                              [&](double, size_t i) {
                                  const bool low = i == 0 || i + 1 == kCorners;
                                  return glm::dvec2((double) i,
                                                    low ? -5.0 : (double) (random() % 100));
                              })},
        {"garbage",
         polygonOf(kCorners,
                   [&](double, size_t) { return glm::dvec2(random() % 1000, random() % 1000); })},
        {"round and round a square", polygonOf(kCorners, [](double, size_t i) {
             return glm::dvec2(i % 4 == 1 || i % 4 == 2, i % 4 > 1);
         })}};
    for (const auto& [name, polygon] : polygons) {
        SCOPED_TRACE(name);
        Ears ears;
        EXPECT_LT(test::processorTime([&] { ears = clip(polygon); }), test::kGenerous);
        EXPECT_EQ(ears.size(), kCorners - 2);
    }
}

} // namespace
} // namespace dirt
