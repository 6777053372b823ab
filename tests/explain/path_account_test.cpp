// The terms that are told of a pixel add up to the pixel, on every backend.

#include "core/explain/path_account.h"

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/explain/ray_trail.h"
#include "core/frame/forwarding_backend.h"
#include "core/frame/renderer.h"
#include "tests/support/golden_scenes.h"

#ifdef DIRT_HAVE_EMBREE
#include "backend_embree/embree_backend.h"
#endif

#include <gtest/gtest.h>

#include <cstring>

namespace dirt {
namespace {

class PathAccountOf : public testing::TestWithParam<std::string> {
protected:
    PathAccountOf()
        : loaded_(loadScene(test::goldenFolder() / "scenes" / (GetParam() + ".scene"))),
          settings_(test::goldenSettings(loaded_, 3)) {
        settings_.grid.width = 48;
        settings_.grid.height = 24;
    }

    /// The image's pixel is the mean of the samples'.
    void expectSums(Backend& backend) {
        const Image image = Renderer(loaded_.scene, settings_, backend).render().image;
        for (const size_t pixel : {0u, 600u, 700u, 1151u}) {
            glm::vec3 sum(0.0f);
            for (uint32_t sample = 0; sample < 3; ++sample) {
                const PathAccount account =
                    accountOf(loaded_.scene, settings_, backend, pixel, sample);
                sum += account.radiance;
                expectTerms(account);
            }
            EXPECT_EQ(sum * (1.0f / 3.0f), image.pixels[pixel]) << pixel;
        }
    }

    void expectTerms(const PathAccount& account) {
        glm::vec3 gathered(0.0f);
        ASSERT_FALSE(account.events.empty());
        for (const EventAccount& event : account.events) {
            gathered += event.added;
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(event.emitted[c] + event.reflected[c], event.added[c],
                            1e-6f * (1.0f + account.radiance[c]));
                EXPECT_GE(event.reflected[c], -1e-6f * (1.0f + account.radiance[c]));
                if (event.shadowRay && !event.lit) {
                    EXPECT_NEAR(event.reflected[c], 0.0f, 1e-6f * (1.0f + account.radiance[c]));
                }
            }
            if (!account.grid || event.rasterized) continue;
            const Ray ray{event.ray.origin, event.ray.direction, event.ray.skip};
            const RayTrail trail = closestTrail(*account.grid, account.geometry, ray);
            EXPECT_EQ(trail.hit.primitive, event.hit.primitive);
            EXPECT_EQ(trail.hit.t, event.hit.t);
            if (!event.shadowRay) continue;
            EXPECT_EQ(anyTrail(*account.grid, account.geometry, event.shadowRay->ray,
                               event.shadowRay->maxT)
                          .blocked,
                      !event.lit);
        }
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(gathered[c], account.radiance[c], 1e-6f * (1.0f + account.radiance[c]));
    }

    LoadedScene loaded_;
    RenderSettings settings_;
    ThreadPool pool_{2};
};

TEST_P(PathAccountOf, AddsUpOnTheCpu) {
    CpuBackend backend(pool_);
    expectSums(backend);
}

#ifdef DIRT_HAVE_EMBREE
TEST_P(PathAccountOf, AddsUpWithEmbree) {
    EmbreeBackend backend(pool_);
    expectSums(backend);
}
#endif

/// Whether the first has one record, which is the second's of \p pixel; or neither has any.
template <typename Record>
void expectOnly(const std::vector<Record>& one, const std::vector<Record>& all, size_t pixel) {
    ASSERT_EQ(one.size(), all.empty() ? 0u : 1u);
    if (!all.empty()) {
        EXPECT_EQ(std::memcmp(&one[0], &all[pixel], sizeof(Record)), 0);
    }
}

/// A pixel's records are those that all pixels' buffers have of it, in full and packed.
TEST_P(PathAccountOf, ReadsTheRecordsOfOnePixel) {
    CpuBackend backend(pool_);
    RenderHooks hooks;
    size_t events = 0;
    hooks.observe = [&](uint32_t, int) {
        const PathBuffers all = backend.readPaths();
        for (const size_t pixel : {0u, 600u, 1151u}) {
            const PathBuffers one = backend.readPath(pixel);
            EXPECT_EQ(one.pixels(), 1u);
            EXPECT_TRUE(one.packedNext.empty());
            expectOnly(one.previous, all.previous, pixel);
            expectOnly(one.current, all.current, pixel);
            expectOnly(one.next, all.next, pixel);
            expectOnly(one.mask, all.mask, pixel);
            expectOnly(one.rays, all.rays, pixel);
            expectOnly(one.hits, all.hits, pixel);
            expectOnly(one.visibility, all.visibility, pixel);
            expectOnly(one.radiance, all.radiance, pixel);
            expectOnly(one.image, all.image, pixel);
        }
        ++events;
    };
    settings_.samples = 2; // the image is not empty
    Renderer renderer(loaded_.scene, settings_, backend);
    renderer.keepPreviousPoint();
    renderer.render(hooks);
    EXPECT_EQ(events, 2u * (size_t) settings_.bounces);
}

/// Counts the events that are traced.
class CountingBackend final : public ForwardingBackend {
public:
    using ForwardingBackend::ForwardingBackend;
    void trace(int event) override {
        ++traces;
        ForwardingBackend::trace(event);
    }
    size_t traces = 0;
};

/// What happens to other pixels after the path's end is not waited for.
TEST_P(PathAccountOf, EndsWithThePath) {
    CpuBackend cpu(pool_);
    settings_.bounces = 4;
    settings_.roulette = false;
    for (size_t pixel = 5; pixel < 1152; pixel += 97) {
        CountingBackend backend(cpu);
        const PathAccount account = accountOf(loaded_.scene, settings_, backend, pixel, 0);
        ASSERT_FALSE(account.events.empty());
        const size_t traced = account.events.size() - (account.events[0].rasterized ? 1 : 0);
        // A path that ends on a surface that reflects nothing has one event more, without it.
        const bool onSurface = account.events.back().point.found() && account.events.size() < 4;
        EXPECT_EQ(backend.traces, traced + (onSurface ? 1 : 0));
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, PathAccountOf, testing::ValuesIn(test::goldenScenes()),
                         [](const auto& info) { return info.param; });

} // namespace
} // namespace dirt
