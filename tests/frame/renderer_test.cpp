#include "core/frame/renderer.h"

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/frame/compact.h"
#include "tests/frame/brute_force_backend.h"
#include "tests/frame/shapes.h"

#include <algorithm>

#include <glm/common.hpp>
#include <gtest/gtest.h>

namespace dirt {
namespace {

/// Runs the pieces of a loop from the last to the first, in pieces of \p grain at most.
class BackwardExecutor final : public Executor {
public:
    unsigned threads() const override { return 1; }

private:
    void runPieces(size_t count, size_t grain, const Piece& piece) override {
        for (size_t i = (count + grain - 1) / grain; i-- > 0;)
            piece(i * grain, std::min(count, (i + 1) * grain));
    }
};

RenderSettings settings(ViewMode mode = ViewMode::full) {
    RenderSettings result;
    result.grid.mode = mode;
    result.grid.width = 97; // more pixels than one piece, and no multiple of it
    result.grid.height = 61;
    result.samples = 2;
    result.bounces = 3;
    return result;
}

RenderResult renderWith(Executor& executor, const RenderSettings& settings,
                        const RenderHooks& hooks = {}) {
    const Scene scene = test::room();
    CpuBackend backend(executor);
    return Renderer(scene, settings, backend).render(hooks);
}

TEST(Renderer, SameBitsForAnyExecutor) {
    for (ViewMode mode : {ViewMode::full, ViewMode::single}) {
        SerialExecutor serial;
        const RenderResult expected = renderWith(serial, settings(mode));
        BackwardExecutor backward;
        EXPECT_EQ(renderWith(backward, settings(mode)).image.pixels, expected.image.pixels);
        for (unsigned threads : {1u, 2u, 7u}) {
            ThreadPool pool(threads);
            const RenderResult result = renderWith(pool, settings(mode));
            EXPECT_EQ(result.image.pixels, expected.image.pixels) << threads << " threads";
            EXPECT_EQ(result.counts.rays, expected.counts.rays);
            EXPECT_EQ(result.counts.hits, expected.counts.hits);
            EXPECT_EQ(result.counts.shadowRays, expected.counts.shadowRays);
        }
    }
}

TEST(Renderer, GridAndBruteForceGiveTheSameBits) {
    // In single mode, too, although brute force finds what is beyond the view: core ends the rays.
    const Scene scene = test::room();
    SerialExecutor serial;
    for (ViewMode mode : {ViewMode::full, ViewMode::single}) {
        test::BruteForceBackend oracle(serial);
        RenderSettings choices = settings(mode);
        choices.primary = Primary::traced;
        const RenderResult expected = Renderer(scene, choices, oracle).render();
        const RenderResult result = renderWith(serial, choices);
        EXPECT_EQ(result.image.pixels, expected.image.pixels);
        EXPECT_EQ(result.counts.hits, expected.counts.hits);
    }
}

TEST(Renderer, SeedAndSamplesChangeTheImage) {
    SerialExecutor serial;
    RenderSettings other = settings();
    other.seed = 1;
    const Image image = renderWith(serial, settings()).image;
    EXPECT_NE(renderWith(serial, other).image.pixels, image.pixels);
}

TEST(Renderer, PassesRunInTheirOrder) {
    SerialExecutor serial;
    RenderSettings choices = settings();
    choices.bounces = 2;
    const RenderResult result = renderWith(serial, choices);
    std::vector<std::pair<std::string, int>> names;
    for (const PassTime& pass : result.passes) names.emplace_back(pass.name, pass.event);
    const std::vector<std::pair<std::string, int>> expected = {{"Clear", 0},
                                                               {"FillDepth", 0},
                                                               {"FillDepthMipmap", 0},
                                                               {"FillPrimitives", 0},
                                                               {"DirectVisibility", 0},
                                                               {"Visibility", 0},
                                                               {"Shade", 0},
                                                               {"DepthMask", 1},
                                                               {"Rays", 1},
                                                               {"Trace", 1},
                                                               {"Fetch", 1},
                                                               {"Visibility", 1},
                                                               {"Shade", 1},
                                                               {"Resolve", 0}};
    EXPECT_EQ(names, expected);
    EXPECT_GT(result.passMs("Trace"), 0.0);
    EXPECT_GE(result.frameMs, result.passMs("Trace"));

    choices.primary = Primary::traced;
    choices.bounces = 1;
    names.clear();
    for (const PassTime& pass : renderWith(serial, choices).passes)
        if (pass.name != "Clear" && pass.name.substr(0, 4) != "Fill")
            names.emplace_back(pass.name, pass.event);
    const std::vector<std::pair<std::string, int>> traced = {
        {"Rays", 0}, {"Trace", 0}, {"Fetch", 0}, {"Visibility", 0}, {"Shade", 0}, {"Resolve", 0}};
    EXPECT_EQ(names, traced);
}

TEST(Renderer, StoppedFramesKeepTheirFinishedSamples) {
    SerialExecutor serial;
    RenderSettings choices = settings();
    choices.samples = 5;
    int done = 0, asked = 0;
    RenderHooks hooks;
    hooks.progress = [&](int samples, int total) {
        done = samples;
        EXPECT_EQ(total, 5);
    };
    hooks.stop = [&] { return done == 2 && ++asked > 3; }; // in the middle of the third sample
    const RenderResult stopped = renderWith(serial, choices, hooks);
    EXPECT_EQ(stopped.samples, 2);
    choices.samples = 2;
    EXPECT_EQ(renderWith(serial, choices).image.pixels, stopped.image.pixels);

    hooks.progress = nullptr;
    hooks.stop = [] { return true; };
    const RenderResult nothing = renderWith(serial, choices, hooks);
    EXPECT_EQ(nothing.samples, 0);
    EXPECT_EQ(nothing.image.pixels[0], glm::vec3(0.0f));
}

TEST(Renderer, AStopAtAnyMomentLeavesWholeSamples) {
    SerialExecutor serial;
    RenderSettings choices = settings();
    choices.grid.width = 9;
    choices.grid.height = 7;
    choices.samples = 2;
    choices.bounces = 2;
    std::vector<Image> finished;
    for (int samples : {1, 2}) {
        RenderSettings whole = choices;
        whole.samples = samples;
        finished.push_back(renderWith(serial, whole).image);
    }
    int samplesSeen[3] = {0, 0, 0};
    for (int moment = 0;; ++moment) {
        int asked = 0;
        RenderHooks hooks;
        hooks.stop = [&] { return asked++ >= moment; };
        const RenderResult result = renderWith(serial, choices, hooks);
        ++samplesSeen[result.samples];
        if (result.samples > 0) {
            ASSERT_EQ(result.image.pixels, finished[result.samples - 1].pixels) << moment;
        }
        if (result.samples == 2) break;
    }
    EXPECT_GT(samplesSeen[0], 5);
    EXPECT_GT(samplesSeen[1], 5);
}

TEST(Renderer, ObserverSeesEveryRay) {
    SerialExecutor serial;
    RenderSettings choices = settings();
    choices.primary = Primary::traced;
    const Scene scene = test::room();
    CpuBackend backend(serial);
    uint64_t rays = 0, hits = 0;
    int calls = 0;
    RenderHooks hooks;
    hooks.observe = [&](uint32_t sample, int event) {
        EXPECT_EQ(sample, (uint32_t) calls / 3);
        EXPECT_EQ(event, calls % 3);
        ++calls;
        const PathBuffers& paths = backend.paths();
        ASSERT_EQ(paths.rays.size(), 97u * 61u);
        for (size_t i = 0; i < paths.rays.size(); ++i) {
            const bool cast = paths.rays[i].direction != glm::vec3(0.0f);
            rays += cast;
            hits += paths.hits[i].found();
            ASSERT_TRUE(cast || !paths.hits[i].found());
            ASSERT_TRUE(paths.alive(event, i) || !cast);
            ASSERT_EQ(paths.next[i].found(), paths.hits[i].found());
            if (cast) {
                ASSERT_EQ(paths.rays[i].skip == kNoPrimitive, event == 0);
            }
        }
    };
    const RenderResult result = Renderer(scene, choices, backend).render(hooks);
    EXPECT_EQ(calls, 6);
    EXPECT_EQ(result.counts.rays, rays);
    EXPECT_EQ(result.counts.hits, hits);
    EXPECT_GT(hits, rays / 2);
    EXPECT_LT(hits, rays);
}

TEST(Renderer, BothModesShowTheSamePicture) {
    // Direct light of a light in the view, so that no shadow ray leaves it: apart from pixels whose
    // primitive differs (the frames are rounded differently), the radiance agrees as far as the
    // rounding of positions lets it.
    Scene scene = test::room();
    scene.lights[0].position = {0.4f, 1.8f, 0.5f};
    SerialExecutor serial;
    CpuBackend backend(serial);
    std::vector<uint32_t> primitives[2];
    Image images[2];
    for (ViewMode mode : {ViewMode::full, ViewMode::single}) {
        RenderSettings choices = settings(mode);
        choices.bounces = 1;
        choices.samples = 1;
        auto& ids = primitives[(int) mode];
        images[(int) mode] = Renderer(scene, choices, backend).render().image;
        for (const SurfacePoint& point : backend.paths().next) ids.push_back(point.primitive);
    }
    // Positions differ by some 2^-22 of the room, and nowhere does the light rise from nothing to
    // the brightest in less than a fiftieth of it.
    float brightest = 0.0f;
    for (const glm::vec3& p : images[0].pixels) brightest = std::max({brightest, p.x, p.y, p.z});
    const float bound = 50 * 0x1p-22f * brightest;
    size_t differentHits = 0, differentLight = 0;
    for (size_t i = 0; i < primitives[0].size(); ++i) {
        if (primitives[0][i] != primitives[1][i]) {
            ++differentHits;
            continue;
        }
        const glm::vec3 a = images[0].pixels[i], b = images[1].pixels[i];
        const glm::vec3 off = glm::abs(a - b);
        if (std::max({off.x, off.y, off.z}) > bound) ++differentLight; // on a shadow's border
    }
    // An edge or a shadow border passes within 1e-6 of hardly any of 5,917 pixel centres.
    EXPECT_LE(differentHits, 2u);
    EXPECT_LE(differentLight, 2u);
}

TEST(Compact, KeepsTheOrder) {
    SerialExecutor serial;
    BackwardExecutor backward;
    ThreadPool pool(3);
    for (size_t count : {0u, 1u, 7u, 8u, 1000u}) {
        std::vector<uint32_t> expected;
        for (uint32_t i = 0; i < count; ++i)
            if (i * 2654435761u >> 31) expected.push_back(i);
        const auto keep = [](size_t i) { return (bool) ((uint32_t) i * 2654435761u >> 31); };
        for (Executor* executor : {(Executor*) &serial, (Executor*) &backward, (Executor*) &pool})
            EXPECT_EQ(compact(*executor, count, 8, keep), expected);
    }
}

} // namespace
} // namespace dirt
