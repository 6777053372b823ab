// Holes in surfaces are decided at the hit: by the texture, not by the structure that led there.

#include "backend_cpu/cpu_backend.h"
#include "core/frame/renderer.h"
#include "core/path/camera_rays.h"
#include "core/path/sub_pixel.h"
#include "core/trace/holes.h"
#include "core/trace/traverse.h"
#include "tests/frame/shapes.h"
#include "tests/support/random.h"

#ifdef DIRT_HAVE_EMBREE
#include "backend_embree/embree_backend.h"
#endif

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace dirt {
namespace {

constexpr int kTexels = 16;

/// Opacity of random texels, and the card's side.
ScalarTexture mask() {
    test::Random random(3);
    std::vector<uint8_t> texels(kTexels * kTexels);
    for (uint8_t& texel : texels) texel = (uint8_t) random.below(256);
    return ScalarTexture("mask", kTexels, kTexels, std::move(texels));
}

/// A card with holes before a wall, lit from beside the eye; the card shows two thirds of its
/// texture's width, repeated.
Scene cardScene() {
    Scene scene;
    scene.materials = {test::material(glm::vec3(0.7f)), test::material({0.2f, 0.6f, 0.1f})};
    scene.scalarTextures = {mask()};
    scene.materials[1].opacityMap = 0;
    test::addQuad(scene.mesh, {-4, -4, -5}, {8, 0, 0}, {0, 8, 0}, 0);
    test::addQuad(scene.mesh, {-1, -1, -2}, {2, 0, 0.3f}, {0, 2, 0}, 1);
    scene.mesh.texcoords = {{0, 0}, {2.5f, 0}, {2.5f, 1.5f}, {0, 1.5f}};
    scene.mesh.texcoordIndices[2] = {0, 1, 2};
    scene.mesh.texcoordIndices[3] = {0, 2, 3};
    scene.camera.eye = glm::vec3(0.0f);
    Spotlight light;
    light.position = {0.7f, 0.4f, 0.2f};
    light.target = {0, 0, -5};
    light.flux = 100.0f;
    scene.lights = {light};
    return scene;
}

RenderSettings settings(int tile) {
    RenderSettings result;
    result.grid.width = 160;
    result.grid.height = 120;
    result.grid.tile = tile;
    result.samples = 2;
    return result;
}

struct Rendered {
    std::vector<uint32_t> seen; ///< primitives of the first sample's pixels
    std::vector<glm::vec3> image;
};

Rendered render(const Scene& scene, const RenderSettings& settings, Backend& backend) {
    Rendered result;
    RenderHooks hooks;
    hooks.observe = [&](uint32_t sample, int event) {
        if (sample == 0 && event == 0)
            for (const SurfacePoint& point : backend.readPaths().next)
                result.seen.push_back(point.primitive);
    };
    result.image = Renderer(scene, settings, backend).render(hooks).image.pixels;
    return result;
}

TEST(CutOuts, SilhouetteIsThatOfTheTexture) {
    const Scene scene = cardScene();
    SerialExecutor executor;
    CpuBackend backend(executor);
    const RenderSettings choice = settings(16);
    const Rendered rendered = render(scene, choice, backend);
    const FrameGeometry geometry = makeFrameGeometry(scene.mesh, scene.camera, choice.grid.mode);
    const CameraRays camera(scene.camera, 160, 120, choice.grid.mode);
    const glm::vec2 offset = subPixelOffset(0, choice.seed);
    int holes = 0, card = 0;
    for (size_t i = 0; i < rendered.seen.size(); ++i) {
        const glm::dvec3 d(
            camera.through((float) (i % 160) + offset.x, (float) (i / 160) + offset.y).direction);
        // The card's plane: its points are (-1 + 2 s, -1 + 2 t, -2 + 0.3 s).
        const double depth = (-2.0 + 0.15) / (d.z - 0.15 * d.x);
        const double s = (depth * d.x + 1.0) / 2.0, t = (depth * d.y + 1.0) / 2.0;
        if (std::min({s, t, 1 - s, 1 - t}) < 1e-4) continue;
        // Bilinear between the centres of texels, by the definition.
        const double x = s * 2.5 * kTexels - 0.5, y = -t * 1.5 * kTexels - 0.5;
        double opacity = 0.0;
        for (int corner = 0; corner < 4; ++corner) {
            const int cx = (int) std::floor(x) + (corner & 1),
                      cy = (int) std::floor(y) + corner / 2;
            const double weight = (1.0 - std::abs(x - cx)) * (1.0 - std::abs(y - cy));
            opacity += weight * scene.scalarTextures[0].texel((cx + 64 * kTexels) % kTexels,
                                                              (cy + 64 * kTexels) % kTexels);
        }
        if (std::abs(opacity - 0.5) < 1e-4) continue; // barycentrics are good to 2^-22 of 40 texels
        const bool there = opacity >= 0.5;
        ASSERT_EQ(rendered.seen[i] >= 2, there) << "pixel " << i % 160 << "," << i / 160;
        ++(there ? card : holes);
    }
    EXPECT_GT(holes, 2000);
    EXPECT_GT(card, 2000);
    EXPECT_TRUE(
        isHit(geometry, glm::vec3(0.0f), 2, 0.3f, 0.3f)); // without a scene there are no holes
}

/// For fine and coarse tiles, traced primary rays, core's traversal and Embree.
void expectSameEverywhere(const Scene& scene, const Rendered& expected, Executor& executor) {
    const auto expectSame = [&](const Rendered& other, const std::string& what) {
        EXPECT_EQ(other.seen, expected.seen) << what;
        EXPECT_EQ(other.image, expected.image) << what;
    };
    CpuBackend cpu(executor);
    for (int tile : {1, 64}) expectSame(render(scene, settings(tile), cpu), "tile");
    RenderSettings traced = settings(16);
    traced.primary = Primary::traced;
    expectSame(render(scene, traced, cpu), "traced primary rays");
    traced.grid.traversal = Traversal::linear; // core's own traversal
    expectSame(render(scene, traced, cpu), "core");
#ifdef DIRT_HAVE_EMBREE
    EmbreeBackend embree(executor);
    expectSame(render(scene, settings(16), embree), "embree");
#endif
}

TEST(CutOuts, AreTheSameForEveryStructureAndBackend) {
    const Scene scene = cardScene();
    SerialExecutor executor;
    CpuBackend cpu(executor);
    const Rendered expected = render(scene, settings(16), cpu);
    expectSameEverywhere(scene, expected, executor);
}

/// Seen from its front a surface with one side is as any other, from behind it is not there; for
/// all structures and backends.
TEST(CutOuts, OneSidedSurfacesAreNotThereFromBehind) {
    SerialExecutor executor;
    CpuBackend cpu(executor);
    Scene scene = cardScene(); // the card's front is seen
    scene.materials[1].opacityMap = kNoTexture;
    scene.materials[0].emission = scene.materials[1].emission = glm::vec3(0.5f);
    scene.lights.clear();
    const auto count = [](const Rendered& rendered) {
        return std::count_if(rendered.seen.begin(), rendered.seen.end(),
                             [](uint32_t id) { return id == 2 || id == 3; });
    };
    const Rendered twoSided = render(scene, settings(16), cpu);
    EXPECT_GT(count(twoSided), 4000);
    for (const bool turned : {false, true}) {
        if (turned)
            for (uint32_t id : {2u, 3u})
                std::swap(scene.mesh.triangles[id][1], scene.mesh.triangles[id][2]);
        scene.materials[1].doubleSided = false;
        EXPECT_TRUE(requirementsOf(scene, settings(16), true).cutOuts);
        const Rendered expected = render(scene, settings(16), cpu);
        if (turned)
            EXPECT_EQ(count(expected), 0);
        else
            EXPECT_EQ(expected.seen, twoSided.seen);
        expectSameEverywhere(scene, expected, executor);
    }
}

/// The wall is lit through the back of a card, and in the shade of its front.
TEST(CutOuts, OneSidedSurfacesThrowTheirFrontsShade) {
    SerialExecutor executor;
    CpuBackend cpu(executor);
    RenderSettings direct = settings(16);
    direct.bounces = 1;
    for (const LightVisibility visibility : {LightVisibility::traced, LightVisibility::shadowMap}) {
        direct.visibility = visibility;
        Scene scene = cardScene();
        scene.materials[1].opacityMap = kNoTexture;
        const auto sum = [&] {
            double total = 0.0;
            const Rendered rendered = render(scene, direct, cpu);
            for (size_t i = 0; i < rendered.image.size(); ++i)
                if (rendered.seen[i] < 2) total += rendered.image[i].x; // of the wall
            return total;
        };
        scene.camera.eye.z = -2.5f; // behind the card, which would hide the wall
        scene.camera.target = {0.0f, 0.0f, -5.0f};
        const double shaded = sum();
        scene.materials[1].doubleSided = false; // shadow rays come from the wall, from behind
        EXPECT_GT(sum(), 1.1 * shaded);
        for (uint32_t id : {2u, 3u})
            std::swap(scene.mesh.triangles[id][1], scene.mesh.triangles[id][2]);
        EXPECT_EQ(sum(), shaded);
    }
}

TEST(CutOuts, LetShadowRaysThrough) {
    Scene scene = cardScene();
    SerialExecutor executor;
    CpuBackend cpu(executor);
    RenderSettings direct = settings(16);
    direct.bounces = 1;
    const auto sum = [&] {
        double total = 0.0;
        const Rendered rendered = render(scene, direct, cpu);
        for (size_t i = 0; i < rendered.image.size(); ++i)
            if (rendered.seen[i] < 2) total += rendered.image[i].x; // of the wall
        return total;
    };
    const double holes = sum();
    scene.materials[1].opacity = 0.0f; // all gone
    const double open = sum();
    scene.materials[1].opacity = 1.0f;
    scene.materials[1].opacityMap = kNoTexture;
    const double closed = sum();
    EXPECT_LT(closed, 0.9 * holes);
    EXPECT_LT(holes, 0.9 * open);
}

TEST(CutOuts, CostNothingWhereThereAreNone) {
    Scene scene = cardScene();
    EXPECT_TRUE(requirementsOf(scene, settings(16), true).cutOuts);
    scene.materials[1].opacityMap = kNoTexture;
    EXPECT_FALSE(requirementsOf(scene, settings(16), true).cutOuts);
    SerialExecutor executor;
    CpuBackend cpu(executor);
    render(scene, settings(16), cpu);
    EXPECT_EQ(cpu.geometry().cutOuts, nullptr);
}

} // namespace
} // namespace dirt
