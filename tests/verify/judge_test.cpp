#include "core/trace/intersect.h"
#include "core/verify/judge.h"
#include "tests/verify/rational_oracle.h"

#include <random>

#include <gtest/gtest.h>

using namespace dirt;

namespace {

FrameGeometry geometryOf(std::vector<Triangle> triangles) {
    return {GridFrame{}, triangles};
}

class Numbers {
public:
    explicit Numbers(uint32_t seed) : random_(seed) {}
    int below(int n) { return (int) (random_() % (uint32_t) n); }
    float uniform() { return std::uniform_real_distribution<float>(-1.0f, 1.0f)(random_); }

    /// Few values, so that points, edges and planes coincide all the time.
    glm::vec3 lattice() { return {below(4) - 1.5f, below(4) - 1.5f, below(4) - 1.5f}; }
    /// All 24 bits used.
    glm::vec3 full() { return {uniform(), uniform(), uniform()}; }
    /// Exponents from 1e-6 to 1e6, each coordinate its own.
    glm::vec3 wide() {
        const auto one = [&] { return std::ldexp(uniform(), below(41) - 20); };
        return {one(), one(), one()};
    }

private:
    std::mt19937 random_;
};

template <class Point>
FrameGeometry soup(int count, Point point) {
    std::vector<Triangle> triangles;
    for (int i = 0; i < count; i++) triangles.push_back({point(), point(), point()});
    return geometryOf(triangles);
}

/// A ray at a random place of a random triangle: through it, a corner, an edge's middle, or in
/// its plane.
template <class Point>
Ray aimedRay(const FrameGeometry& geometry, Numbers& numbers, Point point) {
    const Triangle& t = geometry.triangles[numbers.below((int) geometry.triangles.size())];
    const glm::vec3 origin = point();
    switch (numbers.below(5)) {
    case 0:
        return {origin, t.a - origin, kNoPrimitive};
    case 1:
        return {origin, (t.a + t.b) * 0.5f - origin, kNoPrimitive};
    case 2:
        return {origin, (t.a + t.b + t.c) * (1.0f / 3.0f) - origin, kNoPrimitive};
    case 3:
        return {t.a, t.b - t.a, kNoPrimitive};
    default:
        return {origin, point(), kNoPrimitive};
    }
}

template <class Point>
void compareWithRationals(uint32_t seed, int scenes, int rays, Point point) {
    Numbers numbers(seed);
    const auto draw = [&] { return (numbers.*point)(); };
    int hits = 0, ties = 0;
    for (int s = 0; s < scenes; s++) {
        const FrameGeometry geometry = soup(30, draw);
        const Judge judge(geometry);
        for (int r = 0; r < rays; r++) {
            const Ray ray = aimedRay(geometry, numbers, draw);
            if (ray.direction == glm::vec3(0.0f)) continue;
            const Verdict verdict = judge.nearest(ray);
            ASSERT_EQ(verdict.primitives, test::rationalNearest(geometry, ray));
            ASSERT_EQ(verdict.primitives, judge.nearestOfAll(ray).primitives);
            hits += verdict.found();
            ties += verdict.primitives.size() > 1;
        }
    }
    EXPECT_GT(hits, scenes * rays / 10);
    if (point == &Numbers::lattice) {
        EXPECT_GT(ties, scenes * rays / 50);
    }
}

} // namespace

TEST(Judge, EqualsRationalsWhereEverythingCoincides) {
    compareWithRationals(1, 12, 60, &Numbers::lattice);
}

TEST(Judge, EqualsRationalsWithFullMantissas) {
    compareWithRationals(2, 12, 60, &Numbers::full);
}

TEST(Judge, EqualsRationalsOverTwelveOrdersOfMagnitude) {
    compareWithRationals(3, 12, 60, &Numbers::wide);
}

TEST(Judge, BoxTreeLosesNothing) {
    // Thousands of triangles, among them many whose boxes are flat and touched exactly.
    Numbers numbers(4);
    std::vector<Triangle> triangles;
    for (int i = 0; i < 4000; i++) {
        const glm::vec3 corner = glm::vec3(numbers.below(20), numbers.below(20), numbers.below(20));
        triangles.push_back({corner, corner + numbers.lattice(), corner + numbers.lattice()});
    }
    const FrameGeometry geometry = geometryOf(triangles);
    const Judge judge(geometry);
    for (int r = 0; r < 1000; r++) {
        Ray ray = aimedRay(geometry, numbers, [&] { return numbers.full() * 20.0f; });
        if (r % 3 == 0) ray.direction = glm::vec3(0, -0.0f, r % 2 ? 1 : -1), ray.origin.z = -5;
        const Verdict tree = judge.nearest(ray), all = judge.nearestOfAll(ray);
        ASSERT_EQ(tree.primitives, all.primitives);
        ASSERT_EQ(tree.t, all.t);
    }
}

TEST(Judge, SkipsTheOriginsTriangleAndItsCopies) {
    const glm::vec3 a{0, 0, 1}, b{1, 0, 1}, c{0, 1, 1};
    const glm::vec3 behind{0, 0, 1};
    const FrameGeometry geometry =
        geometryOf({{a, b, c}, {c, a, b}, {b, a, c}, {a + behind, b + behind, c + behind}});
    const Judge judge(geometry);
    Ray ray{{0.25f, 0.25f, 0.0f}, {0, 0, 1}, kNoPrimitive};
    EXPECT_EQ(judge.nearest(ray).primitives, (std::vector<uint32_t>{0, 1, 2}));
    ray.skip = 1;
    EXPECT_EQ(judge.nearest(ray).primitives, std::vector<uint32_t>{3});
    EXPECT_EQ(judge.judge(ray, judge.nearest(ray), Hit{0, 1.0f}).grade, Grade::wrongPrimitive);
}

TEST(Judge, ClosedTriangleAndRayStart) {
    const FrameGeometry geometry = geometryOf({{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}});
    const Judge judge(geometry);
    const auto hit = [&](glm::vec3 o, glm::vec3 d) { return judge.nearest({o, d}).found(); };
    EXPECT_TRUE(hit({0.25f, 0.25f, 1}, {0, 0, 1})) << "t = 0";
    EXPECT_FALSE(hit({0.25f, 0.25f, std::nextafter(1.0f, 2.0f)}, {0, 0, 1}));
    EXPECT_TRUE(hit({1, 0, 0}, {0, 0, 1})) << "vertex";
    EXPECT_FALSE(hit({std::nextafter(1.0f, 2.0f), 0, 0}, {0, 0, 1}));
    EXPECT_FALSE(hit({-1, 0.25f, 1}, {1, 0, 0})) << "in the plane";
    EXPECT_FALSE(hit({0.25f, 0.25f, 0}, {0, 0, 0}));
    EXPECT_FALSE(hit({NAN, 0.25f, 0}, {0, 0, 1}));
    EXPECT_FALSE(hit({0.25f, 0.25f, 0}, {0, 0, INFINITY}));
}

TEST(Judge, Grades) {
    // Three walls; the second is nearer than the third by less than err(t).
    const auto wall = [](float z) { return Triangle{{-9, -9, z}, {9, -9, z}, {0, 9, z}}; };
    const float near = 1.0f, far = 4.0f, farther = std::nextafter(far, 5.0f);
    const FrameGeometry geometry = geometryOf({wall(near), wall(far), wall(farther)});
    const Judge judge(geometry);
    const auto grade = [&](const Ray& ray, const Hit& hit) {
        return judge.judge(ray, judge.nearest(ray), hit);
    };
    const Ray through{{0, 0, 0}, {0, 0, 1}}, past{{0, 0, 5}, {0, 0, 1}},
        later{{0, 0, 2}, {0, 0, 1}};

    EXPECT_EQ(grade(through, Hit{0, near}).grade, Grade::right);
    EXPECT_EQ(grade(through, Hit{}).grade, Grade::missed);
    EXPECT_EQ(grade(through, Hit{1, far}).grade, Grade::wrongPrimitive);
    EXPECT_EQ(grade(past, Hit{}).grade, Grade::right);
    EXPECT_EQ(grade(past, Hit{1, 1.0f}).grade, Grade::falseHit);
    EXPECT_EQ(grade(later, Hit{0, 1.0f}).grade, Grade::wrongPrimitive) << "behind the origin";
    EXPECT_EQ(grade(through, Hit{77, 1.0f}).grade, Grade::wrongPrimitive) << "no such primitive";

    // From the origin the far walls differ by 2^-21 / 4 = 2^-23 relative to the nearer one, so by
    // less than 2^-23 relative to the farther; from z = 2 by twice that.
    const FrameGeometry two = geometryOf({wall(far), wall(farther)});
    const Judge judgeTwo(two);
    EXPECT_EQ(judgeTwo.judge(through, judgeTwo.nearest(through), Hit{1, farther}).grade,
              Grade::right);
    EXPECT_EQ(judgeTwo.judge(later, judgeTwo.nearest(later), Hit{1, farther - 2}).grade,
              Grade::wrongPrimitive);

    EXPECT_EQ(grade(through, Hit{0, near}).relativeTError, 0.0);
    EXPECT_EQ(grade(through, Hit{0, 1.0f + 0x1p-23f}).relativeTError, 0x1p-23);
}
