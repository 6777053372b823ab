// Shadow rays looked up in the light grid against core's anyHit, with every instruction set this
// machine has.

#include "backend_cpu/light/light_grid.h"

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/io/load.h"
#include "core/path/grid_spotlight.h"
#include "core/trace/offset.h"
#include "tests/io/test_scenes.h"
#include "tests/support/print.h"
#include "tests/support/simd_targets.h"
#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

namespace dirt::test {
namespace {

/// A grid with its leaves and its light grid.
struct LitScene {
    const FrameGeometry& geometry;
    Grid grid;
    Leaves leaves;
    LightGrid light;

    LitScene(const FrameGeometry& geometry, const Camera& camera, const GridSettings& settings,
             const Spotlight& spotlight)
        : geometry(geometry), grid(buildGrid(geometry, camera, settings)) {
        SerialExecutor serial;
        fillLeaves(geometry, grid, serial, leaves);
        fillLightGrid(geometry, spotlight, serial, light);
    }
};

struct ShadowRays {
    std::vector<Ray> rays;
    std::vector<float> maxT;

    void add(const LightGrid& light, glm::vec3 origin, uint32_t skip, float end) {
        rays.push_back({origin, light.position - origin, skip});
        maxT.push_back(end);
    }
};

/// Compares all answers with core's, with every target. Returns what was done for the last.
LeafCounts expectEqual(const LitScene& s, const ShadowRays& asked, const std::string& what) {
    std::vector<uint8_t> expected;
    for (size_t i = 0; i < asked.rays.size(); ++i)
        expected.push_back(anyHit(s.grid, s.geometry, asked.rays[i], asked.maxT[i]));
    const LeafTracer tracer(s.geometry, s.grid, s.leaves, &s.light);
    LeafCounts counts;
    forEachTarget([&] {
        std::vector<uint8_t> occluded(asked.rays.size());
        tracer.occluded(asked.rays, asked.maxT, occluded, &counts);
        for (size_t i = 0; i < occluded.size(); ++i)
            ASSERT_EQ(occluded[i], expected[i]) << "up to " << hex(asked.maxT[i]) << "\n"
                                                << hex(asked.rays[i]) << "\n"
                                                << hex(s.light.position) << "\n"
                                                << what;
    });
    return counts;
}

const glm::vec3& vertex(const Triangle& t, int i) {
    return i == 0 ? t.a : i == 1 ? t.b : t.c;
}

/// A point of the triangle, often on an edge or a vertex.
glm::vec3 pointOf(const Triangle& t, Random& random) {
    const glm::dvec3 a(vertex(t, random.below(3))), b(vertex(t, random.below(3))), c(t.c);
    const double u = random.uniform(), v = random.chance(0.3) ? random.uniform() * (1.0 - u) : 0.0;
    return glm::vec3(a * (1.0 - u - v) + b * u + c * v);
}

/// Origins of shadow rays: on surfaces, as a renderer asks for them; behind points of edges, as the
/// light sees them, or a little beside; anywhere.
glm::vec3 originFor(const LitScene& s, uint32_t& skip, Random& random) {
    const auto& triangles = s.geometry.triangles;
    const uint32_t id = (uint32_t) random.below((int) triangles.size());
    const Triangle& t = triangles[id];
    const glm::dvec3 light(s.light.position);
    skip = random.chance(0.2) ? id : kNoPrimitive;
    switch (random.below(6)) {
    case 0: {
        skip = id;
        const float u = (float) random.uniform(), v = (float) random.uniform() * (1.0f - u);
        return offsetOrigin(t, u, v, s.light.position - t.a);
    }
    case 1:
        return uniformPoint(random, 1.5);
    case 2: {
        // Beside an edge, as far as the geometry's rounding or the margins reach.
        const glm::dvec3 aside(uniformPoint(random, 1.0));
        const glm::dvec3 p = glm::dvec3(pointOf(t, random)) - light;
        return glm::vec3(light + p * (1.0 + random.wide(-8, 1)) +
                         aside * random.wide(-9, -4) * glm::length(p));
    }
    default: {
        const glm::dvec3 p = glm::dvec3(pointOf(t, random)) - light;
        const double far = random.pick({1.0, 1.5, 2.0, 4.0, 1.0 + random.uniform() * 1e-3});
        return glm::vec3(light + p * far);
    }
    }
}

glm::vec3 positionFor(const std::vector<Triangle>& triangles, Random& random) {
    const Triangle& t = triangles[random.below((int) triangles.size())];
    switch (random.below(8)) {
    case 0:
        return glm::vec3(0.0f);
    case 1: // in the triangle's plane
        return t.a + 1.5f * (t.b - t.a);
    case 2: // beside the triangle
        return pointOf(t, random) + uniformPoint(random, random.wide(-6, -2));
    case 3:
        return uniformPoint(random, 100.0);
    default:
        return uniformPoint(random, 1.2);
    }
}

TEST(LightGrid, AnswersAsCoreOnNastyScenes) {
    Random random(81);
    uint64_t rays = 0, lookups = 0;
    for (int round = 0; round < cases(150, 20000); ++round) {
        const ViewSet set = random.chance(0.8) ? fullViews(16, 1) : singleView(16, 12, 1, 70.0f);
        FrameGeometry geometry;
        geometry.frame.mode = set.settings.mode;
        geometry.triangles = smallScene(random, set);
        Spotlight light;
        light.position = positionFor(geometry.triangles, random);
        light.target = random.chance(0.5) ? glm::vec3(0.0f) : uniformPoint(random, 1.0);
        light.aperture = random.pick({1.0f, 30.0f, 90.0f, 160.0f, 200.0f, 360.0f});
        light.conical = random.chance(0.8);
        // About as near to the light as the rays' rounding lets them miss it.
        if (random.chance(0.3))
            for (int i = 0; i < 4; ++i) {
                const double distance = std::pow(10.0, random.uniform(-8, -5));
                const auto corner = [&] { return light.position + uniformPoint(random, distance); };
                geometry.triangles.push_back({corner(), corner(), corner()});
            }
        const LitScene scene(geometry, set.camera, set.settings, light);
        ShadowRays asked;
        for (int i = 0; i < 300; ++i) {
            uint32_t skip = kNoPrimitive;
            const glm::vec3 origin = originFor(scene, skip, random);
            asked.add(scene.light, origin, skip,
                      random.chance(0.8) ? 1.0f : (float) random.uniform(0, 1.2));
            // Some that do not end in the light.
            glm::vec3& direction = asked.rays.back().direction;
            if (random.chance(0.02)) direction *= random.pick({0.5f, 2.0f, -1.0f});
            if (random.chance(0.02)) direction[random.below(3)] *= 1.0f + 0x1p-22f;
            if (random.chance(0.02)) direction = uniformPoint(random, 1.0);
        }
        lookups +=
            expectEqual(scene, asked, describe(set) + " round " + std::to_string(round)).lookups;
        if (HasFatalFailure()) return;
        rays += asked.rays.size();
    }
    EXPECT_GT(lookups, rays / 3) << "most rays must take the path under test";
}

/// The shadow rays of a frame, and others aimed at edges.
TEST(LightGrid, AnswersAsCoreOnRealScenes) {
    const std::filesystem::path sponza = scenesFolder() / "crytek-sponza" / "sponza.obj";
    const std::filesystem::path conference = scenesFolder() / "conference" / "conference.obj";
    int scenes = 0;
    for (const auto& [file, eye, lamp] :
         {std::tuple{sponza, glm::vec3(-1100, 250, -50), glm::vec3(0, 1500, 0)},
          std::tuple{conference, glm::vec3(900, 400, 500), glm::vec3(800, 450, 450)}}) {
        if (!std::filesystem::exists(file)) continue;
        ++scenes;
        const LoadedScene loaded = loadScene(file.string(), {});
        Camera camera;
        camera.eye = eye;
        camera.target = glm::vec3(0, 200, 0);
        const GridSettings settings;
        const FrameGeometry geometry = makeFrameGeometry(loaded.scene.mesh, camera, settings.mode);
        Spotlight light;
        light.position = lamp;
        light.target = camera.target;
        light.aperture = 150.0f;
        const LitScene scene(geometry, camera, settings, light);
        ASSERT_FALSE(scene.light.empty());
        Random random(82);
        ShadowRays asked;
        for (int i = 0; i < cases(20000, 2000000); ++i) {
            uint32_t skip = kNoPrimitive;
            const glm::vec3 origin = originFor(scene, skip, random);
            asked.add(scene.light, origin, skip, 1.0f);
        }
        const LeafCounts counts = expectEqual(scene, asked, file.string());
        if (HasFatalFailure()) return;
        EXPECT_GT(counts.lookups, asked.rays.size() / 4);
    }
    if (scenes == 0) GTEST_SKIP() << "no scenes in " << scenesFolder();
}

/// Most of the triangles in a thousandth of what the light shines on, on two large ones: tiles
/// follow them, so that no ray has to look at many.
TEST(LightGrid, AnswersAsCoreUnderAFarSun) {
    Random random(87);
    FrameGeometry geometry;
    const float ground = -0.02f;
    for (const float side : {-1.0f, 1.0f})
        geometry.triangles.push_back(
            {{-1.5f, ground, -1.5f}, {1.5f, ground, 1.5f}, {1.5f * side, ground, -1.5f * side}});
    constexpr size_t kSmall = 8000;
    for (size_t i = 0; i < kSmall; ++i) {
        const glm::vec3 centre = uniformPoint(random, 0.02);
        const auto corner = [&] { return centre + uniformPoint(random, 5e-4); };
        geometry.triangles.push_back({corner(), corner(), corner()});
    }
    Spotlight light;
    light.target = glm::vec3(0.0f);
    light.aperture = 110.0f;
    for (const float distance : {1.0f, 30.0f}) {
        light.position = glm::vec3(-0.9f, 0.4f, 0.2f) * distance;
        const LitScene scene(geometry, Camera{}, GridSettings{}, light);
        ASSERT_FALSE(scene.light.empty());
        uint32_t longest = 0;
        for (size_t i = 0; i < scene.light.tree.tiles; ++i)
            longest = std::max(longest, scene.light.heads[i + 1] - scene.light.heads[i]);
        EXPECT_LT(longest, kSmall / 5) << "of equal tiles one holds nearly all";
        ShadowRays asked;
        for (int i = 0; i < cases(4000, 200000); ++i) {
            uint32_t skip = kNoPrimitive;
            const glm::vec3 origin = originFor(scene, skip, random);
            asked.add(scene.light, origin, skip, 1.0f);
        }
        const LeafCounts counts =
            expectEqual(scene, asked, "the sun at " + std::to_string(distance));
        if (HasFatalFailure()) return;
        EXPECT_GT(counts.lookups, asked.rays.size() / 2);
    }
}

/// A lamp's bulb: more triangles around the light than are worth testing with each ray.
TEST(LightGrid, IsLeftOutWhereMuchIsBesideTheLight) {
    Random random(85);
    FrameGeometry geometry;
    addRoom(random, geometry.triangles);
    Spotlight light;
    light.position = glm::vec3(0.01f, 0.02f, 0.03f);
    SerialExecutor serial;
    LightGrid grid;
    const auto fill = [&](double distance) {
        geometry.triangles.resize(12);
        for (int i = 0; i < 20; ++i) {
            const auto corner = [&] { return light.position + uniformPoint(random, distance); };
            geometry.triangles.push_back({corner(), corner(), corner()});
        }
        fillLightGrid(geometry, light, serial, grid);
        return !grid.empty();
    };
    EXPECT_FALSE(fill(1e-5));
    EXPECT_TRUE(fill(1.0));
}

/// The backend answers the same with and without; only where a light is expected does it build.
TEST(LightGrid, BelongsToABuildThatExpectsALight) {
    Random random(86);
    FrameGeometry geometry;
    addRoom(random, geometry.triangles);
    addSphere(random, geometry.triangles, 8, 5);
    Spotlight light;
    light.position = glm::vec3(0.0f, 0.05f, 0.0f);
    SerialExecutor serial;
    CpuBackend backend(serial);
    const auto hasLightGrid = [&] {
        for (const BufferSize& size : backend.memory())
            if (size.name == "light grid") return size.bytes > 0;
        return false;
    };
    const GridSettings settings;
    backend.build(geometry, Camera{}, settings);
    EXPECT_FALSE(hasLightGrid());
    backend.expectLight(&light);
    backend.build(geometry, Camera{}, settings);
    EXPECT_TRUE(hasLightGrid());
    backend.writeGrid(backend.readGrid());
    EXPECT_FALSE(hasLightGrid()) << "rays go through what was written";
    backend.expectLight(nullptr);
    backend.build(geometry, Camera{}, settings);
    EXPECT_FALSE(hasLightGrid());
}

} // namespace
} // namespace dirt::test
