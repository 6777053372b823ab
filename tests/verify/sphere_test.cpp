// How watertight hits are, measured on a sphere of 400 x 200 quads, radius 2, with rays from inside
// it. Every ray hits something: an answer "none" is a miss.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/verify/random.h"
#include "core/verify/verify.h"
#include "tests/support/random.h"
#include "tests/verify/sphere.h"

#ifdef DIRT_HAVE_EMBREE
#include "backend_embree/embree_backend.h"
#endif

#include <algorithm>
#include <iostream>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

using namespace dirt;

namespace {

const uint32_t kRays = (uint32_t) test::cases(100'000, 1'000'000);

enum class Aim { anywhere, edge, vertex };
constexpr const char* kAimNames[] = {"random", "edge-aimed", "vertex-aimed"};

class Sphere : public testing::TestWithParam<glm::dvec3> {
protected:
    ThreadPool pool_;
    GridSettings settings_;
    Camera camera_;
    FrameGeometry geometry_;
    CpuBackend cpu_{pool_};

    void SetUp() override {
        const glm::dvec3 centre = GetParam();
        camera_.eye = glm::vec3(centre + glm::dvec3(0.3, -0.2, 0.5));
        camera_.target = glm::vec3(centre + glm::dvec3(1.3, 0.1, -0.4));
        geometry_ = makeFrameGeometry(test::sphere(400, 200, 2.0, centre), camera_, ViewMode::full);
        cpu_.build(geometry_, camera_, settings_);
    }

    /// From a random point of the ball of radius 1.5 (grid frame) around the centre.
    Ray ray(Aim aim, uint32_t index) const {
        RayRandom random(0, (uint32_t) aim, index);
        const auto uniform = [&] { return 2.0 * random.uniform() - 1.0; };
        glm::dvec3 inBall;
        do {
            inBall = {uniform(), uniform(), uniform()};
        } while (glm::dot(inBall, inBall) > 1.0);
        const glm::dvec3 centre = GetParam() - glm::dvec3(camera_.eye);
        const double scale = geometry_.frame.scale;
        const glm::vec3 origin((centre + 1.5 * inBall) * scale);
        const Triangle& t = geometry_.triangles[random.below(geometry_.triangles.size())];
        const double along = random.uniform();
        switch (aim) {
        case Aim::anywhere:
            return {origin, {uniform(), uniform(), uniform()}, kNoPrimitive};
        case Aim::edge:
            return {origin, glm::vec3(glm::mix(glm::dvec3(t.a), glm::dvec3(t.b), along)) - origin,
                    kNoPrimitive};
        case Aim::vertex:
            break;
        }
        return {origin, t.a - origin, kNoPrimitive};
    }

    static size_t misses(Tracer& tracer, const std::vector<Ray>& rays) {
        std::vector<Hit> hits(rays.size());
        tracer.intersect(rays, hits);
        return (size_t) std::count_if(hits.begin(), hits.end(),
                                      [](const Hit& hit) { return !hit.found(); });
    }
};

} // namespace

TEST_P(Sphere, NoRayLeavesIt) {
#ifdef DIRT_HAVE_EMBREE
    EmbreeBackend embree(pool_, false, EmbreeDecision::plain);
    EmbreeBackend robust(pool_, true, EmbreeDecision::plain);
    embree.build(geometry_, camera_, settings_);
    robust.build(geometry_, camera_, settings_);
#endif
    for (const Aim aim : {Aim::anywhere, Aim::edge, Aim::vertex}) {
        std::vector<Ray> rays;
        for (uint32_t i = 0; i < kRays; i++) rays.push_back(ray(aim, i));
        const size_t ours = misses(cpu_, rays);
        EXPECT_EQ(ours, 0u) << kAimNames[(int) aim];
        std::cout << kAimNames[(int) aim] << " rays " << kRays << ", missed: dirt " << ours;
#ifdef DIRT_HAVE_EMBREE
        std::cout << ", Embree " << misses(embree, rays) << ", Embree robust "
                  << misses(robust, rays);
#endif
        std::cout << std::endl;
    }
}

TEST_P(Sphere, EveryHitIsTheRightOne) {
    VerifySettings verify;
    verify.rays = kRays;
    std::vector<Tracer*> backends{&cpu_};
#ifdef DIRT_HAVE_EMBREE
    EmbreeBackend embree(pool_, true, EmbreeDecision::plain);
    embree.build(geometry_, camera_, settings_);
    backends.push_back(&embree);
#endif
    Verifier verifier(geometry_, camera_, settings_, backends, verify, pool_);
    for (const RayKind kind : {RayKind::vertex, RayKind::edge}) {
        const KindReport report = verifier.run(kind);
        EXPECT_EQ(report.backends[0].errors(), 0u) << rayKindName(kind);
        EXPECT_LE(report.backends[0].maxRelativeTError, 0x1p-23) << rayKindName(kind);
        EXPECT_EQ(report.rays, kRays);
    }
}

INSTANTIATE_TEST_SUITE_P(Centres, Sphere,
                         testing::Values(glm::dvec3(0.0), glm::dvec3(148376, 1234, -223423)),
                         [](const auto& info) { return info.index == 0 ? "Origin" : "FarAway"; });
