// Triangles that repeat the one before them: no ray tells them apart, but where holes let one
// through to the next.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/frame/renderer.h"
#include "core/trace/traverse.h"
#include "tests/frame/shapes.h"
#include "tests/support/grid_rays.h"
#include "tests/support/processor_time.h"

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

/// A wall, and before it \p count copies of a card; lit from beside the eye.
Scene cards(int count) {
    Scene scene;
    scene.materials = {material(glm::vec3(0.7f)), material({0.2f, 0.6f, 0.1f}),
                       material({0.8f, 0.1f, 0.1f})};
    addQuad(scene.mesh, {-4, -4, -5}, {8, 0, 0}, {0, 8, 0}, 0);
    for (int i = 0; i < count; ++i)
        addTriangle(scene.mesh, {-1, -1, -2}, {1, -1, -2.3f}, {0, 1, -2}, i == 0 ? 1 : 2);
    Spotlight light;
    light.position = {0.7f, 0.4f, 0.2f};
    light.target = {0, 0, -5};
    light.flux = 100.0f;
    scene.lights = {light};
    return scene;
}

RenderSettings settings() {
    RenderSettings result;
    result.grid.width = 96;
    result.grid.height = 64;
    result.samples = 2;
    return result;
}

Image render(const Scene& scene, Primary primary = Primary::raster) {
    RenderSettings chosen = settings();
    chosen.primary = primary;
    ThreadPool pool(2);
    CpuBackend backend(pool);
    return Renderer(scene, chosen, backend).render().image;
}

TEST(Repeated, TheFirstIsSeen) {
    const Image one = render(cards(1));
    EXPECT_EQ(render(cards(50)).pixels, one.pixels);
    EXPECT_EQ(render(cards(50), Primary::traced).pixels, one.pixels);
}

TEST(Repeated, HolesLetTheNextThrough) {
    Scene scene = cards(3);
    scene.scalarTextures = {ScalarTexture("holes", 2, 1, std::vector<uint8_t>{0, 255})};
    scene.materials[1].opacityMap = 0;
    scene.mesh.texcoords = {{0, 0}, {2, 0}, {0, 2}};
    scene.mesh.texcoordIndices[2] = {0, 1, 2};
    Scene apart = scene; // the same with the copies behind
    for (size_t i = 3; i < 5; ++i)
        for (uint32_t corner : apart.mesh.triangles[i])
            apart.mesh.positions[corner] *= 1.0f + 1e-4f * (float) i;
    const auto reds = [](const Image& image) {
        size_t count = 0;
        for (const glm::vec3& p : image.pixels) count += p.x > 3.0f * p.y;
        return count;
    };
    for (const Primary primary : {Primary::raster, Primary::traced}) {
        const size_t seen = reds(render(scene, primary)), expected = reds(render(apart, primary));
        EXPECT_GT(expected, 50u);
        EXPECT_NEAR((double) seen, (double) expected, 0.05 * (double) expected);
    }
    // A backend that has built another scene before, too.
    ThreadPool pool(2);
    CpuBackend backend(pool);
    const Image whole = Renderer(cards(3), settings(), backend).render().image;
    const Image again = Renderer(scene, settings(), backend).render().image;
    EXPECT_EQ(again.pixels, render(scene).pixels);
    EXPECT_EQ(Renderer(cards(3), settings(), backend).render().image.pixels, whole.pixels);
}

TEST(Repeated, TracingIsTheDefinition) {
    const Scene scene = cards(20);
    const FrameGeometry geometry = makeFrameGeometry(scene.mesh, scene.camera, ViewMode::full);
    ThreadPool pool(2);
    CpuBackend backend(pool);
    GridSettings grid = settings().grid;
    backend.build(geometry, scene.camera, grid);
    Random random(9);
    std::vector<Ray> rays;
    for (int i = 0; i < 2000; ++i) {
        Ray ray;
        ray.origin = {(float) random.uniform(-0.5, 0.5), (float) random.uniform(-0.5, 0.5),
                      (float) random.uniform(-0.5, 0.1)};
        ray.direction = {(float) random.uniform(-0.6, 0.6), (float) random.uniform(-0.6, 0.6), -1};
        if (i % 3 == 0) ray.skip = 2 + (uint32_t) random.below(20);
        rays.push_back(ray);
    }
    std::vector<Hit> hits(rays.size());
    backend.intersect(rays, hits);
    size_t onCard = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        const Hit expected = closestHit(backend.grid(), geometry, rays[i]);
        EXPECT_EQ(hits[i].primitive, expected.primitive);
        EXPECT_EQ(hits[i].t, expected.t);
        onCard += expected.primitive == 2;
    }
    EXPECT_GT(onCard, 100u);
}

TEST(Repeated, TenThousandTakeNoLongerThanOne) {
    const Scene scene = cards(10'000);
    EXPECT_LT(processorTime([&] { render(scene); }), kGenerous);
}

} // namespace
} // namespace dirt::test
