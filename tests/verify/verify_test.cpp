#include "backend_cpu/thread_pool.h"
#include "core/trace/traverse.h"
#include "core/verify/verify.h"
#include "tests/verify/sphere.h"

#include <algorithm>

#include <gtest/gtest.h>

using namespace dirt;

namespace {

/// Tests every triangle; and, where asked to, does something wrong.
class BruteForce : public Tracer {
public:
    using Tamper = void (*)(size_t ray, Hit& hit);
    explicit BruteForce(Tamper tamper = nullptr) : tamper_(tamper) {}

    std::string name() const override { return "brute force"; }
    std::string device() const override { return ""; }
    std::vector<PassTime> build(const FrameGeometry& geometry, const Camera&,
                                const GridSettings&) override {
        geometry_ = &geometry;
        return {};
    }
    void intersect(std::span<const Ray> rays, std::span<Hit> hits) override {
        for (size_t i = 0; i < rays.size(); i++) {
            hits[i] = closestHitBruteForce(*geometry_, rays[i]);
            if (tamper_) tamper_(i, hits[i]);
        }
    }
    void occluded(std::span<const Ray>, std::span<const float>, std::span<uint8_t>) override {}

protected:
    const FrameGeometry* geometry_ = nullptr;

private:
    Tamper tamper_;
};

constexpr uint32_t kLost = 100;

/// Loses every kLost-th triangle of the scene.
class Dropping final : public BruteForce {
public:
    std::vector<PassTime> build(const FrameGeometry& geometry, const Camera& camera,
                                const GridSettings& settings) override {
        kept_ = geometry;
        for (size_t i = 0; i < kept_.triangles.size(); i += kLost) kept_.triangles[i] = {};
        return BruteForce::build(kept_, camera, settings);
    }

private:
    FrameGeometry kept_;
};

constexpr uint32_t kRaysOfKind = 2000;

class VerifierTest : public testing::Test {
protected:
    // Seen from inside: every ray from inside hits, and only once.
    Camera camera_{.eye = {0.2f, 0.1f, -0.3f}, .target = {1.0f, 0.3f, 0.2f}, .verticalFov = 120.0f};
    GridSettings grid_;
    FrameGeometry geometry_ =
        makeFrameGeometry(test::sphere(40, 20, 2.0, glm::dvec3(0.0)), camera_, ViewMode::full);
    SerialExecutor serial_;
    BruteForce sound_;
    VerifySettings settings_{.rays = kRaysOfKind, .agreeing = 100};

    KindReport run(RayKind kind, std::vector<Tracer*> backends) {
        return run(kind, backends, serial_);
    }
    KindReport run(RayKind kind, std::vector<Tracer*> backends, Executor& executor) {
        for (Tracer* backend : backends) backend->build(geometry_, camera_, grid_);
        return Verifier(geometry_, camera_, grid_, backends, settings_, executor).run(kind);
    }

    /// The rays of a kind and what they hit.
    std::vector<Hit> truth(RayKind kind) {
        const RaySource source(geometry_, camera_, grid_, settings_.seed);
        std::vector<Hit> hits;
        for (uint32_t i = 0; i < kRaysOfKind; i++)
            hits.push_back(closestHitBruteForce(geometry_, source.make(kind, i)));
        return hits;
    }
};

} // namespace

TEST_F(VerifierTest, FindsNothingWrongWithASoundBackend) {
    for (const RayKind kind : kRayKinds) {
        const KindReport report = run(kind, {&sound_});
        EXPECT_EQ(report.rays, kRaysOfKind) << rayKindName(kind);
        EXPECT_EQ(report.outside, 0u);
        EXPECT_EQ(report.disagreed, 0u);
        EXPECT_EQ(report.agreed, settings_.agreeing);
        EXPECT_EQ(report.backends[0].errors(), 0u);
        EXPECT_LE(report.backends[0].maxRelativeTError, 0x1p-23);
        EXPECT_GT(report.backends[0].maxRelativeTError, 0.0);
        EXPECT_TRUE(report.wrong.empty());
    }
}

TEST_F(VerifierTest, CountsEveryRayThatALostTriangleCosts) {
    Dropping dropping;
    const std::vector<Hit> hits = truth(RayKind::primary);
    const auto lost = std::count_if(hits.begin(), hits.end(), [](const Hit& hit) {
        return hit.found() && hit.primitive % kLost == 0;
    });
    ASSERT_GT(lost, 0) << "no ray meets a lost triangle: the test would prove nothing";
    const KindReport report = run(RayKind::primary, {&dropping, &sound_});
    EXPECT_EQ(report.backends[0].missed, (uint64_t) lost);
    EXPECT_EQ(report.backends[0].falseHits, 0u);
    EXPECT_EQ(report.backends[0].wrongPrimitive, 0u);
    EXPECT_EQ(report.backends[1].errors(), 0u);
    EXPECT_EQ(report.disagreed, (uint64_t) lost);
    ASSERT_EQ(report.wrong.size(), std::min<size_t>((size_t) lost, settings_.shownWrongAnswers));
    const WrongAnswer& first = report.wrong[0];
    EXPECT_EQ(first.grade, Grade::missed);
    EXPECT_EQ(first.truth.primitives[0] % kLost, 0u);
    EXPECT_EQ(hits[first.index].primitive, first.truth.primitives[0]);
}

TEST_F(VerifierTest, CountsEveryNeighbourGivenInstead) {
    BruteForce neighbour([](size_t ray, Hit& hit) {
        if (ray % 7 == 0 && hit.found()) hit.primitive ^= 1;
    });
    const std::vector<Hit> hits = truth(RayKind::primary);
    uint64_t wrong = 0;
    for (size_t i = 0; i < hits.size(); i += 7) wrong += hits[i].found();
    const KindReport report = run(RayKind::primary, {&neighbour, &sound_});
    EXPECT_EQ(report.backends[0].wrongPrimitive, wrong);
    EXPECT_EQ(report.backends[0].errors(), wrong);
    EXPECT_EQ(report.backends[1].errors(), 0u);
}

TEST_F(VerifierTest, CountsEveryHitWhereThereIsNone) {
    BruteForce eager([](size_t, Hit& hit) {
        if (!hit.found()) hit = Hit{.primitive = 5, .t = 1.0f};
    });
    const std::vector<Hit> hits = truth(RayKind::axis); // half of them start outside
    const auto misses =
        std::count_if(hits.begin(), hits.end(), [](const Hit& hit) { return !hit.found(); });
    ASSERT_GT(misses, 0);
    const KindReport report = run(RayKind::axis, {&sound_, &eager});
    EXPECT_EQ(report.backends[0].errors(), 0u);
    EXPECT_EQ(report.backends[1].falseHits, (uint64_t) misses);
    EXPECT_EQ(report.backends[1].errors(), (uint64_t) misses);
}

TEST_F(VerifierTest, JudgesAgreementToo) {
    // Both lose the same triangles: only the sample of agreeing rays can tell.
    Dropping one, two;
    settings_.agreeing = kRaysOfKind;
    const std::vector<Hit> hits = truth(RayKind::primary);
    const auto lost = std::count_if(hits.begin(), hits.end(), [](const Hit& hit) {
        return hit.found() && hit.primitive % kLost == 0;
    });
    const KindReport report = run(RayKind::primary, {&one, &two});
    EXPECT_EQ(report.disagreed, 0u);
    EXPECT_EQ(report.agreed, kRaysOfKind);
    EXPECT_EQ(report.backends[0].missed, (uint64_t) lost);
    EXPECT_EQ(report.backends[1].missed, (uint64_t) lost);
}

TEST_F(VerifierTest, CatchesAWrongT) {
    BruteForce drifting([](size_t, Hit& hit) { hit.t *= 1.0f + 0x1p-20f; });
    const KindReport report = run(RayKind::primary, {&drifting});
    EXPECT_GT(report.backends[0].maxRelativeTError, 0x1p-21);
    EXPECT_LT(report.backends[0].maxRelativeTError, 0x1p-19);
}

TEST_F(VerifierTest, SameReportOnAnyNumberOfThreads) {
    Dropping dropping;
    ThreadPool pool(3);
    const KindReport serial = run(RayKind::diffuse, {&dropping, &sound_});
    const KindReport parallel = run(RayKind::diffuse, {&dropping, &sound_}, pool);
    EXPECT_EQ(serial.rays, parallel.rays);
    EXPECT_EQ(serial.disagreed, parallel.disagreed);
    EXPECT_EQ(serial.backends[0].errors(), parallel.backends[0].errors());
    EXPECT_EQ(serial.backends[0].maxRelativeTError, parallel.backends[0].maxRelativeTError);
    ASSERT_EQ(serial.wrong.size(), parallel.wrong.size());
    for (size_t i = 0; i < serial.wrong.size(); i++)
        EXPECT_EQ(serial.wrong[i].index, parallel.wrong[i].index);
}

TEST_F(VerifierTest, ACameraThatSeesNothingGivesNoDiffuseRays) {
    camera_.eye = {10, 0, 0}, camera_.target = {20, 0, 0};
    geometry_ =
        makeFrameGeometry(test::sphere(8, 4, 2.0, glm::dvec3(0.0)), camera_, ViewMode::full);
    settings_.rays = 100;
    EXPECT_EQ(run(RayKind::diffuse, {&sound_}).rays, 0u);
}

TEST_F(VerifierTest, InSingleViewHitsOutsideDoNotCount) {
    // As the grid in single view must: nothing beyond the view's borders.
    class OnlyTheView final : public BruteForce {
    public:
        View view;
        void intersect(std::span<const Ray> rays, std::span<Hit> hits) override {
            BruteForce::intersect(rays, hits);
            for (size_t i = 0; i < rays.size(); i++) {
                const glm::vec3 p = rays[i].origin + rays[i].direction * hits[i].t;
                // By a hair too little is caught, so leave a hair too much.
                const float hair = 1e-5f;
                if (p.x < view.s.front() * p.z - hair || p.x > view.s.back() * p.z + hair ||
                    p.y < view.t.front() * p.z - hair || p.y > view.t.back() * p.z + hair)
                    hits[i] = {};
            }
        }
    } clipped;
    grid_.mode = ViewMode::single;
    geometry_ =
        makeFrameGeometry(test::sphere(40, 20, 2.0, glm::dvec3(0.0)), camera_, ViewMode::single);
    clipped.view = makeViews(grid_, camera_)[0];
    for (const RayKind kind : kRayKinds) {
        const KindReport report = run(kind, {&clipped, &sound_});
        EXPECT_EQ(report.backends[0].errors(), 0u) << rayKindName(kind);
        EXPECT_EQ(report.rays + report.outside, kRaysOfKind);
        EXPECT_GT(report.rays, kRaysOfKind / 10) << rayKindName(kind);
        EXPECT_LE(report.outside, report.disagreed + report.agreed);
        if (kind == RayKind::primary) {
            EXPECT_EQ(report.outside, 0u);
        }
        if (kind == RayKind::diffuse) {
            EXPECT_GT(report.outside, 0u);
        }
    }
}
