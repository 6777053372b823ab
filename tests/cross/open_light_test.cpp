// A light that casts no shadows lights what faces it, on every backend alike, and costs neither
// rays nor a map.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/frame/renderer.h"
#include "tests/frame/shapes.h"

#ifdef DIRT_HAVE_EMBREE
#include "backend_embree/embree_backend.h"
#endif

#include <gtest/gtest.h>

namespace dirt {
namespace {

class OpenLight : public testing::Test {
protected:
    OpenLight() {
        settings_.grid.width = 64;
        settings_.grid.height = 48;
        settings_.samples = 2;
        for (Spotlight& light : scene_.lights) light.shadows = false;
    }

    RenderResult render(Backend& backend) const {
        return Renderer(scene_, settings_, backend).render();
    }

    ThreadPool pool_{2};
    CpuBackend cpu_{pool_};
    Scene scene_ = test::room();
    RenderSettings settings_;
};

TEST_F(OpenLight, NeedsNeitherRaysNorMap) {
    for (const auto way : {LightVisibility::traced, LightVisibility::shadowMap}) {
        settings_.visibility = way;
        const Requirements need = requirementsOf(scene_, settings_, true);
        EXPECT_TRUE(need.light && need.openLight);
        EXPECT_FALSE(need.shadowRays);
        EXPECT_EQ(need.shadowMap, 0u);
        const RenderResult result = render(cpu_);
        EXPECT_EQ(result.counts.shadowRays, 0u);
        for (const PassTime& pass : result.passes)
            EXPECT_TRUE(pass.name != "Visibility" && pass.name != "ShadowMap");
    }
}

TEST_F(OpenLight, IsAddedToWhatShadowsLeave) {
    const Image open = render(cpu_).image;
    for (Spotlight& light : scene_.lights) light.shadows = true;
    const Image shaded = render(cpu_).image;
    size_t lighter = 0;
    for (size_t i = 0; i < open.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            EXPECT_GE(open.pixels[i][c], shaded.pixels[i][c]);
            lighter += open.pixels[i][c] > shaded.pixels[i][c];
        }
    EXPECT_GT(lighter, 100u);
}

#ifdef DIRT_HAVE_EMBREE
TEST_F(OpenLight, LooksAlikeUnderEmbree) {
    settings_.primary = Primary::traced;
    EmbreeBackend embree(pool_);
    EXPECT_EQ(render(embree).image.pixels, render(cpu_).image.pixels);
}
#endif

} // namespace
} // namespace dirt
