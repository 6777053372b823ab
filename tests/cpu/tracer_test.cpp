// The SIMD traversal against core's, which is its definition: the same hits to the bit, with every
// instruction set this machine has.

#include "backend_cpu/trace/tracer.h"

#include "backend_cpu/thread_pool.h"
#include "core/grid/repeated.h"
#include "core/io/load.h"
#include "core/verify/ray_kinds.h"
#include "tests/io/test_scenes.h"
#include "tests/support/final_hits.h"
#include "tests/support/grid_rays.h"
#include "tests/support/print.h"
#include "tests/support/simd_targets.h"
#include "tests/support/small_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cfloat>

namespace dirt::test {
namespace {

bool sameHit(const Hit& a, const Hit& b) {
    return a.primitive == b.primitive &&
           std::bit_cast<uint32_t>(a.t) == std::bit_cast<uint32_t>(b.t) &&
           std::bit_cast<uint32_t>(a.u) == std::bit_cast<uint32_t>(b.u) &&
           std::bit_cast<uint32_t>(a.v) == std::bit_cast<uint32_t>(b.v);
}

bool lists(const Grid& grid, const Hit& hit) {
    if (hit.view == grid.views.size())
        return std::binary_search(grid.atEye.begin(), grid.atEye.end(), hit.primitive);
    for (int bin = 0; bin < grid.settings.bins; ++bin) {
        const auto list = grid.list((int) hit.view, (int) hit.tile, bin);
        if (std::binary_search(list.begin(), list.end(), hit.primitive)) return true;
    }
    return false;
}

/// A grid with its leaves.
struct Structure {
    const FrameGeometry& geometry;
    Grid grid;
    Leaves leaves;

    Structure(const FrameGeometry& geometry, const Camera& camera, const GridSettings& settings)
        : geometry(geometry), grid(buildGrid(geometry, camera, settings)) {
        SerialExecutor serial;
        fillLeaves(geometry, grid, serial, leaves);
    }
};

struct Asked {
    std::vector<Ray> rays;
    std::vector<Hit> nearest; ///< core's answers
    std::vector<float> maxT;
    std::vector<uint8_t> occluded;

    void add(const Structure& s, const Ray& ray, Random& random) {
        rays.push_back(ray);
        nearest.push_back(closestHit(s.grid, s.geometry, ray));
        const float t = nearest.back().t;
        maxT.push_back(random.pick({t, std::nextafter(t, INFINITY), FLT_MAX, 0.5f, 0.0f}));
        occluded.push_back(anyHit(s.grid, s.geometry, ray, maxT.back()));
    }
};

/// Compares all answers, with every target. Returns how many rays were left to core.
LeafCounts expectEqual(const Structure& s, const Asked& asked, const std::string& what) {
    const LeafTracer tracer(s.geometry, s.grid, s.leaves);
    LeafCounts counts;
    forEachTarget([&] {
        std::vector<Hit> hits(asked.rays.size());
        std::vector<uint8_t> occluded(asked.rays.size());
        tracer.closest(asked.rays, hits, &counts);
        tracer.occluded(asked.rays, asked.maxT, occluded);
        for (size_t i = 0; i < hits.size(); ++i) {
            ASSERT_TRUE(sameHit(hits[i], asked.nearest[i]))
                << hits[i].primitive << " at " << hex(hits[i].t) << " for "
                << asked.nearest[i].primitive << " at " << hex(asked.nearest[i].t) << "\n"
                << hex(asked.rays[i]) << "\n"
                << what;
            ASSERT_EQ(occluded[i], asked.occluded[i]) << "up to " << hex(asked.maxT[i]) << "\n"
                                                      << hex(asked.rays[i]) << "\n"
                                                      << what;
            ASSERT_TRUE(!hits[i].found() || lists(s.grid, hits[i]))
                << "the hit's tile does not list it\n"
                << hex(asked.rays[i]) << "\n"
                << what;
        }
    });
    return counts;
}

ViewSet randomViews(Random& random) {
    GridSettings settings;
    settings.mode = random.chance(0.8) ? ViewMode::full : ViewMode::single;
    settings.tile = random.pick({1, 1, 2, 7, 16});
    const int tiles = random.pick({1, 2, 3, 8, 17, 32, 64});
    settings.viewSize = std::max(1, tiles * settings.tile - random.below(settings.tile));
    settings.width = settings.viewSize + random.below(40);
    settings.height = settings.viewSize;
    settings.bins = random.pick({1, 2, 16, 44, 256});
    Camera camera;
    camera.verticalFov = random.pick({1.0f, 30.0f, 90.0f, 150.0f, 170.0f});
    return {settings, camera};
}

TEST(LeafTracer, EqualsCoreOnNastyScenes) {
    Random random(61);
    uint64_t rays = 0, scalar = 0;
    for (int round = 0; round < cases(40, 3000); ++round) {
        const ViewSet set = randomViews(random);
        FrameGeometry geometry;
        geometry.triangles = smallScene(random, set);
        const Structure structure(geometry, set.camera, set.settings);
        GridRays source(random, set, geometry.triangles);
        Asked asked;
        for (int i = 0; i < 250; ++i) {
            Ray ray = source.next().ray;
            if (random.chance(0.1))
                ray.skip = (uint32_t) random.below((int) geometry.triangles.size());
            asked.add(structure, ray, random);
        }
        const LeafCounts counts =
            expectEqual(structure, asked,
                        describe(set) + " bins " + std::to_string(set.settings.bins) + " round " +
                            std::to_string(round));
        if (HasFatalFailure()) return;
        rays += asked.rays.size();
        scalar += counts.scalar;
    }
    EXPECT_LT(scalar, rays / 5) << "most rays must take the path under test";
}

/// Long lists: trees of several levels in one tile, all sizes of blocks and nodes.
TEST(LeafTracer, EqualsCoreOnLongLists) {
    Random random(62);
    for (const int count : {1, 15, 16, 17, 33, 255, 256, 257, 272, 400, 2500, 12000}) {
        FrameGeometry geometry;
        const double size = 0.6 / std::cbrt(count);
        for (int i = 0; i < count; ++i) {
            const glm::vec3 centre = glm::vec3(0.5f, 0.5f, 1.0f) + uniformPoint(random, 0.4);
            const auto corner = [&] { return centre + uniformPoint(random, size); };
            geometry.triangles.push_back({corner(), corner(), corner()});
        }
        const ViewSet set = fullViews(2, 1);
        GridSettings settings = set.settings;
        settings.bins = random.pick({1, 3});
        const Structure structure(geometry, set.camera, settings);
        GridRays source(random, set, geometry.triangles);
        Asked asked;
        for (int i = 0; i < cases(200, 2000); ++i) asked.add(structure, source.next().ray, random);
        expectEqual(structure, asked, std::to_string(count) + " triangles");
        if (HasFatalFailure()) return;
    }
}

TEST(LeafTracer, RaysThatAreNoneHitNothing) {
    FrameGeometry geometry;
    geometry.triangles = {{{-1, -1, 0.5f}, {1, -1, 0.5f}, {0, 1, 0.5f}}};
    const ViewSet set = fullViews(16, 4);
    const Structure structure(geometry, set.camera, set.settings);
    Random random(63);
    Asked asked;
    for (float bad : {std::nanf(""), INFINITY, -INFINITY})
        for (int i = 0; i < 6; ++i) {
            Ray ray{{0, 0, 0}, {0, 0, 1}};
            (i < 3 ? ray.origin : ray.direction)[i % 3] = bad;
            asked.add(structure, ray, random);
        }
    asked.add(structure, {{0, 0, 0}, {0, 0, 0}}, random);
    expectEqual(structure, asked, "");
}

/// A ray that meets a box in one corner alone, which is a vertex, passes two planes at once.
TEST(LeafTracer, MeetsABoxInItsCorner) {
    Random random(66);
    int hits = 0;
    for (int round = 0; round < cases(1000, 20000); ++round) {
        const auto offset = [&] { return (float) random.range(1, 400) * 0x1p-12f; };
        const glm::vec3 corner(offset(), offset(), 0.5f + offset());
        FrameGeometry geometry;
        geometry.triangles = {{corner, corner + glm::vec3(offset(), offset(), offset()),
                               corner + glm::vec3(offset(), offset(), offset())}};
        const ViewSet set = fullViews(1, 1);
        const Structure structure(geometry, set.camera, set.settings);
        Asked asked;
        for (int i = 0; i < 8; ++i) {
            // Up along one axis and down along another; the corner is hit exactly.
            glm::vec3 d(16.0f * offset(), -16.0f * offset(), 0.0f);
            for (int turn = random.below(3); turn > 0; --turn) d = {d.z, d.x, d.y};
            if (random.chance(0.5)) d = -d;
            asked.add(structure, {corner - (float) random.range(1, 9) * d, d}, random);
            hits += asked.nearest.back().found();
        }
        expectEqual(structure, asked, hex(geometry.triangles[0]));
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(hits, 4000);
}

TEST(LeafTracer, LeavesRaysThatPassTheEyeToCore) {
    FrameGeometry geometry;
    geometry.triangles = {{{-1, -1, 0.5f}, {1, -1, 0.5f}, {0, 1, 0.5f}}};
    const ViewSet set = fullViews(16, 4);
    const Structure structure(geometry, set.camera, set.settings);
    const LeafTracer tracer(geometry, structure.grid, structure.leaves);
    const auto leftToCore = [&](const Ray& ray) {
        Hit hit;
        LeafCounts counts;
        tracer.closest({&ray, 1}, {&hit, 1}, &counts);
        return counts.scalar == 1;
    };
    EXPECT_TRUE(leftToCore({{1, 0x1p-27f, 0}, {-1, 0, 0}}));
    EXPECT_FALSE(leftToCore({{1, 0x1p-24f, 0}, {-1, 0, 0}}));
    EXPECT_FALSE(leftToCore({{0, 0, 0}, {-1, 0, 0}})) << "from the eye itself";
    // Of numbers that the tests' bounds do not cover.
    EXPECT_TRUE(leftToCore({{1, 1, 0}, {0x1p-41f, 0, 0}}));
    EXPECT_TRUE(leftToCore({{0x1p21f, 1, 0}, {1, 0, 0}}));
}

/// Real geometry, through every kind of ray that verify casts.
TEST(LeafTracer, EqualsCoreOnRealScenes) {
    const std::filesystem::path sponza = scenesFolder() / "crytek-sponza" / "sponza.obj";
    const std::filesystem::path conference = scenesFolder() / "conference" / "conference.obj";
    int scenes = 0;
    for (const auto& [file, eye] : {std::pair{sponza, glm::vec3(-1100, 250, -50)},
                                    std::pair{conference, glm::vec3(900, 400, 500)}}) {
        if (!std::filesystem::exists(file)) continue;
        ++scenes;
        const LoadedScene loaded = loadScene(file.string(), {});
        Camera camera;
        camera.eye = eye;
        camera.target = glm::vec3(0, 200, 0);
        const GridSettings settings;
        const FrameGeometry geometry = makeFrameGeometry(loaded.scene.mesh, camera, settings.mode);
        const Structure structure(geometry, camera, settings);
        const RaySource source(geometry, camera, settings, 5);
        Random random(67);
        Asked asked;
        for (uint32_t i = 0; i < (uint32_t) cases(1000, 20000); ++i) {
            for (const RayKind kind : kRayKinds)
                if (kind != RayKind::diffuse) asked.add(structure, source.make(kind, i), random);
            const Hit seen = closestHit(structure.grid, geometry, source.primary(i));
            if (!seen.found()) continue;
            if (const auto ray = source.diffuse(i, seen)) asked.add(structure, *ray, random);
        }
        expectEqual(structure, asked, file.string());
        if (HasFatalFailure()) return;
    }
    if (scenes == 0) GTEST_SKIP() << "no scenes in " << scenesFolder();
}

/// A triangle that holds the eye is in no tile.
TEST(LeafTracer, FindsWhatHoldsTheEye) {
    FrameGeometry geometry;
    geometry.triangles = {{{-1, -1, 0.5f}, {1, -1, 0.5f}, {0, 1, 0.5f}},
                          {{-1, 0, -1}, {1, 0, -1}, {0, 0, 1}}};
    const ViewSet set = fullViews(16, 4);
    const Structure structure(geometry, set.camera, set.settings);
    Random random(64);
    Asked asked;
    for (const Ray& ray : {Ray{{0, -0.5f, 0}, {0, 1, 0}},
                           {{0, 0, 0}, {0, 0.1f, 1}},
                           {{0, 0, 0}, {0, 0, 1}},
                           {{-0.25f, -0.5f, 0.75f}, {0.25f, 0.5f, -0.75f}}})
        asked.add(structure, ray, random);
    EXPECT_EQ(asked.nearest[0].primitive, 1u);
    EXPECT_EQ(asked.nearest[1].primitive, 0u) << "from the eye itself";
    expectEqual(structure, asked, "");
}

std::vector<uint8_t> bytesOf(const Leaves& leaves) {
    std::vector<uint8_t> bytes;
    const auto add = [&](const auto& things) {
        const auto* first = reinterpret_cast<const uint8_t*>(things.data());
        bytes.insert(bytes.end(), first, first + things.size() * sizeof(things[0]));
    };
    add(leaves.tiles), add(leaves.nodes), add(leaves.blocks);
    return bytes;
}

/// Also: the same for any number of threads, on every instruction set.
TEST(Leaves, HoldEachListWithoutWhatHasNoArea) {
    Random random(65);
    for (int round = 0; round < 20; ++round) {
        const ViewSet set = randomViews(random);
        FrameGeometry geometry;
        geometry.triangles = smallScene(random, set);
        const Structure s(geometry, set.camera, set.settings);
        ThreadPool pool(3);
        Leaves again;
        fillLeaves(geometry, s.grid, pool, again);
        EXPECT_EQ(bytesOf(again), bytesOf(s.leaves));
        SerialExecutor serial;
        forEachTarget([&] {
            fillLeaves(geometry, s.grid, serial, again);
            EXPECT_EQ(bytesOf(again), bytesOf(s.leaves));
        });

        std::vector<uint32_t> laidOut, listed;
        for (const LeafBlock& block : s.leaves.blocks)
            for (const uint32_t id : block.id)
                if (id != kNoPrimitive) laidOut.push_back(id);
        for (const uint32_t id : s.grid.ids) {
            const Triangle& t = geometry.triangles[id];
            if (t.a != t.b && t.b != t.c && t.c != t.a) listed.push_back(id);
        }
        std::ranges::sort(laidOut);
        std::ranges::sort(listed);
        EXPECT_TRUE(std::ranges::includes(listed, laidOut));
        // Those on a line are few, and no ray hits them; nor those that repeat the one before.
        std::vector<uint32_t> missing;
        std::ranges::set_difference(listed, laidOut, std::back_inserter(missing));
        for (const uint32_t id : missing) {
            if (isRepeated(geometry, id)) continue;
            const Triangle& t = geometry.triangles[id];
            const glm::dvec3 ab = glm::dvec3(t.b) - glm::dvec3(t.a);
            const glm::dvec3 ac = glm::dvec3(t.c) - glm::dvec3(t.a);
            const double largest = glm::length(ab) * glm::length(ac);
            EXPECT_LE(glm::length(glm::cross(ab, ac)), 0x1p-48 * largest) << hex(t);
        }
    }
}

/// A hit is final only where all that may be as near, as far as a float tells, has been seen.
TEST(LeafTracer, GoesOnWhereTheNextTileMayHoldANearerHit) {
    Random random(65);
    uint64_t scalar = 0;
    const int count = cases(300, 20000);
    for (int i = 0; i < count; ++i) {
        const auto [set, ray, geometry] = finalCase(random);
        const Structure structure(geometry, set.camera, set.settings);
        Asked asked;
        asked.add(structure, ray, random);
        scalar += expectEqual(structure, asked, "case " + std::to_string(i)).scalar;
        if (HasFatalFailure()) return;
    }
    EXPECT_LT(scalar, (uint64_t) count / 5);
}

/// A hit's record belongs to the first tile that may hold it, as far as a float tells.
TEST(LeafTracer, FilesHitsUnderTheFirstTileThatMayHoldThem) {
    Random random(14);
    for (int i = 0; i < cases(300, 20000); ++i) {
        const FiledCase c = filedCase(random);
        const Structure s(c.geometry, c.set.camera, c.set.settings);
        Hit hit;
        LeafTracer(s.geometry, s.grid, s.leaves).closest({&c.ray, 1}, {&hit, 1});
        ASSERT_TRUE(hit.found()) << hex(c.ray) << " in case " << i;
        ASSERT_EQ((int) hit.tile, c.tileOf(hit.t)) << hex(c.ray) << " in case " << i;
    }
}

} // namespace
} // namespace dirt::test
