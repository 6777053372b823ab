// Every variant of `verify --extremes`: all rays right, nothing leaks, no body shadows itself, no
// pixel is infinite. The short form takes a small scene; the long form the real ones, both views,
// and OpenGL.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/verify/verify_extremes.h"
#include "tests/extremes/small_scene.h"
#include "tests/support/random.h"
#include "tests/verify/places.h"

#ifdef DIRT_HAVE_EMBREE
#include "backend_embree/embree_backend.h"
#endif
#ifdef DIRT_HAVE_GL
#include "backend_gl/gl_backend.h"
#endif

#include <iostream>
#include <memory>

#include <gtest/gtest.h>

namespace dirt {
namespace {

/// "again: …" for a scene of the tests, which has no file.
std::string describe(const ExtremeReport& report, const std::string& scene) {
    const ExtremeBackendReport& r = report.backends[0];
    std::string text = std::string(report.extreme->name) + " of " + scene + ": missed " +
                       std::to_string(r.rays.missed) + ", false " +
                       std::to_string(r.rays.falseHits) + ", wrong " +
                       std::to_string(r.rays.wrongPrimitive) + ", t off by " +
                       std::to_string(r.rays.maxUlpTError) + " ulp, pixels not finite " +
                       std::to_string(r.nonFinitePixels);
    if (r.leaks) text += ", leaks " + std::to_string(*r.leaks);
    if (r.selfShadows) text += ", self-shadows " + std::to_string(*r.selfShadows);
    for (const WrongAnswer& wrong : report.wrong)
        text += "; ray " + std::to_string(wrong.index) + " of kind " +
                std::string(rayKindName(wrong.kind));
    return text;
}

class Extremes : public testing::Test {
protected:
    ThreadPool pool_;
    std::vector<std::unique_ptr<Backend>> peers_;

    /// Runs all variants, on \p tested and beside it on Embree.
    void verify(const Scene& scene, const std::string& name, ViewMode mode, Backend& tested,
                uint32_t rays) {
        RenderSettings settings = test::smallSettings();
        settings.grid.mode = mode;
        verify(scene, name, settings, tested, rays);
    }
    void verify(const Scene& scene, const std::string& name, const RenderSettings& settings,
                Backend& tested, uint32_t rays) {
        std::vector<Backend*> backends{&tested};
#ifdef DIRT_HAVE_EMBREE
        peers_.clear();
        for (const bool robust : {false, true})
            peers_.push_back(std::make_unique<EmbreeBackend>(pool_, robust, EmbreeDecision::plain));
        for (const auto& peer : peers_) backends.push_back(peer.get());
#endif
        VerifySettings verify;
        verify.rays = rays;
        ExtremeVerifier verifier(scene, settings, backends, verify, pool_);
        std::vector<uint64_t> errors(backends.size());
        uint64_t cast = 0;
        for (const Extreme& extreme : extremes()) {
            const ExtremeReport report = verifier.run(extreme);
            EXPECT_EQ(report.leftOut, "") << extreme.name;
            EXPECT_TRUE(report.backends[0].right()) << describe(report, name);
            EXPECT_GT(report.hits, 0u) << extreme.name << " proves nothing";
            EXPECT_EQ(report.backends[0].leaks.has_value(),
                      extreme.body == Extreme::Body::closedBox);
            EXPECT_EQ(report.backends[0].selfShadows.has_value(),
                      extreme.body == Extreme::Body::ball);
            cast += report.rays;
            for (size_t b = 0; b < backends.size(); b++)
                errors[b] += report.backends[b].rays.errors();
        }
        std::cout << name << ": " << cast << " rays, wrong:";
        for (size_t b = 0; b < backends.size(); b++)
            std::cout << " " << backends[b]->name() << " " << errors[b];
        std::cout << std::endl;
#ifdef DIRT_HAVE_EMBREE
        EXPECT_GT(errors[1], 0u) << "rays that are not hard prove little";
#endif
    }
};

TEST_F(Extremes, AllAreRightInFullView) {
    CpuBackend cpu(pool_);
    verify(test::smallScene(), "small", ViewMode::full, cpu, (uint32_t) test::cases(300, 20'000));
}

TEST_F(Extremes, AllAreRightInSingleView) {
    CpuBackend cpu(pool_);
    verify(test::smallScene(), "small", ViewMode::single, cpu, (uint32_t) test::cases(100, 20'000));
}

/// As core defines them, which the CPU backend does where a pyramid level is asked for.
TEST_F(Extremes, AllAreRightByTheDefinition) {
    CpuBackend cpu(pool_);
    RenderSettings settings = test::smallSettings();
    settings.grid.tile = 1, settings.grid.maxMip = 3;
    for (const ViewMode mode : {ViewMode::full, ViewMode::single}) {
        settings.grid.mode = mode;
        verify(test::smallScene(), "small", settings, cpu, (uint32_t) test::cases(100, 5000));
    }
}

/// What a frame knows of holes ends with its geometry: rays are judged without any.
TEST_F(Extremes, HolesOfTheFrameBeforeDoNotCount) {
    Scene scene = test::smallScene();
    for (Material& material : scene.materials) material.opacity = 0.3f;
    std::vector<std::unique_ptr<Backend>> tested;
    tested.push_back(std::make_unique<CpuBackend>(pool_));
#ifdef DIRT_HAVE_GL
    tested.push_back(std::make_unique<GlBackend>());
#endif
    VerifySettings verify;
    verify.rays = 100;
    for (const auto& backend : tested) {
        ExtremeVerifier verifier(scene, test::smallSettings(), {backend.get()}, verify, pool_);
        const ExtremeReport report = verifier.run(*extremeByName("rays-edge"));
        EXPECT_TRUE(report.backends[0].right()) << describe(report, backend->name());
        EXPECT_GT(report.hits, 50u) << backend->name();
    }
}

TEST_F(Extremes, AllAreRightOnOpenGl) {
    if (!test::fullTests()) GTEST_SKIP() << "takes minutes: in the long form";
#ifdef DIRT_HAVE_GL
    GlBackend gl;
    verify(test::smallScene(), "small", ViewMode::full, gl, 1000);
#else
    GTEST_SKIP() << "built without OpenGL";
#endif
}

class ExtremesOfPlaces : public Extremes, public testing::WithParamInterface<test::Place> {};

TEST_P(ExtremesOfPlaces, AllAreRight) {
    if (!test::fullTests()) GTEST_SKIP() << "takes minutes: in the long form";
    auto scene = test::loadPlace(GetParam(), 300'000);
    if (!scene) GTEST_SKIP() << GetParam().file << " is not in " << scenesFolder();
    scene->lights = test::smallScene().lights;
    scene->lights[0].position = scene->camera.eye, scene->lights[0].target = scene->camera.target;
    CpuBackend cpu(pool_);
    verify(*scene, GetParam().name, ViewMode::full, cpu, 1000);
}

INSTANTIATE_TEST_SUITE_P(Places, ExtremesOfPlaces, testing::ValuesIn(test::places()),
                         [](const auto& info) { return info.param.name; });

} // namespace
} // namespace dirt
