// The CPU backend's image beside Embree's at the same seed: the same bits, but for pixels whose
// paths met different answers; and each such answer is decided exactly, in our favour or as a tie.

#ifdef DIRT_HAVE_EMBREE

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "backend_embree/embree_backend.h"
#include "core/frame/renderer.h"
#include "core/trace/intersect.h"
#include "core/verify/judge.h"
#include "shaders/shared/margins.h"
#include "tests/cross/recording_backend.h"
#include "tests/support/golden_scenes.h"
#include "tests/support/random.h"
#include "tests/verify/places.h"

#include <cstring>
#include <iostream>
#include <map>
#include <set>
#include <unordered_map>

#include <gtest/gtest.h>

using namespace dirt;

namespace {

template <class T>
bool sameBits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof(T)) == 0;
}

bool sameRay(const Ray& a, const Ray& b) {
    return sameBits(a.origin, b.origin) && sameBits(a.direction, b.direction) && a.skip == b.skip;
}

std::array<uint32_t, 7> bitsOf(const Ray& ray) {
    std::array<uint32_t, 7> bits;
    std::memcpy(bits.data(), &ray.origin, sizeof ray.origin);
    std::memcpy(bits.data() + 3, &ray.direction, sizeof ray.direction);
    bits[6] = ray.skip;
    return bits;
}

/// A frame and all that was asked of its backend.
struct Recorded {
    struct Event {
        std::vector<uint32_t> pixels;
        std::vector<Ray> rays;
        std::vector<Hit> hits;
    };
    std::vector<Event> events;
    std::vector<test::RecordingBackend::Occluded> shadows; ///< one entry per event
    RenderResult result;
};

Recorded render(const Scene& scene, const RenderSettings& settings, Backend& backend,
                Executor& executor) {
    test::RecordingBackend recording(backend, executor);
    Recorded recorded;
    RenderHooks hooks;
    hooks.observe = [&](uint32_t, int k) {
        const PathBuffers& paths = recording.paths();
        Recorded::Event& event = recorded.events.emplace_back();
        for (uint32_t pixel = 0; pixel < paths.rays.size(); pixel++) {
            const PathRay& ray = paths.rays[pixel];
            if (!paths.alive(k, pixel) || ray.direction == glm::vec3(0.0f)) continue;
            event.pixels.push_back(pixel);
            event.rays.push_back({ray.origin, ray.direction, ray.skip});
            event.hits.push_back(paths.hits[pixel]);
        }
    };
    recorded.result = Renderer(scene, settings, recording).render(hooks);
    recorded.shadows = std::move(recording.shadows);
    return recorded;
}

/// Compares two frames event by event, and remembers which pixels have a reason to differ.
class Comparison {
public:
    Comparison(const Judge& judge, const Recorded& ours, const Recorded& theirs)
        : judge_(judge), ours_(ours), theirs_(theirs) {
        const bool lit = !ours.shadows.empty();
        if (ours.events.size() != theirs.events.size() ||
            ours.shadows.size() != theirs.shadows.size() ||
            (lit && ours.shadows.size() != ours.events.size())) {
            object("the frames have not the same events");
            return;
        }
        for (size_t e = 0; e < ours.events.size(); e++) {
            compareHits(ours.events[e], theirs.events[e]);
            if (lit) compareShadows(ours.shadows[e], theirs.shadows[e], ours.events[e]);
        }
        compareImages();
    }

    size_t decided = 0;                  ///< answers that differ
    size_t ties = 0;                     ///< of these, theirs is right too
    size_t pixels = 0;                   ///< that differ in the image
    std::vector<std::string> objections; ///< what has no reason, or was decided against us

private:
    void object(const std::string& what) { objections.push_back(what); }
    void object(const std::string& what, uint32_t pixel) {
        if (!diverged_.contains(pixel)) object(what + ", pixel " + std::to_string(pixel));
    }

    void compareHits(const Recorded::Event& a, const Recorded::Event& b) {
        std::unordered_map<uint32_t, size_t> theirs;
        for (size_t i = 0; i < b.pixels.size(); i++) theirs[b.pixels[i]] = i;
        for (size_t i = 0; i < a.pixels.size(); i++) {
            const uint32_t pixel = a.pixels[i];
            const auto found = theirs.find(pixel);
            if (found == theirs.end()) {
                object("only our path goes on", pixel);
                continue;
            }
            compareHit(pixel, a.rays[i], a.hits[i], b.rays[found->second], b.hits[found->second]);
            theirs.erase(found);
        }
        for (const auto& [pixel, position] : theirs) object("only their path goes on", pixel);
    }

    void compareHit(uint32_t pixel, const Ray& ray, const Hit& ours, const Ray& theirRay,
                    const Hit& theirs) {
        if (!sameRay(ray, theirRay)) {
            object("the rays differ", pixel);
        } else if (ours.primitive != theirs.primitive) {
            const Verdict truth = judge_.nearest(ray);
            if (judge_.judge(ray, truth, ours).grade != Grade::right)
                object("our hit is wrong", pixel);
            ties += judge_.judge(ray, truth, theirs).grade == Grade::right;
            decided++;
            diverged_.insert(pixel);
        } else if (ours.t != theirs.t || ours.u != theirs.u || ours.v != theirs.v) {
            object("t or barycentrics differ", pixel);
        }
    }

    /// Shadow rays have no pixel: equal rays are found by their bits, and a difference excuses the
    /// pixels whose hit of this event the shadow ray leaves.
    void compareShadows(const test::RecordingBackend::Occluded& a,
                        const test::RecordingBackend::Occluded& b, const Recorded::Event& event) {
        std::map<std::array<uint32_t, 7>, size_t> theirs;
        for (size_t i = 0; i < b.rays.size(); i++) theirs[bitsOf(b.rays[i])] = i;
        for (size_t i = 0; i < a.rays.size(); i++) {
            const auto found = theirs.find(bitsOf(a.rays[i]));
            if (found == theirs.end() || a.result[i] == b.result[found->second]) continue;
            // Core decides by its float t, which errs by at most err(t).
            const Verdict truth = judge_.nearest(a.rays[i]);
            const double limit = a.maxT[i], error = limit * kRelativeErrorT;
            const bool right = a.result[i] ? truth.found() && truth.t < limit + error
                                           : !truth.found() || truth.t > limit - error;
            if (!right) object("our shadow is wrong");
            decided++;
            shadowDifferences_++;
            for (size_t p = 0; p < event.pixels.size(); p++)
                if (event.hits[p].primitive == a.rays[i].skip)
                    differentlyLit_.insert(event.pixels[p]);
        }
    }

    void compareImages() {
        const auto& a = ours_.result.image.pixels;
        const auto& b = theirs_.result.image.pixels;
        size_t byShadowAlone = 0;
        for (uint32_t pixel = 0; pixel < a.size(); pixel++) {
            if (sameBits(a[pixel], b[pixel])) continue;
            pixels++;
            if (diverged_.contains(pixel)) continue;
            if (!differentlyLit_.contains(pixel)) object("no reason to differ", pixel);
            byShadowAlone++;
        }
        if (byShadowAlone > shadowDifferences_) object("more pixels differ than shadows");
    }

    const Judge& judge_;
    const Recorded& ours_;
    const Recorded& theirs_;
    std::set<uint32_t> diverged_;       ///< pixels whose path has met different primitives
    std::set<uint32_t> differentlyLit_; ///< pixels on whose hit a shadow ray differed
    size_t shadowDifferences_ = 0;
};

/// Embree, blind to some triangles.
class Blind final : public HostBackend {
public:
    explicit Blind(Executor& executor) : HostBackend(executor), embree_(executor) {}

    std::string name() const override { return "blind"; }
    std::string device() const override { return ""; }
    void clear(const Camera&, const GridSettings&) override {}
    void fillPrimitives() override {
        left_ = *geometry_;
        for (size_t i = 0; i < left_.triangles.size(); i += 5) left_.triangles[i] = {};
        embree_.build(left_, Camera{}, GridSettings{});
    }
    void intersect(std::span<const Ray> rays, std::span<Hit> hits) override {
        embree_.intersect(rays, hits);
    }
    void occluded(std::span<const Ray> rays, std::span<const float> maxT,
                  std::span<uint8_t> result) override {
        embree_.occluded(rays, maxT, result);
    }

private:
    EmbreeBackend embree_;
    FrameGeometry left_;
};

RenderSettings settings() {
    RenderSettings settings;
    settings.grid.width = test::cases(160, 1024);
    settings.grid.height = test::cases(80, 512);
    settings.samples = 4;
    settings.bounces = 3;
    return settings;
}

/// A light beside the eye, as a bare OBJ gets.
void lightUp(Scene& scene) {
    Spotlight light;
    light.position = scene.camera.eye + glm::vec3(0.01f) * (scene.camera.target - scene.camera.eye);
    light.target = scene.camera.target;
    light.aperture = 120.0f, light.penumbra = 100.0f;
    scene.lights = {light};
    scene.background = glm::vec3(0.5f);
}

/// Renders on Embree, too, plain and robust, and compares.
void compare(const Scene& scene, const RenderSettings& settings, Backend& cpu, Executor& pool) {
    const Recorded ours = render(scene, settings, cpu, pool);
    FrameGeometry geometry = makeFrameGeometry(scene.mesh, scene.camera, settings.grid.mode);
    if (requirementsOf(scene, settings, true).cutOuts) geometry.cutOuts = &scene;
    const Judge judge(geometry);
    for (const bool robust : {false, true}) {
        EmbreeBackend embree(pool, robust);
        const Recorded theirs = render(scene, settings, embree, pool);
        const Comparison comparison(judge, ours, theirs);
        EXPECT_EQ(comparison.objections, std::vector<std::string>{});
        std::cout << embree.name() << ": " << comparison.decided << " answers differ, of these "
                  << comparison.ties << " ties; " << comparison.pixels << " of "
                  << ours.result.image.pixels.size() << " pixels" << std::endl;
    }
}

class CpuEmbreeGolden : public testing::TestWithParam<std::string> {};
class CpuEmbree : public testing::TestWithParam<test::Place> {};

} // namespace

TEST_P(CpuEmbree, SameBitsButWhereDecided) {
    auto scene = test::loadPlace(GetParam(), test::cases(30'000, 300'000));
    if (!scene) GTEST_SKIP() << GetParam().file << " is not in " << scenesFolder();
    if (scene->lights.empty()) lightUp(*scene);
    ThreadPool pool;
    CpuBackend cpu(pool);
    compare(*scene, settings(), cpu, pool);
}

TEST_P(CpuEmbreeGolden, SameBitsButWhereDecided) {
    const LoadedScene loaded = loadScene(test::goldenFolder() / "scenes" / (GetParam() + ".scene"));
    ThreadPool pool;
    CpuBackend cpu(pool);
    compare(loaded.scene, test::goldenSettings(loaded, 2), cpu, pool);
}

TEST(CpuEmbreeComparison, ObjectsToWrongHitsOfOursAlone) {
    // Two walls of triangles before the camera, the nearer one in the light's way.
    Scene scene;
    for (const float z : {-3.0f, -5.0f}) {
        for (int i = 0; i < 200; i++) {
            const auto first = (uint32_t) scene.mesh.positions.size();
            const float x = (float) (i % 20) * 0.3f - 3.0f, y = (float) (i / 20) * 0.3f - 1.5f;
            for (const glm::vec2 corner : {glm::vec2(0, 0), {0.27f, 0.02f}, {0.1f, 0.25f}})
                scene.mesh.positions.push_back({x + corner.x, y + corner.y, z});
            scene.mesh.triangles.push_back({first, first + 1, first + 2});
        }
    }
    const size_t count = scene.mesh.triangles.size();
    scene.mesh.normalIndices.assign(count, {kNoIndex, kNoIndex, kNoIndex});
    scene.mesh.texcoordIndices.assign(count, {kNoIndex, kNoIndex, kNoIndex});
    scene.mesh.materials.assign(count, 0);
    scene.materials.emplace_back();
    lightUp(scene);

    SerialExecutor serial;
    CpuBackend cpu(serial);
    Blind blind(serial);
    const Recorded sound = render(scene, settings(), cpu, serial);
    const Recorded broken = render(scene, settings(), blind, serial);
    const FrameGeometry geometry =
        makeFrameGeometry(scene.mesh, scene.camera, settings().grid.mode);
    const Judge judge(geometry);

    const Comparison inOurFavour(judge, sound, broken);
    EXPECT_EQ(inOurFavour.objections, std::vector<std::string>{});
    EXPECT_GT(inOurFavour.decided, 100u);
    EXPECT_GT(inOurFavour.pixels, 100u);
    EXPECT_EQ(inOurFavour.ties, 0u);

    const Comparison against(judge, broken, sound);
    EXPECT_GT(against.objections.size(), 100u);
}

INSTANTIATE_TEST_SUITE_P(Scenes, CpuEmbreeGolden, testing::ValuesIn(test::goldenScenes()),
                         [](const auto& info) { return info.param; });

INSTANTIATE_TEST_SUITE_P(Places, CpuEmbree, testing::ValuesIn([] {
                             const auto all = test::places();
                             return std::vector<test::Place>(all.begin(), all.begin() + 3);
                         }()),
                         [](const auto& info) { return info.param.name; });

#endif
