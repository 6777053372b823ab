#ifdef DIRT_HAVE_EMBREE

#include "backend_embree/embree_backend.h"
#include "core/trace/intersect.h"
#include "core/trace/traverse.h"

#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>

using namespace dirt;

namespace {

std::mt19937 random_(7);

glm::vec3 randomPoint() {
    std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
    return {uniform(random_), uniform(random_), uniform(random_)};
}

/// Small triangles all over a box, each third one there twice with its vertices turned.
FrameGeometry soupWithCopies(int count) {
    FrameGeometry geometry;
    for (int i = 0; i < count; i++) {
        const glm::vec3 a = randomPoint();
        const Triangle t{a, a + randomPoint() * 0.3f, a + randomPoint() * 0.3f};
        geometry.triangles.push_back(t);
        if (i % 3 == 0) geometry.triangles.push_back({t.b, t.c, t.a});
    }
    return geometry;
}

std::vector<Ray> randomRays(int count) {
    std::vector<Ray> rays;
    for (int i = 0; i < count; i++) rays.push_back({randomPoint(), randomPoint(), kNoPrimitive});
    return rays;
}

bool sameHit(const Hit& a, const Hit& b) {
    return a.primitive == b.primitive && a.t == b.t && a.u == b.u && a.v == b.v;
}

class EmbreeBackendTest : public testing::TestWithParam<bool> {
protected:
    SerialExecutor serial_;
    EmbreeBackend backend_{serial_, GetParam()};

    std::vector<Hit> trace(const FrameGeometry& geometry, const std::vector<Ray>& rays) {
        backend_.build(geometry, Camera{}, GridSettings{});
        std::vector<Hit> hits(rays.size());
        backend_.intersect(rays, hits);
        return hits;
    }
};

} // namespace

TEST_P(EmbreeBackendTest, EqualsBruteForceOnOrdinaryRays) {
    const FrameGeometry geometry = soupWithCopies(300);
    const std::vector<Ray> rays = randomRays(4000);
    const std::vector<Hit> hits = trace(geometry, rays);
    int found = 0, onCopies = 0;
    for (size_t i = 0; i < rays.size(); i++) {
        const Hit expected = closestHitBruteForce(geometry, rays[i]);
        ASSERT_TRUE(sameHit(hits[i], expected)) << "ray " << i;
        found += expected.found();
        onCopies += expected.found() && expected.primitive % 4 == 0;
    }
    EXPECT_GT(found, 1000);
    EXPECT_GT(onCopies, 100) << "ties were not exercised";
}

TEST_P(EmbreeBackendTest, SkipsTheOriginsTriangleAndItsCopies) {
    const FrameGeometry geometry = soupWithCopies(300);
    std::vector<Ray> rays = randomRays(4000);
    const std::vector<Hit> first = trace(geometry, rays);
    for (size_t i = 0; i < rays.size(); i++) rays[i].skip = first[i].primitive;
    const std::vector<Hit> second = trace(geometry, rays);
    for (size_t i = 0; i < rays.size(); i++) {
        ASSERT_TRUE(sameHit(second[i], closestHitBruteForce(geometry, rays[i]))) << "ray " << i;
        if (!first[i].found() || !second[i].found()) continue;
        ASSERT_GT(second[i].t, first[i].t);
    }
}

TEST_P(EmbreeBackendTest, LowestIdAmongManyCopies) {
    // More copies than one leaf holds; the lowest id must win wherever the tree puts it.
    FrameGeometry geometry;
    const Triangle wall{{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}};
    for (int i = 0; i < 50; i++) {
        geometry.triangles.push_back({wall.a + glm::vec3(0, 0, 1), wall.b, wall.c});
        geometry.triangles.push_back(i % 2 ? wall : Triangle{wall.c, wall.a, wall.b});
    }
    const std::vector<Hit> hits = trace(geometry, {{{0, 0, 0}, {0, 0, 1}, kNoPrimitive}});
    EXPECT_EQ(hits[0].primitive, 1u);
    EXPECT_EQ(hits[0].t, 1.0f);
}

TEST_P(EmbreeBackendTest, OccludedMeansAHitBelowMaxT) {
    const FrameGeometry geometry = soupWithCopies(300);
    const std::vector<Ray> rays = randomRays(2000);
    const std::vector<Hit> hits = trace(geometry, rays);
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float factor : {0.5f, 1.0f, 1.0f + 0x1p-22f, 2.0f, infinity}) {
        std::vector<float> maxT;
        std::vector<uint8_t> result(rays.size());
        for (const Hit& hit : hits) maxT.push_back(hit.found() ? hit.t * factor : infinity);
        backend_.occluded(rays, maxT, result);
        for (size_t i = 0; i < rays.size(); i++)
            ASSERT_EQ(result[i] == 1, hits[i].found() && hits[i].t < maxT[i]) << factor;
    }
}

TEST_P(EmbreeBackendTest, NaNAndInfinityHitNothing) {
    const FrameGeometry geometry = soupWithCopies(300);
    std::vector<Ray> rays;
    for (const float bad : {NAN, INFINITY, -INFINITY}) {
        for (int i = 0; i < 3; i++) {
            rays.push_back({randomPoint(), randomPoint(), kNoPrimitive});
            rays.back().origin[i] = bad;
            rays.push_back({randomPoint(), randomPoint(), kNoPrimitive});
            rays.back().direction[i] = bad;
        }
    }
    rays.push_back({randomPoint(), glm::vec3(0.0f), kNoPrimitive});
    for (const Hit& hit : trace(geometry, rays)) EXPECT_FALSE(hit.found());
    std::vector<uint8_t> result(rays.size(), 2);
    backend_.occluded(rays, std::vector<float>(rays.size(), 10.0f), result);
    for (const uint8_t r : result) EXPECT_EQ(r, 0);
}

/// Embree itself ends the program at numbers above 1.8e18, and loses directions below 1e-18.
TEST_P(EmbreeBackendTest, DirectionsOfAnyLength) {
    const FrameGeometry geometry = soupWithCopies(300);
    const std::vector<Ray> rays = randomRays(500);
    const std::vector<Hit> hits = trace(geometry, rays);
    for (const int exponent : {-100, -60, 61, 64, 100, 126}) {
        std::vector<Ray> scaled = rays;
        std::vector<float> maxT;
        for (size_t i = 0; i < rays.size(); i++) {
            for (int k = 0; k < 3; k++)
                scaled[i].direction[k] = std::ldexp(rays[i].direction[k], exponent);
            maxT.push_back(hits[i].found() ? std::ldexp(hits[i].t, -exponent) * 1.01f : 1e30f);
        }
        const std::vector<Hit> found = trace(geometry, scaled);
        std::vector<uint8_t> occluded(rays.size());
        backend_.occluded(scaled, maxT, occluded);
        for (size_t i = 0; i < rays.size(); i++) {
            const float t = std::ldexp(hits[i].t, -exponent);
            if (hits[i].found() && !(std::abs(t) > 1e-37f)) continue; // below float's range
            ASSERT_EQ(found[i].primitive, hits[i].primitive) << exponent;
            ASSERT_EQ(found[i].t, hits[i].found() ? t : 0.0f) << exponent;
            ASSERT_EQ(occluded[i] != 0, hits[i].found()) << exponent;
        }
    }
    std::vector<Ray> far = rays;
    for (Ray& ray : far) ray.origin.x = 1e30f;
    for (const Hit& hit : trace(geometry, far)) EXPECT_FALSE(hit.found());
}

TEST_P(EmbreeBackendTest, RebuildsAndTellsItsMemory) {
    const FrameGeometry big = soupWithCopies(20000), small = soupWithCopies(10);
    const auto bytes = [&] {
        for (const BufferSize& buffer : backend_.memory())
            if (buffer.name == "embree scene") return buffer.bytes;
        return uint64_t(0);
    };
    backend_.build(big, Camera{}, GridSettings{});
    const uint64_t bigBytes = bytes();
    EXPECT_GT(bigBytes, big.triangles.size() * sizeof(Triangle));
    backend_.build(small, Camera{}, GridSettings{});
    EXPECT_LT(bytes(), bigBytes / 2) << "the old scene is gone";
    EXPECT_EQ(backend_.device().rfind("Embree 3.", 0), 0u);
}

INSTANTIATE_TEST_SUITE_P(Flags, EmbreeBackendTest, testing::Bool(),
                         [](const auto& info) { return info.param ? "Robust" : "Default"; });

TEST(EmbreePlain, AgreesWithCoreAwayFromBorders) {
    SerialExecutor serial;
    const FrameGeometry geometry = soupWithCopies(300);
    const std::vector<Ray> rays = randomRays(4000);
    EmbreeBackend plain(serial, false, EmbreeDecision::plain);
    plain.build(geometry, Camera{}, GridSettings{});
    std::vector<Hit> hits(rays.size());
    plain.intersect(rays, hits);
    for (size_t i = 0; i < rays.size(); i++) {
        const Hit expected = closestHitBruteForce(geometry, rays[i]);
        ASSERT_EQ(hits[i].found(), expected.found());
        if (hits[i].found() && hits[i].primitive != expected.primitive) {
            // Any copy may win.
            ASSERT_TRUE(sameVertices(geometry.triangles[hits[i].primitive],
                                     geometry.triangles[expected.primitive]));
        }
    }
}

#endif
