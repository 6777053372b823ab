// The shadow map: its texels against their definition, what it lets through against closed forms,
// and that there is one only where it is asked for.

#include "core/frame/shadow_raster.h"

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/base/error.h"
#include "core/frame/memory_plan.h"
#include "core/frame/renderer.h"
#include "core/path/grid_spotlight.h"
#include "core/path/shadow_frustum.h"
#include "tests/frame/shapes.h"
#include "tests/support/golden_scenes.h"
#include "tests/support/small_scenes.h"

#ifdef DIRT_HAVE_EMBREE
#include "backend_embree/embree_backend.h"
#endif

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace dirt {
namespace {

/// A scene's geometry and its light's map, drawn.
struct Drawn {
    explicit Drawn(const Scene& scene, Executor& executor, ViewMode mode = ViewMode::full)
        : geometry(makeFrameGeometry(scene.mesh, scene.camera, mode)) {
        geometry.cutOuts = &scene;
        light = makeGridSpotlight(scene.lights.front(), geometry.frame);
        map = makeShadowMap(scene, geometry.frame);
        rasterizeShadowMap(geometry, light, map, executor, depths);
    }

    /// At a point of world space, on a surface of that normal.
    float open(glm::dvec3 point, glm::dvec3 normal = {0, 1, 0}) const {
        return openToLight({depths.data(), map.resolution}, light, map,
                           geometry.frame.toGrid(glm::vec3(point)),
                           geometry.frame.directionToGrid(glm::vec3(normal)));
    }

    FrameGeometry geometry;
    GridSpotlight light;
    ShadowMap map;
    std::vector<float> depths;
};

/// Texels that are not as shadowDepth() says.
size_t wrongTexels(const Drawn& drawn) {
    const uint32_t side = drawn.map.resolution;
    EXPECT_EQ(drawn.depths.size(), (size_t) side * side);
    size_t wrong = 0;
    for (uint32_t i = 0; i < side * side; ++i)
        wrong += drawn.depths[i] !=
                 shadowDepth(drawn.geometry, drawn.light, drawn.map, i % side, i / side);
    return wrong;
}

size_t casting(const Drawn& drawn) {
    return (size_t) std::count_if(drawn.depths.begin(), drawn.depths.end(),
                                  [](float depth) { return depth != kNothingCasts; });
}

/// A light somewhere in the scene, often in a vertex's or a wall's plane.
Spotlight someLight(test::Random& random, const std::vector<Triangle>& triangles) {
    const auto place = [&] {
        const Triangle& t = triangles[(size_t) random.below((int) triangles.size())];
        if (random.chance(0.3)) return t.a;
        if (random.chance(0.2)) return t.a + (t.b - t.a) + (t.a - t.c); // in its plane
        return test::uniformPoint(random, random.pick({0.01, 1.0, 30.0}));
    };
    Spotlight light;
    light.position = place();
    do light.target = place();
    while (light.target == light.position);
    light.aperture = random.pick({0.5f, 30.0f, 90.0f, 170.0f});
    light.conical = random.chance(0.5);
    light.resolution = random.range(1, 40);
    if (random.chance(0.3)) light.nearRange = 0.25f;
    if (random.chance(0.3)) light.farRange = 1.0f;
    return light;
}

TEST(ShadowMap, TexelsAreThoseOfTheDefinition) {
    test::Random random(1);
    SerialExecutor serial;
    ThreadPool pool(2);
    const GridSettings grid;
    size_t found = 0;
    for (int i = 0; i < test::cases(300, 20'000); ++i) {
        const auto triangles = test::smallScene(random, test::ViewSet(grid, Camera{}));
        Scene scene = test::sceneOf(triangles);
        scene.lights = {someLight(random, triangles)};
        const Drawn drawn(scene, i % 2 ? (Executor&) serial : pool,
                          i % 3 ? ViewMode::full : ViewMode::single);
        ASSERT_EQ(wrongTexels(drawn), 0u) << "case " << i;
        found += casting(drawn);
    }
    EXPECT_GT(found, 10'000u);
}

/// Large enough for triangles to be drawn in bands.
TEST(ShadowMap, TexelsAreThoseOfTheDefinitionInLargeMaps) {
    Scene scene = test::room();
    scene.lights[0].resolution = 203;
    ThreadPool pool(2);
    const Drawn drawn(scene, pool);
    EXPECT_EQ(wrongTexels(drawn), 0u);
    EXPECT_GT(casting(drawn), drawn.depths.size() * 9 / 10);
    SerialExecutor serial;
    EXPECT_EQ(Drawn(scene, serial).depths, drawn.depths);
}

TEST(ShadowMap, CutOutsCastTheirHoles) {
    Scene scene = loadScene(test::goldenFolder() / "scenes" / "cards_shadow_map.scene").scene;
    scene.lights[0].resolution = 64;
    SerialExecutor serial;
    const Drawn holes(scene, serial);
    EXPECT_EQ(wrongTexels(holes), 0u);
    for (Material& material : scene.materials) {
        material.opacityMap = kNoTexture;
        material.opacity = 1.0f;
    }
    const Drawn whole(scene, serial);
    size_t through = 0;
    for (size_t i = 0; i < whole.depths.size(); ++i) {
        EXPECT_LE(whole.depths[i], holes.depths[i]);
        through += whole.depths[i] < holes.depths[i];
    }
    EXPECT_GT(through, 200u);
}

/// A floor at height 0 that leans by \p tilt degrees along X, four above which a light hangs.
Scene floorBelowALight(double tilt = 0.0) {
    Scene scene;
    scene.materials = {test::material(glm::vec3(0.5f))};
    const double t = tilt * M_PI / 180.0;
    const glm::vec3 along(60.0 * std::cos(t), 60.0 * std::sin(t), 0.0);
    test::addQuad(scene.mesh, -0.5f * along - glm::vec3(0, 0, 30), along, {0, 0, 60}, 0);
    Spotlight light;
    light.position = {0, 4, 0};
    light.target = {0, 0, 0};
    light.aperture = 60.0f;
    light.resolution = 100;
    light.farRange = 10.0f;
    scene.lights = {light};
    scene.camera.eye = {0, 1, 5};
    return scene;
}

/// The box's upper side is at half the height, so that its shadow is twice as wide.
TEST(ShadowMap, ABoxCastsItsShadowWithinATexel) {
    Scene scene = floorBelowALight();
    test::addBox(scene.mesh, {-0.3f, 0.5f, -0.45f}, {0.4f, 2.0f, 0.35f}, 0);
    SerialExecutor serial;
    // On the floor: half a texel for where its centre samples, half for the filter of one texel.
    const double texel = 4.0 * 2.0 * std::tan(M_PI / 6.0) / 100.0;
    int lit = 0, dark = 0;
    for (const ViewMode mode : {ViewMode::full, ViewMode::single}) {
        const Drawn drawn(scene, serial, mode);
        for (double x = -1.5; x <= 1.5; x += 0.0137)
            for (double z = -1.5; z <= 1.5; z += 0.0171) {
                // Signed distance, along an axis, to the shadow's border.
                const double out = std::max({-0.6 - x, x - 0.8, -0.9 - z, z - 0.7});
                const float open = drawn.open({x, 0.0, z});
                if (out > 1.01 * texel) {
                    ASSERT_EQ(open, 1.0f) << x << ", " << z;
                }
                if (out < -1.01 * texel) {
                    ASSERT_EQ(open, 0.0f) << x << ", " << z;
                }
                lit += open == 1.0f;
                dark += open == 0.0f;
            }
    }
    EXPECT_GT(lit, 10'000);
    EXPECT_GT(dark, 10'000);
}

TEST(ShadowMap, SoftEdgesAreAsWideAsAskedFor) {
    for (const float softness : {0.2f, 0.5f, 2.0f}) {
        Scene scene = floorBelowALight();
        test::addQuad(scene.mesh, {-10, 2, -10}, {10, 0, 0}, {0, 0, 20}, 0); // darkens x < 0
        scene.lights[0].softShadowSize = softness;
        scene.lights[0].resolution = 400;
        SerialExecutor serial;
        const Drawn drawn(scene, serial);
        const double texel = 4.0 * 2.0 * std::tan(M_PI / 6.0) / 400.0;
        // Beyond 16 texels the filter looks at cells.
        const double cell = texel * (1.0 + std::floor(softness / texel / 16.0));
        for (double x = -1.8; x <= 1.8; x += 0.01) {
            const double part = std::clamp(0.5 + x / softness, 0.0, 1.0);
            // The edge is known to half a cell, or half a texel beside where it is sampled.
            EXPECT_NEAR(drawn.open({x, 0.0, 0.3}), part, (cell / 2 + texel / 2) / softness + 1e-5)
                << softness << " at " << x;
        }
    }
}

/// By area: a map that is dark to the left of a texel's border, at points all over it.
TEST(ShadowMap, WeightsAreTheAreasOfTexels) {
    test::Random random(2);
    GridSpotlight light;
    light.axis = {0, 0, 1}, light.right = {1, 0, 0}, light.up = {0, 1, 0};
    ShadowMap map;
    map.resolution = 64;
    map.extent = 1.0f, map.step = 2.0f / 64.0f;
    map.farthest = 10.0f, map.bias = 0.001f;
    std::vector<float> open(64 * 64, kNothingCasts), half = open;
    for (size_t i = 0; i < half.size(); ++i)
        if (i % 64 < 32) half[i] = 0.5f;
    for (int i = 0; i < 20'000; ++i) {
        const float width = (float) random.uniform(0.0, 15.0); // texels
        map.softness = width * map.step;
        const glm::vec3 point(random.uniform(-0.7, 0.7), random.uniform(-0.7, 0.7), 1.0);
        EXPECT_EQ(openToLight({open.data(), 64}, light, map, point, {0, 0, -1}), 1.0f);
        const double filter = std::max(width, 1.0f);
        const double part = std::clamp(0.5 + point.x * 32.0 / filter, 0.0, 1.0);
        // 16 additions of weights that are off by roundings of places up to 64: 2^-17 each.
        EXPECT_NEAR(openToLight({half.data(), 64}, light, map, point, {0, 0, -1}), part,
                    0x1p-13 / filter);
    }
}

/// No plane casts on itself, whatever its tilt and the filter, at the demo's smallest bias; nor
/// without the bias but for roundings, which shows that the filter follows the plane.
TEST(ShadowMap, TiltedPlanesAreFreeOfAcne) {
    SerialExecutor serial;
    for (const double tilt : {0.0, 30.0, 60.0, 80.0, 86.0})
        for (const float softness : {0.0f, 0.1f, 0.4f}) {
            Scene scene = floorBelowALight(tilt);
            scene.lights[0].softShadowSize = softness;
            scene.lights[0].constantBias = 0.0005f;
            const Drawn drawn(scene, serial);
            const double t = tilt * M_PI / 180.0;
            const glm::dvec3 normal(-std::sin(t), std::cos(t), 0.0);
            int asked = 0;
            for (double s = -1.0; s <= 1.0; s += 0.031)
                for (double z = -1.0; z <= 1.0; z += 0.037) {
                    const glm::dvec3 point(s * std::cos(t), s * std::sin(t), z);
                    // Where the filter sees the plane change by half, it may be too dark.
                    const double depth = 4.0 - point.y, half = 0.5 * softness + 0.1;
                    if (std::tan(t) * half / depth > 0.4) continue;
                    ++asked;
                    ASSERT_EQ(drawn.open(point, normal), 1.0f)
                        << "tilt " << tilt << ", softness " << softness << " at " << s;
                }
            if (tilt < 80.0) {
                EXPECT_GT(asked, 1000);
            }
        }
}

TEST(ShadowMap, OnlyWhatIsInRangeCasts) {
    SerialExecutor serial;
    for (const float height : {1.0f, 3.5f}) { // depths 3 and 0.5
        Scene scene = floorBelowALight();
        test::addQuad(scene.mesh, {-1, height, -1}, {2, 0, 0}, {0, 0, 2}, 0);
        EXPECT_EQ(Drawn(scene, serial).open(glm::dvec3(0.0)), 0.0f);
        scene.lights[0].nearRange = 1.0f;
        EXPECT_EQ(Drawn(scene, serial).open(glm::dvec3(0.0)), height == 1.0f ? 0.0f : 1.0f);
        scene.lights[0].nearRange = 0.0f;
        scene.lights[0].farRange = 2.0f;
        EXPECT_EQ(Drawn(scene, serial).open(glm::dvec3(0.0)), height == 1.0f ? 1.0f : 0.0f);
    }
}

TEST(ShadowMap, HoldsNoLightThatIsTooWide) {
    Scene scene = floorBelowALight();
    scene.lights[0].aperture = 170.0f;
    checkShadowMap(scene.lights[0]);
    scene.lights[0].aperture = 171.0f;
    EXPECT_THROW(checkShadowMap(scene.lights[0]), InputError);
}

RenderSettings settings(LightVisibility visibility) {
    RenderSettings result;
    result.grid.width = 96;
    result.grid.height = 64;
    result.samples = 2;
    result.visibility = visibility;
    return result;
}

RenderResult render(const Scene& scene, LightVisibility visibility, Backend& backend) {
    return Renderer(scene, settings(visibility), backend).render();
}

size_t passesOf(const RenderResult& result, const std::string& name) {
    return (size_t) std::count_if(result.passes.begin(), result.passes.end(),
                                  [&](const PassTime& pass) { return pass.name == name; });
}

uint64_t bytesOf(const Backend& backend, const std::string& name) {
    for (const BufferSize& buffer : backend.memory())
        if (buffer.name == name) return buffer.bytes;
    return 0;
}

TEST(ShadowMap, IsThereOnlyWhereItIsAskedFor) {
    Scene scene = test::room();
    scene.lights[0].resolution = 128;
    ThreadPool pool(2);
    CpuBackend backend(pool);
    // The same backend, so that what one frame had is gone in the next.
    for (const LightVisibility visibility :
         {LightVisibility::shadowMap, LightVisibility::traced, LightVisibility::shadowMap}) {
        const bool mapped = visibility == LightVisibility::shadowMap;
        const RenderResult result = render(scene, visibility, backend);
        EXPECT_EQ(passesOf(result, "ShadowMap"), mapped ? 1u : 0u);
        EXPECT_EQ(passesOf(result, "Visibility"), mapped ? 0u : 3u);
        EXPECT_EQ(result.counts.shadowRays == 0, mapped);
        EXPECT_EQ(bytesOf(backend, "shadow map"), mapped ? 128u * 128u * 4u : 0u);
        EXPECT_EQ(bytesOf(backend, "visibility") == 0, mapped);
        EXPECT_EQ(bytesOf(backend, "light grid") == 0, mapped);
        const Requirements need = requirementsOf(scene, settings(visibility), true);
        uint64_t planned = 0;
        for (const PlannedBuffer& row : planPaths(need, settings(visibility).grid)) {
            EXPECT_EQ(bytesOf(backend, row.name), row.bytes) << row.name;
            planned += row.name == "shadow map";
        }
        EXPECT_EQ(planned, mapped ? 1u : 0u);
    }
    scene.lights.clear();
    EXPECT_EQ(passesOf(render(scene, LightVisibility::shadowMap, backend), "ShadowMap"), 0u);
    EXPECT_EQ(bytesOf(backend, "shadow map"), 0u);
}

/// The same light but at shadows' borders.
TEST(ShadowMap, ShowsWhatTracedLightShows) {
    Scene scene = test::room();
    scene.lights[0].resolution = 1024;
    scene.materials[3].emission = glm::vec3(0.0f);
    scene.background = glm::vec3(0.0f);
    ThreadPool pool(2);
    CpuBackend backend(pool);
    RenderSettings choices = settings(LightVisibility::traced);
    choices.bounces = 1;
    const Image traced = Renderer(scene, choices, backend).render().image;
    choices.visibility = LightVisibility::shadowMap;
    const Image mapped = Renderer(scene, choices, backend).render().image;
    size_t different = 0, lit = 0;
    for (size_t i = 0; i < traced.pixels.size(); ++i) {
        const float a = traced.pixels[i].x, b = mapped.pixels[i].x;
        different += std::abs(a - b) > 1e-3f * std::max(a, b);
        lit += b > 0.0f;
    }
    EXPECT_GT(lit, traced.pixels.size() / 3);
    EXPECT_LT(different, traced.pixels.size() / 20);
}

#ifdef DIRT_HAVE_EMBREE
TEST(ShadowMap, IsTheSameUnderEmbree) {
    const LoadedScene loaded =
        loadScene(test::goldenFolder() / "scenes" / "cards_shadow_map.scene");
    ThreadPool pool(2);
    CpuBackend cpu(pool);
    EmbreeBackend embree(pool);
    const RenderResult a = render(loaded.scene, LightVisibility::shadowMap, cpu);
    const RenderResult b = render(loaded.scene, LightVisibility::shadowMap, embree);
    EXPECT_EQ(cpu.readShadowMap(), embree.readShadowMap());
    EXPECT_EQ(bytesOf(embree, "shadow map"), bytesOf(cpu, "shadow map"));
    size_t different = 0;
    for (size_t i = 0; i < a.image.pixels.size(); ++i)
        different += a.image.pixels[i] != b.image.pixels[i];
    EXPECT_LE(different, 2u); // a hit that Embree decides otherwise, which cross/ judges
}
#endif

} // namespace
} // namespace dirt
