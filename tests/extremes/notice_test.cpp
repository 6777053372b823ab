// That `verify --extremes` counts what is wrong: backends with one fault each.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/frame/forwarding_backend.h"
#include "core/verify/verify_extremes.h"
#include "tests/extremes/small_scene.h"

#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

namespace dirt {
namespace {

/// Right but for what is changed afterwards.
class Spoilt final : public ForwardingBackend {
public:
    using ForwardingBackend::ForwardingBackend;

    std::function<void(Hit&)> spoilHit;
    std::function<void(uint8_t&)> spoilOccluded;
    std::function<void(std::vector<glm::vec3>&)> spoilImage;

    void intersect(std::span<const Ray> rays, std::span<Hit> hits) override {
        inner_.intersect(rays, hits);
        if (spoilHit)
            for (Hit& hit : hits) spoilHit(hit);
    }
    void occluded(std::span<const Ray> rays, std::span<const float> maxT,
                  std::span<uint8_t> result) override {
        inner_.occluded(rays, maxT, result);
        if (spoilOccluded)
            for (uint8_t& occluded : result) spoilOccluded(occluded);
    }
    std::vector<glm::vec3> readImage() const override {
        std::vector<glm::vec3> image = inner_.readImage();
        if (spoilImage) spoilImage(image);
        return image;
    }
};

class NoticesFaults : public testing::Test {
protected:
    ThreadPool pool_;
    CpuBackend cpu_{pool_};
    Spoilt spoilt_{cpu_};
    int calls_ = 0;

    ExtremeReport run(std::string_view name) {
        VerifySettings verify;
        verify.rays = 100;
        ExtremeVerifier verifier(test::smallScene(), test::smallSettings(), {&spoilt_}, verify,
                                 pool_);
        ExtremeReport report = verifier.run(*extremeByName(name));
        EXPECT_EQ(report.leftOut, "");
        return report;
    }
    ExtremeBackendReport counts(std::string_view name) { return run(name).backends[0]; }
};

TEST_F(NoticesFaults, NothingWhereThereIsNone) {
    for (const char* name : {"scale-1e6", "box-shared", "ball"})
        EXPECT_TRUE(counts(name).right()) << name;
}

TEST_F(NoticesFaults, OfALostHit) {
    spoilt_.spoilHit = [&](Hit& hit) {
        if (++calls_ % 50 == 0) hit = {};
    };
    const ExtremeReport report = run("moved-1e3");
    EXPECT_GT(report.backends[0].rays.missed, 0u);
    EXPECT_FALSE(report.backends[0].right());
    EXPECT_FALSE(report.wrong.empty());
}

TEST_F(NoticesFaults, OfATriangleThatIsNotHit) {
    spoilt_.spoilHit = [&](Hit& hit) {
        if (hit.found()) hit.primitive ^= 1;
    };
    EXPECT_GT(counts("slivers").rays.wrongPrimitive, 0u);
}

TEST_F(NoticesFaults, OfOneUlpOfT) {
    spoilt_.spoilHit = [&](Hit& hit) { hit.t = std::nextafter(hit.t, 1e30f); };
    const ExtremeBackendReport report = counts("near-1e-8");
    // One ulp and the rounding; both twice as much from a power of two upwards.
    EXPECT_GT(report.rays.maxUlpTError, 1.0);
    EXPECT_LT(report.rays.maxUlpTError, 3.0);
    EXPECT_EQ(report.rays.errors(), 0u);
    EXPECT_FALSE(report.right());
}

TEST_F(NoticesFaults, OfAnyHits) {
    spoilt_.spoilOccluded = [&](uint8_t& occluded) { occluded ^= ++calls_ % 20 == 0; };
    const ExtremeReport report = run("far-1e8");
    const BackendReport& rays = report.backends[0].rays;
    EXPECT_GT(rays.missed, 0u);
    EXPECT_GT(rays.falseHits, 0u);
    ASSERT_FALSE(report.wrong.empty());
    EXPECT_TRUE(report.wrong[0].maxT);
}

TEST_F(NoticesFaults, OfNonFinitePixels) {
    spoilt_.spoilImage = [](std::vector<glm::vec3>& image) {
        image[5].y = std::numeric_limits<float>::quiet_NaN();
        image[7].z = std::numeric_limits<float>::infinity();
    };
    const ExtremeBackendReport report = counts("covering");
    EXPECT_EQ(report.nonFinitePixels, 2u);
    EXPECT_FALSE(report.right());
}

TEST_F(NoticesFaults, OfLightThatLeaks) {
    for (const char* name : {"box-shared", "box-unshared-moved-1e5"}) {
        spoilt_.spoilOccluded = {}, spoilt_.spoilHit = {}, spoilt_.spoilImage = {};
        EXPECT_EQ(counts(name).leaks, 0u);
        spoilt_.spoilImage = [](std::vector<glm::vec3>& image) { image[3].x = 1e-30f; };
        EXPECT_EQ(counts(name).leaks, 1u) << name;
        spoilt_.spoilImage = {};
        spoilt_.spoilOccluded = [](uint8_t& occluded) { occluded = 0; };
        EXPECT_GE(*counts(name).leaks, 90u) << name;
        spoilt_.spoilOccluded = {};
        spoilt_.spoilHit = [](Hit& hit) { hit = {}; };
        EXPECT_GE(*counts(name).leaks, 90u) << name;
    }
}

TEST_F(NoticesFaults, OfSelfShadows) {
    spoilt_.spoilOccluded = [](uint8_t& occluded) { occluded = 1; };
    EXPECT_GE(*counts("ball").selfShadows, 80u);
    spoilt_.spoilOccluded = {};
    spoilt_.spoilHit = [](Hit& hit) { hit.primitive = 0; };
    EXPECT_GE(*counts("ball-moved-1e5").selfShadows, 80u);
}

/// What it is for: rays that start where they are, without the offset and without their own
/// triangle left out.
TEST_F(NoticesFaults, OfRaysThatHitTheirOwnTriangle) {
    struct NoSkip final : ForwardingBackend {
        using ForwardingBackend::ForwardingBackend;
        void occluded(std::span<const Ray> rays, std::span<const float> maxT,
                      std::span<uint8_t> result) override {
            std::vector<Ray> bare(rays.begin(), rays.end());
            for (Ray& ray : bare) ray.origin -= 1e-5f * ray.direction, ray.skip = kNoPrimitive;
            inner_.occluded(bare, maxT, result);
        }
    } noSkip(cpu_);
    VerifySettings verify;
    verify.rays = 100;
    ExtremeVerifier verifier(test::smallScene(), test::smallSettings(), {&noSkip}, verify, pool_);
    EXPECT_GT(verifier.run(*extremeByName("ball")).backends[0].selfShadows, 10u);
}

} // namespace
} // namespace dirt
