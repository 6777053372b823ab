// Whether dirt check notices a fault of the passes of a sample in GLSL, in the row of that pass,
// and counts it rightly: edited shaders, one fault each, and the number of records that are then
// wrong from the CPU's buffers.

#include "backend_cpu/cpu_backend.h"
#include "backend_gl/gl_backend.h"
#include "core/check/check.h"
#include "core/frame/renderer.h"
#include "tests/frame/shapes.h"
#include "tests/gl/edited_shaders.h"

#include <algorithm>
#include <functional>

namespace dirt::test {
namespace {

constexpr int kShadowMap = 50; ///< texels along it

RenderSettings smallImage() {
    RenderSettings settings;
    settings.grid.width = 48;
    settings.grid.height = 32;
    settings.grid.tile = 4;
    settings.grid.bins = 4;
    settings.samples = 1;
    return settings;
}

/// The buffers as the CPU has them.
struct Truth {
    std::vector<PathBuffers> events;       ///< after Shade
    std::vector<std::vector<uint8_t>> lit; ///< pixels that ask for the light, of each event
    std::vector<glm::vec3> image;
};

/// Lets all light pass.
class NoOccluders final : public Tracer {
public:
    std::string name() const override { return ""; }
    std::string device() const override { return ""; }
    std::vector<PassTime> build(const FrameGeometry&, const Camera&, const GridSettings&) override {
        return {};
    }
    void intersect(std::span<const Ray>, std::span<Hit>) override {}
    void occluded(std::span<const Ray>, std::span<const float>,
                  std::span<uint8_t> result) override {
        std::fill(result.begin(), result.end(), uint8_t(0));
    }
};

Truth truthOf(const Scene& scene, const RenderSettings& settings) {
    SerialExecutor executor;
    CpuBackend cpu(executor);
    Truth truth;
    RenderHooks hooks;
    hooks.observe = [&](uint32_t, int k) {
        PathBuffers paths = cpu.readPaths();
        truth.events.push_back(paths);
        NoOccluders none;
        FrameCounts counts;
        const FrameContext frame(scene, cpu.geometry(), settings,
                                 requirementsOf(scene, settings, true));
        passVisibility(frame, executor, none, k, paths, counts);
        truth.lit.push_back(paths.visibility);
    };
    truth.image = Renderer(scene, settings, cpu).render(hooks).image.pixels;
    return truth;
}

/// Wrong records of the pass that a fault is in, in path event \p k.
using Count = std::function<bool(const Truth& truth, int k, size_t pixel)>;

struct ShaderFault {
    std::string file, from, to;
    std::string pass;
    std::vector<std::string> buffers; ///< whose rows differ
    Count isWrong;
    int firstEvent = 1;
    Fetch fetch = Fetch::raster;
    ViewMode mode = ViewMode::full;
};

bool isThird(size_t pixel) {
    return pixel % 7 == 3;
}

/// Runs the check with the fault. The rows of the GL backend on the CPU's data must show exactly
/// what is wrong there; in the other direction the data itself is spoilt, but the row is the same.
void expectCaught(const ShaderFault& fault) {
    SCOPED_TRACE(fault.file + ": " + fault.to);
    const EditedShaders shaders;
    shaders.replace(fault.file, fault.from, fault.to);
    GlOptions options;
    options.shaders = shaders.files();
    SerialExecutor executor;
    CpuBackend cpu(executor);
    GlBackend gl(options);
    RenderSettings settings = smallImage();
    settings.fetch = fault.fetch;
    settings.grid.mode = fault.mode;
    const Scene scene = room();
    const Truth truth = truthOf(scene, settings);

    uint64_t caught = 0;
    for (const CheckRow& row : checkBackends(scene, settings, cpu, gl).rows) {
        const std::string name = row.pass + " " + std::to_string(row.event) + ", " + row.buffer +
                                 ", " + row.tested + " on " + row.source +
                                 (row.examples.empty() ? "" : ": " + row.examples[0]);
        const bool expected = row.pass == fault.pass && row.event >= fault.firstEvent &&
                              std::count(fault.buffers.begin(), fault.buffers.end(), row.buffer);
        if (!expected) {
            EXPECT_EQ(row.different, 0u) << name;
            continue;
        }
        if (row.tested == "cpu") {
            EXPECT_GT(row.different, 0u) << name;
            continue;
        }
        uint64_t wrong = 0;
        for (size_t i = 0; i < truth.image.size(); ++i) wrong += fault.isWrong(truth, row.event, i);
        if (row.pass == "DirectVisibility") { // some of the wrong ones may lie at an edge
            EXPECT_LE(row.different, wrong) << name;
            EXPECT_GE(row.different + row.withinTolerance, wrong) << name;
        } else {
            EXPECT_EQ(row.different, wrong) << name;
        }
        EXPECT_GT(wrong, 5u) << name;
        caught += row.different;
    }
    EXPECT_GT(caught, 0u);
}

TEST(CheckPasses, FindsNothingWhereNothingIsWrong) {
    SerialExecutor executor;
    CpuBackend cpu(executor);
    GlBackend gl;
    for (const ViewMode mode : {ViewMode::full, ViewMode::single}) {
        RenderSettings settings = smallImage();
        settings.grid.mode = mode;
        const CheckReport report = checkBackends(room(), settings, cpu, gl);
        EXPECT_TRUE(report.passed());
        for (const CheckRow& row : report.rows)
            EXPECT_EQ(row.equal + (row.pass == "DirectVisibility" ? row.withinTolerance : 0),
                      row.compared)
                << row.pass << " " << row.event << ", " << row.buffer;
    }
}

/// Lists that lack entries mislead rays in other ways on each backend; the rows of the passes that
/// trace them show nothing of it.
TEST(CheckPasses, ShowsAFaultOfTheListsInNoOtherPass) {
    const EditedShaders shaders;
    shaders.replace("fill_primitives.frag", "bin <= last", "bin < last");
    GlOptions options;
    options.shaders = shaders.files();
    SerialExecutor executor;
    CpuBackend cpu(executor);
    GlBackend gl(options);
    RenderSettings settings = smallImage();
    settings.primary = Primary::traced;
    const CheckReport report = checkBackends(room(), settings, cpu, gl);
    uint64_t rays = 0, wrong = 0;
    for (const CheckRow& row : report.rows) {
        if (row.pass == "Trace") rays += row.compared;
        if (row.buffer == "lists")
            wrong += row.different;
        else
            EXPECT_EQ(row.different, 0u) << row.pass << " " << row.event << ", " << row.buffer;
    }
    EXPECT_GT(rays, 0u);
    EXPECT_GT(wrong, 0u);
    EXPECT_EQ(report.means[0], report.means[1]);
}

/// Of a shader of ShadowMap; \p isWrong: whether a texel is then wrong, by its depth and place.
void expectShadowMapCaught(const std::string& file, const std::string& from, const std::string& to,
                           const std::function<bool(float depth, size_t texel)>& isWrong) {
    SCOPED_TRACE(file + ": " + to);
    const EditedShaders shaders;
    shaders.replace(file, from, to);
    GlOptions options;
    options.shaders = shaders.files();
    SerialExecutor executor;
    CpuBackend cpu(executor), other(executor);
    GlBackend gl(options);
    RenderSettings settings = smallImage();
    settings.visibility = LightVisibility::shadowMap;
    settings.bounces = 1;
    Scene scene = room();
    scene.lights[0].resolution = kShadowMap;
    Renderer(scene, settings, other).render();
    const std::vector<float> depths = other.readShadowMap();
    ASSERT_EQ(depths.size(), (size_t) kShadowMap * kShadowMap);
    uint64_t wrong = 0;
    for (size_t i = 0; i < depths.size(); ++i) wrong += isWrong(depths[i], i);
    EXPECT_GT(wrong, 5u);
    int rows = 0;
    for (const CheckRow& row : checkBackends(scene, settings, cpu, gl).rows) {
        EXPECT_EQ(row.different, row.pass == "ShadowMap" ? wrong : 0u)
            << row.pass << " " << row.event << ", " << row.buffer << ", " << row.tested << " on "
            << row.source;
        rows += row.pass == "ShadowMap";
    }
    EXPECT_EQ(rows, 2);
}

TEST(CheckPasses, CatchesFaultsOfShadowMap) {
    const auto isSeen = [](float depth) { return depth != kNothingCasts; };
    expectShadowMapCaught(
        "shadow_map.frag", "nearest = hit.t;",
        "nearest = (texel.y * frame.shadowMap.resolution + texel.x) % 7u == 3u\n"
        "              ? uintBitsToFloat(floatBitsToUint(hit.t) - 1u) : hit.t;",
        [&](float depth, size_t texel) { return isSeen(depth) && isThird(texel); });
    expectShadowMapCaught("shadow_map.frag", "castsShadow(frame.shadowMap, hit.t)", "false",
                          [&](float depth, size_t) { return isSeen(depth); });
}

TEST(CheckPasses, CatchesFaultsOfDirectVisibility) {
    const auto found = [](const Truth& t, int k, size_t i) {
        return t.events[(size_t) k].next[i].found() && isThird(i);
    };
    expectCaught({"first_points.comp",
                  "    atomicAdd(found, 1u);",
                  "    if ((firstPixel + i) % 7u == 3u) next[i].emission.y += 0.5;\n"
                  "    atomicAdd(found, 1u);",
                  "DirectVisibility",
                  {"shading buffer G[k+1]"},
                  found,
                  0});
    expectCaught({"direct_visibility.frag",
                  "    seenPrimitive = id;",
                  "    seenPrimitive = (uint(gl_FragCoord.y) * frame.width +\n"
                  "                     uint(gl_FragCoord.x)) % 7u == 3u ? kNoPrimitive : id;",
                  "DirectVisibility",
                  {"shading buffer G[k+1]"},
                  found,
                  0});
}

TEST(CheckPasses, CatchesFaultsOfDepthMaskAndRays) {
    expectCaught({"depth_mask.comp",
                  "uvec4(alive ? 1u : 0u)",
                  "uvec4(alive != ((firstPixel + i) % 7u == 3u) ? 1u : 0u)",
                  "DepthMask",
                  {"mask"},
                  [](const Truth&, int, size_t i) { return isThird(i); }});
    expectCaught({"rays.comp",
                  "next.direction, next.pdf, throughput",
                  "next.direction, next.pdf, 1.5 * throughput",
                  "Rays",
                  {"rays"},
                  [](const Truth& t, int k, size_t i) {
                      return t.events[(size_t) k].rays[i].direction != glm::vec3(0.0f);
                  }});
}

TEST(CheckPasses, CatchesFaultsOfTrace) {
    expectCaught({"trace.comp",
                  "    hits[index] = search.best;",
                  "    hits[index] = search.best;\n"
                  "    if (w.phase == kDone && index % 7u == 3u) hits[index].u += 1.0;",
                  "Trace",
                  {"hit buffer"},
                  [](const Truth&, int, size_t i) { return isThird(i); }});
    // The tile that lists it, of half the views.
    expectCaught({"trace.comp",
                  "    search.best.view = uint(w.walk.view);",
                  "    search.best.view = uint(w.walk.view) & ~1u;",
                  "Trace",
                  {"hit buffer"},
                  [](const Truth& t, int k, size_t i) {
                      return t.events[(size_t) k].hits[i].found() &&
                             (t.events[(size_t) k].hits[i].view & 1u) &&
                             t.events[(size_t) k].hits[i].view < 6;
                  }});
}

TEST(CheckPasses, CatchesFaultsOfFetch) {
    const auto found = [](const Truth& t, int k, size_t i) {
        return t.events[(size_t) k].hits[i].found();
    };
    for (const Fetch fetch : {Fetch::raster, Fetch::direct}) {
        const bool raster = fetch == Fetch::raster;
        expectCaught({"fetch.comp",
                      raster ? "hit.fetches + fetched;" : "hit.fetches + 1u;",
                      raster ? "hit.fetches + 2u * fetched;" : "hit.fetches + 2u;",
                      "Fetch",
                      {"hit buffer"},
                      found,
                      1,
                      fetch});
        expectCaught({"fetch.comp",
                      "hit.primitive, hit.u, hit.v,",
                      "hit.primitive, 0.125, 0.5,",
                      "Fetch",
                      {"shading buffer G[k+1]"},
                      found,
                      1,
                      fetch});
    }
    // Fragments of every third triangle are lost.
    expectCaught({"fetch.frag",
                  "    if (group == kNoRecord) discard;",
                  "    if (group == kNoRecord || primitive % 3 == 0) discard;",
                  "Fetch",
                  {"shading buffer G[k+1]", "hit buffer"},
                  [](const Truth& t, int k, size_t i) {
                      return t.events[(size_t) k].hits[i].found() &&
                             t.events[(size_t) k].hits[i].primitive % 3 == 0 &&
                             t.events[(size_t) k].hits[i].view < 6;
                  }});
}

TEST(CheckPasses, CatchesFaultsOfVisibility) {
    for (const ViewMode mode : {ViewMode::full, ViewMode::single}) {
        expectCaught({"shadow_rays.comp",
                      "    bool lit = isLit(i);",
                      "    bool lit = isLit(i) && (firstPixel + i) % 7u != 3u;",
                      "Visibility",
                      {"visibility"},
                      [](const Truth& t, int k, size_t i) {
                          return t.events[(size_t) k].visibility[i] != 0 && isThird(i);
                      },
                      0,
                      Fetch::raster,
                      mode});
    }
    expectCaught({"visibility.comp",
                  "hits[i].primitive != kNoPrimitive",
                  "hits[i].primitive != kNoPrimitive && (firstPixel + i) % 3u != 0u",
                  "Visibility",
                  {"visibility"},
                  [](const Truth& t, int k, size_t i) { // few points are in shadow
                      return t.lit[(size_t) k][i] && !t.events[(size_t) k].visibility[i] &&
                             i % 3 == 0;
                  },
                  0});
}

TEST(CheckPasses, CatchesFaultsOfShadeAndResolve) {
    expectCaught({"shade.comp",
                  "precise vec3 arriving = throughput * reflected;",
                  "precise vec3 arriving = 2.0 * throughput * reflected;",
                  "Shade",
                  {"radiance"},
                  [](const Truth& t, int k, size_t i) {
                      return t.events[(size_t) k].alive(k, i) &&
                             t.events[(size_t) k].visibility[i] != 0;
                  },
                  0});
    expectCaught(
        {"resolve.comp",
         "image[3u * i + c] + radiance[3u * i + c];",
         "image[3u * i + c] + ((firstPixel + i) % 7u == 3u ? 0.0 : radiance[3u * i + c]);",
         "Resolve",
         {"image"},
         [](const Truth& t, int, size_t i) { return isThird(i) && t.image[i] != glm::vec3(0.0f); },
         0});
}

} // namespace
} // namespace dirt::test
