#include "core/trace/intersect.h"
#include "core/trace/traverse.h"
#include "core/verify/ray_kinds.h"
#include "tests/verify/rational_oracle.h"

#include <cfloat>
#include <cmath>
#include <cstring>
#include <numbers>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

using namespace dirt;
using test::Rational;

namespace {

constexpr uint32_t kCount = 2000;

/// A closed room with odd coordinates around a small sphere-like fan.
Mesh room() {
    Mesh mesh;
    const auto triangle = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        const auto first = (uint32_t) mesh.positions.size();
        mesh.positions.insert(mesh.positions.end(), {a, b, c});
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.materials.push_back(0);
    };
    const auto quad = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) {
        triangle(a, b, c), triangle(a, c, d);
    };
    const glm::vec3 lo{-3.1f, -1.7f, -4.3f}, hi{2.9f, 2.3f, 3.7f};
    const auto corner = [&](int i) {
        return glm::vec3(i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z);
    };
    quad(corner(0), corner(1), corner(3), corner(2)),
        quad(corner(4), corner(5), corner(7), corner(6));
    quad(corner(0), corner(1), corner(5), corner(4)),
        quad(corner(2), corner(3), corner(7), corner(6));
    quad(corner(0), corner(2), corner(6), corner(4)),
        quad(corner(1), corner(3), corner(7), corner(5));
    for (int i = 0; i < 20; i++) {
        const auto rim = [&](int k) {
            const float angle = 0.1f + (float) k * (float) std::numbers::pi / 10.0f;
            return glm::vec3(std::cos(angle), 0.3f * std::sin(3 * angle), std::sin(angle) - 1.0f);
        };
        triangle(rim(i), rim(i + 1), {0.01f, 1.013f, -1.02f});
    }
    return mesh;
}

Camera camera() {
    Camera camera;
    camera.eye = {0.3f, 0.4f, 3.1f};
    camera.target = {0.1f, 0.2f, -1.0f};
    return camera;
}

struct Fixture {
    GridSettings settings;
    FrameGeometry geometry;
    RaySource source;

    explicit Fixture(ViewMode mode = ViewMode::full, uint32_t seed = 0)
        : settings{.mode = mode}, geometry(makeFrameGeometry(room(), camera(), mode)),
          source(geometry, camera(), settings, seed) {}
};

/// Bit by bit: there are rays with NaN.
bool sameRay(const Ray& a, const Ray& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// Whether the line through the ray passes exactly through \p p, at some t > 0.
bool passesThrough(const Ray& ray, const test::RationalVec& p) {
    using namespace test;
    const RationalVec to = p - rational(ray.origin), d = rational(ray.direction);
    const Rational along = to[0] * d[0] + to[1] * d[1] + to[2] * d[2];
    return to[0] * d[1] == to[1] * d[0] && to[1] * d[2] == to[2] * d[1] &&
           to[2] * d[0] == to[0] * d[2] && along > 0;
}

template <class Predicate>
bool anyTriangle(const FrameGeometry& geometry, Predicate predicate) {
    return std::any_of(geometry.triangles.begin(), geometry.triangles.end(), predicate);
}

bool hitsAVertexExactly(const FrameGeometry& geometry, const Ray& ray) {
    return anyTriangle(geometry, [&](const Triangle& t) {
        return passesThrough(ray, test::rational(t.a)) || passesThrough(ray, test::rational(t.b)) ||
               passesThrough(ray, test::rational(t.c));
    });
}

/// Whether the line meets the segment ab exactly at one inner point.
bool crossesEdge(const Ray& ray, glm::vec3 a, glm::vec3 b) {
    using namespace test;
    const RationalVec o = rational(ray.origin), d = rational(ray.direction);
    const RationalVec e = rational(b) - rational(a), w = rational(a) - o;
    if (determinant(d, e, w) != 0) return false;
    // a + s e = o + t d, from the two coordinates in which that can be solved.
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        const Rational whole = e[i] * d[j] - e[j] * d[i];
        if (whole == 0) continue;
        const Rational s = (w[j] * d[i] - w[i] * d[j]) / whole;
        return s > 0 && s < 1;
    }
    return false;
}

} // namespace

TEST(RayKinds, NamesRoundTrip) {
    for (const RayKind kind : kRayKinds) EXPECT_EQ(rayKindByName(rayKindName(kind)), kind);
    EXPECT_FALSE(rayKindByName("sideways"));
}

TEST(RayKinds, AreFunctionsOfSeedAndIndex) {
    const Fixture one, again, other(ViewMode::full, 1);
    for (const RayKind kind : kRayKinds) {
        if (kind == RayKind::diffuse) continue;
        int same = 0;
        for (uint32_t i = 0; i < 200; i++) {
            // From the back: what was drawn before must not matter.
            const Ray ray = one.source.make(kind, i);
            ASSERT_TRUE(sameRay(again.source.make(kind, 199 - i), one.source.make(kind, 199 - i)));
            ASSERT_TRUE(isTraceable(ray) || kind == RayKind::wild);
            same += sameRay(ray, other.source.make(kind, i)) ||
                    sameRay(ray, one.source.make(kind, i + 1));
        }
        EXPECT_EQ(same, 0) << rayKindName(kind);
    }
}

TEST(RayKinds, PrimaryRaysFillTheImage) {
    const Fixture f;
    const CameraBasis basis = cameraBasis(camera());
    const double tanY = std::tan(camera().verticalFov * std::numbers::pi / 360.0), tanX = 2 * tanY;
    double least = 1, most = -1;
    for (uint32_t i = 0; i < kCount; i++) {
        const Ray ray = f.source.primary(i);
        ASSERT_EQ(ray.origin, glm::vec3(0.0f));
        const glm::dvec3 d(ray.direction);
        const double depth = glm::dot(d, glm::dvec3(basis.forward));
        const double x = glm::dot(d, glm::dvec3(basis.right)) / depth / tanX;
        const double y = glm::dot(d, glm::dvec3(basis.down)) / depth / tanY;
        // Rounding of the direction and of the basis: some 2^-22 of components below 2.
        ASSERT_LE(std::max(std::abs(x), std::abs(y)), 1.0 + 0x1p-20);
        least = std::min(least, x), most = std::max(most, x);
    }
    EXPECT_LT(least, -0.99);
    EXPECT_GT(most, 0.99);
}

TEST(RayKinds, DiffuseRaysLeaveTheSurfaceCosineDistributed) {
    const Fixture f;
    double sum = 0;
    uint32_t count = 0;
    for (uint32_t i = 0; i < kCount; i++) {
        const Ray seeing = f.source.primary(i);
        const Hit hit = closestHitBruteForce(f.geometry, seeing);
        ASSERT_TRUE(hit.found()) << "the room is closed";
        const auto ray = f.source.diffuse(i, hit);
        ASSERT_TRUE(ray);
        ASSERT_EQ(ray->skip, hit.primitive);
        const Triangle& t = f.geometry.triangles[hit.primitive];
        glm::dvec3 n = glm::normalize(
            glm::cross(glm::dvec3(t.b) - glm::dvec3(t.a), glm::dvec3(t.c) - glm::dvec3(t.a)));
        if (glm::dot(n, glm::dvec3(seeing.direction)) > 0) n = -n;
        const double cosine = glm::dot(n, glm::dvec3(ray->direction));
        ASSERT_GE(cosine, -0x1p-22); // a unit direction's rounding
        ASSERT_GE(glm::dot(n, glm::dvec3(ray->origin) - glm::dvec3(t.a)), 0.0);
        sum += cosine;
        count++;
    }
    // The mean of the cosine is 2/3, its standard deviation 1/sqrt(18): five of them.
    EXPECT_NEAR(sum / count, 2.0 / 3.0, 5.0 / std::sqrt(18.0 * count));
}

TEST(RayKinds, EverySecondVertexRayIsExact) {
    const Fixture f;
    for (uint32_t i = 0; i < kCount; i += 2)
        ASSERT_TRUE(hitsAVertexExactly(f.geometry, f.source.vertex(i))) << i;
}

TEST(RayKinds, MostSecondEdgeRaysAreExact) {
    const Fixture f;
    uint32_t exact = 0;
    for (uint32_t i = 0; i < kCount; i += 2) {
        const Ray ray = f.source.edge(i);
        exact += anyTriangle(f.geometry, [&](const Triangle& t) {
            return crossesEdge(ray, t.a, t.b) || crossesEdge(ray, t.b, t.c) ||
                   crossesEdge(ray, t.c, t.a);
        });
    }
    EXPECT_GT(exact, kCount / 4); // of kCount / 2; floats do not allow all
}

TEST(RayKinds, AxisRays) {
    const Fixture f;
    uint32_t directions[3][2] = {};
    bool minusZero = false;
    for (uint32_t i = 0; i < kCount; i++) {
        const Ray ray = f.source.axis(i);
        int axes = 0;
        for (int k = 0; k < 3; k++) {
            if (ray.direction[k] == 0.0f) {
                minusZero |= std::signbit(ray.direction[k]);
                continue;
            }
            ASSERT_EQ(std::abs(ray.direction[k]), 1.0f);
            axes++;
            directions[k][ray.direction[k] > 0]++;
        }
        ASSERT_EQ(axes, 1);
        if (i % 4 != 2) continue;
        const Ray back{ray.origin, -ray.direction, kNoPrimitive};
        ASSERT_TRUE(hitsAVertexExactly(f.geometry, ray) || hitsAVertexExactly(f.geometry, back));
    }
    EXPECT_TRUE(minusZero);
    for (const auto& axis : directions)
        for (const uint32_t count : axis) EXPECT_GT(count, kCount / 12);
}

TEST(RayKinds, GrazingRaysLieWithinTheAngle) {
    const Fixture f;
    uint32_t nearPlane = 0;
    for (uint32_t i = 0; i < kCount; i++) {
        const Ray ray = f.source.grazing(i);
        const glm::dvec3 d = glm::normalize(glm::dvec3(ray.direction));
        double smallest = 1.0;
        for (const Triangle& t : f.geometry.triangles) {
            const glm::dvec3 n = glm::normalize(
                glm::cross(glm::dvec3(t.b) - glm::dvec3(t.a), glm::dvec3(t.c) - glm::dvec3(t.a)));
            smallest = std::min(smallest, std::abs(glm::dot(n, d)));
        }
        ASSERT_LE(smallest, std::sin(1e-4)) << i;
        nearPlane += smallest < 1e-6;
    }
    EXPECT_GT(nearPlane, kCount / 10) << "angles should span magnitudes";
}

TEST(RayKinds, MostPlaneRaysLieInAPlaneExactly) {
    const Fixture f;
    using namespace test;
    uint32_t exact = 0;
    for (uint32_t i = 0; i < kCount; i++) {
        const Ray ray = f.source.plane(i);
        const test::RationalVec o = test::rational(ray.origin), d = test::rational(ray.direction);
        exact += anyTriangle(f.geometry, [&](const Triangle& t) {
            const auto a = test::rational(t.a);
            const auto b = test::rational(t.b) - a, c = test::rational(t.c) - a;
            return test::determinant(o - a, b, c) == 0 && test::determinant(d, b, c) == 0;
        });
    }
    EXPECT_GT(exact, kCount * 9 / 10);
}

TEST(RayKinds, BorderRaysLieOnBordersExactly) {
    for (const ViewMode mode : {ViewMode::full, ViewMode::single}) {
        const Fixture f(mode);
        const std::vector<View> views = makeViews(f.settings, camera());
        const auto onBorder = [&](glm::vec3 p) {
            return std::any_of(views.begin(), views.end(), [&](const View& view) {
                const glm::dvec3 v(view.toView(p));
                const auto holds = [&](const std::vector<float>& borders, double x) {
                    return std::any_of(borders.begin(), borders.end(),
                                       [&](float slope) { return x == slope * v.z; });
                };
                return holds(view.s, v.x) || holds(view.t, v.y);
            });
        };
        for (uint32_t i = 0; i < kCount; i++) {
            const Ray ray = f.source.border(i);
            if (i % 4 == 3) continue;
            ASSERT_TRUE(onBorder(ray.origin)) << i;
            ASSERT_TRUE(i % 4 == 2 || onBorder(ray.direction)) << i;
            if (i % 4 != 1) continue;
            ASSERT_EQ(glm::cross(glm::dvec3(ray.origin), glm::dvec3(ray.direction)),
                      glm::dvec3(0.0));
        }
    }
}

TEST(RayKinds, WildRaysSpanWhatFloatsHold) {
    const Fixture f;
    uint32_t untraceable = 0, minusZero = 0, denormals = 0;
    float least = FLT_MAX, most = 0.0f;
    for (uint32_t i = 0; i < kCount; i++) {
        const Ray ray = f.source.wild(i);
        untraceable += !isTraceable(ray);
        for (int k = 0; k < 3; k++) {
            const float d = ray.direction[k];
            minusZero += d == 0.0f && std::signbit(d);
            denormals += d != 0.0f && std::abs(d) < FLT_MIN;
        }
        if (i % 8 >= 5) continue;
        const float length = std::max(
            {std::abs(ray.direction.x), std::abs(ray.direction.y), std::abs(ray.direction.z)});
        least = std::min(least, length), most = std::max(most, length);
    }
    EXPECT_EQ(untraceable, kCount / 8);
    EXPECT_GT(minusZero, kCount / 100);
    EXPECT_GE(denormals, kCount / 8 * 4);
    EXPECT_LT(least, 1e-37f);
    EXPECT_GT(most, 1e37f);
}

TEST(RayKinds, HalfAreAimedAtTheFocus) {
    const Fixture f;
    const RaySource source(f.geometry, camera(), f.settings, 0, {5});
    const Triangle& focus = f.geometry.triangles[5];
    const auto aimed = [&](const RaySource& rays) {
        uint32_t count = 0;
        for (uint32_t i = 0; i < kCount; i += 2) {
            const Ray ray = rays.vertex(i);
            count += passesThrough(ray, test::rational(focus.a)) ||
                     passesThrough(ray, test::rational(focus.b)) ||
                     passesThrough(ray, test::rational(focus.c));
        }
        return count;
    };
    EXPECT_LT(aimed(f.source), kCount / 4);
    EXPECT_GT(aimed(source), kCount / 4);
}

TEST(RayKinds, InSingleViewOriginsAndTargetsLieInside) {
    const Fixture f(ViewMode::single);
    const View view = makeViews(f.settings, camera())[0];
    const auto inside = [&](glm::vec3 p) {
        const double x = p.x, y = p.y, w = p.z;
        return x >= view.s.front() * w && x <= view.s.back() * w && y >= view.t.front() * w &&
               y <= view.t.back() * w;
    };
    for (const RayKind kind :
         {RayKind::primary, RayKind::vertex, RayKind::edge, RayKind::axis, RayKind::grazing}) {
        uint32_t count = 0;
        for (uint32_t i = 0; i < kCount; i++) {
            const Ray ray = f.source.make(kind, i);
            count += inside(ray.origin);
            count -= kind == RayKind::primary && !inside(ray.direction);
        }
        EXPECT_EQ(count, kCount) << rayKindName(kind);
    }
}
