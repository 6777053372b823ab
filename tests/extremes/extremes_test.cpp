// Every variant of `verify --extremes`, of a small scene: all rays right, nothing leaks, no body
// shadows itself, no pixel is infinite.

#include "backend_cpu/cpu_backend.h"
#include "tests/extremes/verify_variants.h"
#include "tests/support/random.h"

#ifdef DIRT_HAVE_GL
#include "backend_gl/gl_backend.h"
#endif

namespace dirt {
namespace {

using test::Extremes;

TEST_F(Extremes, AllAreRightInFullView) {
    CpuBackend cpu(pool_);
    verify(test::smallScene(), "small", ViewMode::full, cpu, (uint32_t) test::cases(300, 5000));
}

TEST_F(Extremes, AllAreRightInSingleView) {
    CpuBackend cpu(pool_);
    verify(test::smallScene(), "small", ViewMode::single, cpu, (uint32_t) test::cases(100, 5000));
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
        EXPECT_TRUE(report.backends[0].right()) << test::describe(report, backend->name());
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

} // namespace
} // namespace dirt
