// Exactness on whole scenes: all kinds of rays at the default settings, and the same rays at
// others, which must hit the same (T7). The long form casts what the claims are made of.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/trace/intersect.h"
#include "core/verify/verify.h"
#include "tests/support/random.h"
#include "tests/verify/places.h"

#ifdef DIRT_HAVE_EMBREE
#include "backend_embree/embree_backend.h"
#include "shaders/shared/margins.h"
#endif

#include <iostream>
#include <map>
#include <memory>

#include <gtest/gtest.h>

using namespace dirt;

namespace {

struct NamedSettings {
    std::string name;
    GridSettings grid;
};

/// What must not matter. In the cut form fine tiles go with a small image.
std::vector<NamedSettings> otherSettings(bool full) {
    const int width = full ? 1024 : 256, height = full ? 512 : 128;
    std::vector<NamedSettings> all{
        {"tile 1, 44 bins", {.width = width, .height = height, .tile = 1, .bins = 44}},
        {"tile 4, 16 bins", {.tile = 4, .bins = 16}},
        {"tile 64, 1 bin", {.tile = 64, .bins = 1}},
        {"1023x517", {.width = 1023, .height = 517}},
        {"linear", {.traversal = Traversal::linear}},
        {"single", {.mode = ViewMode::single}},
        {"single, tile 3", {.mode = ViewMode::single, .width = 333, .height = 201, .tile = 3}},
    };
    // 512 pixels a face, 16 a tile: 32 tiles, levels 0 to 5.
    for (int level = 0; level <= (full ? 5 : 1); level++)
        all.push_back({"max-mip " + std::to_string(level), {.maxMip = level}});
    return all;
}

/// Loading and generating take longer than casting a few rays: each scene is loaded once.
const Scene* loadOnce(const test::Place& place) {
    static std::map<std::string, std::optional<Scene>> loaded;
    auto [entry, isNew] = loaded.try_emplace(place.name);
    if (isNew) entry->second = test::loadPlace(place, test::cases(30'000, 300'000));
    return entry->second ? &*entry->second : nullptr;
}

class Scenes : public testing::TestWithParam<test::Place> {
protected:
    ThreadPool pool_;
    CpuBackend cpu_{pool_};
    const Scene* scene_ = nullptr;
    FrameGeometry geometry_;
    std::vector<std::unique_ptr<Backend>> peers_; ///< built over geometry_

    void SetUp() override {
        scene_ = loadOnce(GetParam());
        if (!scene_) GTEST_SKIP() << GetParam().file << " is not in " << scenesFolder();
        enter(ViewMode::full);
    }

    /// Makes the geometry of a view mode, and Embree's scenes over it where there is Embree.
    void enter(ViewMode mode) {
        peers_.clear();
        geometry_ = makeFrameGeometry(scene_->mesh, scene_->camera, mode);
#ifdef DIRT_HAVE_EMBREE
        for (const bool robust : {false, true})
            peers_.push_back(std::make_unique<EmbreeBackend>(pool_, robust, EmbreeDecision::plain));
#endif
        for (const auto& peer : peers_) peer->build(geometry_, scene_->camera, {});
    }

    std::vector<KindReport> verify(const GridSettings& grid, uint32_t rays,
                                   const std::string& settings) {
        if (grid.mode != geometry_.frame.mode) enter(grid.mode);
        cpu_.build(geometry_, scene_->camera, grid);
        std::vector<Tracer*> backends{&cpu_};
        for (const auto& peer : peers_) backends.push_back(peer.get());
        VerifySettings verify;
        verify.rays = rays;
        verify.agreeing = std::min(rays, verify.agreeing);
        Verifier verifier(geometry_, scene_->camera, grid, backends, verify, pool_);
        std::vector<KindReport> reports;
        for (const RayKind kind : kRayKinds) {
            const KindReport report = verifier.run(kind);
            const BackendReport& ours = report.backends[0];
            const std::string label = settings + ", " + std::string(rayKindName(kind)) +
                                      " rays; `dirt verify` tells more";
            EXPECT_EQ(ours.missed, 0u) << label;
            EXPECT_EQ(ours.falseHits, 0u) << label;
            EXPECT_EQ(ours.wrongPrimitive, 0u) << label;
            EXPECT_LE(ours.maxRelativeTError, kRelativeErrorT) << label;
            EXPECT_GT(report.rays, 0u) << label;
            reports.push_back(report);
        }
        return reports;
    }
};

} // namespace

TEST_P(Scenes, EveryHitIsExact) {
    const auto rays = (uint32_t) test::cases(1'000, 1'000'000);
    for (const KindReport& report : verify({}, rays, "defaults")) {
        std::cout << rayKindName(report.kind) << " " << report.rays << ", wrong:";
        for (size_t b = 0; b < report.backends.size(); b++)
            std::cout << (b == 0   ? " dirt "
                          : b == 1 ? ", Embree "
                                   : ", Embree robust ")
                      << report.backends[b].errors();
        std::cout << std::endl;
    }
}

TEST_P(Scenes, SettingsDoNotMatter) {
    for (const NamedSettings& settings : otherSettings(test::fullTests()))
        verify(settings.grid, (uint32_t) test::cases(100, 100'000), settings.name);
}

INSTANTIATE_TEST_SUITE_P(Places, Scenes, testing::ValuesIn(test::places()),
                         [](const auto& info) { return info.param.name; });
