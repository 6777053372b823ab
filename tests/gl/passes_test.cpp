// Each pass of a sample in GLSL against the CPU's on the same data, bit for bit: what it writes,
// and that it leaves everything else as it was.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "backend_gl/gl_backend.h"
#include "core/base/error.h"
#include "core/frame/renderer.h"
#include "core/io/load.h"
#include "tests/frame/shapes.h"
#include "tests/gl/paths.h"
#include "tests/gl/replaced.h"
#include "tests/support/print.h"
#include "tests/support/small_scenes.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

/// One for all tests, as each compiles its programs anew.
GlBackend& sharedBackend() {
    static GlBackend backend;
    return backend;
}

/// Runs the passes of samples on both backends, each pass of both on what the CPU had before it.
class BothBackends {
public:
    BothBackends(const Scene& scene, const RenderSettings& settings, GlBackend& gl,
                 Executor& executor)
        : cpu_(executor), gl_(gl), settings_(settings) {
        need_ = requirementsOf(scene, settings, true);
        for (Backend* backend : {(Backend*) &cpu_, (Backend*) &gl_}) {
            backend->build(scene.mesh, scene.camera, settings.grid);
            backend->beginFrame(scene, settings, need_);
        }
        EXPECT_TRUE(samePaths(gl_.readPaths(), cpu_.readPaths())) << "beginFrame";
        if (need_.shadowMap == 0) return;
        cpu_.shadowMap();
        gl_.shadowMap();
        EXPECT_TRUE(sameRecords("shadow map", gl_.readShadowMap(), cpu_.readShadowMap()));
        gl_.writeShadowMap(cpu_.readShadowMap());
    }

    void sample(uint32_t index) {
        pass("beginSample", [](Backend& b) { b.beginSample(); });
        for (int k = 0; k < settings_.bounces; ++k) {
            if (k > 0) pass("DepthMask", [k](Backend& b) { b.depthMask(k); });
            if (k == 0 && !need_.tracedPrimary) {
                cpu_.directVisibility(index); // its own test is below
            } else {
                pass("Rays", [&](Backend& b) { b.rays(index, k); });
                pass("Trace", [k](Backend& b) { b.trace(k); });
                pass("Fetch", [k](Backend& b) { b.fetch(k); });
            }
            if (need_.shadowRays) pass("Visibility", [k](Backend& b) { b.visibility(k); });
            pass("Shade", [k](Backend& b) { b.shade(k); });
            pass("shift", [](Backend& b) { b.shift(); });
        }
        pass("Resolve", [](Backend& b) { b.resolve(); });
    }

    size_t hits = 0; ///< that were compared

private:
    void pass(const char* name, const std::function<void(Backend&)>& run) {
        gl_.writePaths(cpu_.readPaths());
        const FrameCounts cpuBefore = cpu_.counts(), glBefore = gl_.counts();
        run(cpu_);
        run(gl_);
        ASSERT_TRUE(samePaths(gl_.readPaths(), cpu_.readPaths())) << name;
        const auto since = [](const FrameCounts& now, const FrameCounts& then) {
            return std::array{now.rays - then.rays, now.hits - then.hits,
                              now.shadowRays - then.shadowRays};
        };
        ASSERT_EQ(since(gl_.counts(), glBefore), since(cpu_.counts(), cpuBefore)) << name;
        if (std::string(name) != "Trace") return;
        for (const Hit& hit : cpu_.paths().hits) hits += hit.found();
    }

    CpuBackend cpu_;
    GlBackend& gl_;
    RenderSettings settings_;
    Requirements need_;
};

RenderSettings randomSettings(Random& random) {
    RenderSettings settings;
    settings.grid.mode = random.chance(0.5) ? ViewMode::full : ViewMode::single;
    settings.grid.width = random.range(1, 40);
    settings.grid.height = random.range(1, 30);
    settings.grid.tile = random.pick({1, 2, 4, 7, 16, 64});
    settings.grid.bins = random.pick({1, 16, 44});
    settings.grid.traversal = random.chance(0.3) ? Traversal::linear : Traversal::hierarchical;
    settings.bounces = 3;
    settings.primary = random.chance(0.7) ? Primary::traced : Primary::raster;
    settings.fetch = random.chance(0.6) ? Fetch::raster : Fetch::direct;
    settings.visibility = random.chance(0.7) ? LightVisibility::traced : LightVisibility::shadowMap;
    settings.seed = (uint32_t) random.below(1000);
    return settings;
}

/// The room with textures of bytes and floats, of odd sizes, looked up at coordinates of all
/// magnitudes; some triangles have none.
Scene texturedRoom(Random& random) {
    Scene scene = room();
    const auto texels = [&](int count, auto zero, double scale) {
        std::vector<decltype(zero)> values;
        for (int i = 0; i < count; ++i)
            values.push_back((decltype(zero)) (random.uniform() * scale));
        return values;
    };
    scene.textures.emplace_back("bytes", 5, 3, texels(5 * 3 * 3, uint8_t(), 255.0));
    scene.textures.emplace_back("floats", 2, 7, texels(2 * 7 * 3, float(), 0.9));
    scene.textures.emplace_back("one", 1, 1, texels(3, uint8_t(), 255.0));
    for (uint32_t i = 0; i < 3; ++i) scene.materials[i].diffuseMap = i;
    for (int i = 0; i < 60; ++i)
        scene.mesh.texcoords.push_back({(float) random.wide(-8, 7), (float) random.wide(-3, 1)});
    for (Corners& corners : scene.mesh.texcoordIndices)
        if (random.chance(0.9))
            for (uint32_t& corner : corners) corner = (uint32_t) random.below(60);
    return scene;
}

TEST(GlPasses, EqualTheCpusOnATexturedRoom) {
    ThreadPool pool(2);
    Random random(4);
    for (const ViewMode mode : {ViewMode::full, ViewMode::single}) {
        RenderSettings settings;
        settings.grid.mode = mode;
        settings.grid.width = 53;
        settings.grid.height = 31;
        settings.fetch = mode == ViewMode::full ? Fetch::raster : Fetch::direct;
        settings.grid.traversal =
            mode == ViewMode::full ? Traversal::linear : Traversal::hierarchical;
        settings.primary = mode == ViewMode::full ? Primary::traced : Primary::raster;
        const Scene scene = texturedRoom(random);
        BothBackends both(scene, settings, sharedBackend(), pool);
        both.sample(0);
        both.sample(5);
        ASSERT_FALSE(HasFailure()) << "mode " << (int) mode;
        EXPECT_GT(both.hits, 1000u);
    }
}

/// The textured room with all that a surface can have of maps, looked up in all ways, and colours
/// of vertices; some materials have less.
Scene mappedRoom(Random& random) {
    Scene scene = texturedRoom(random);
    const auto bytes = [&](int count) {
        std::vector<uint8_t> values;
        for (int i = 0; i < count; ++i) values.push_back((uint8_t) random.below(256));
        return values;
    };
    const auto sampling = [&] {
        const auto number = [&] { return (float) random.uniform(-2.0, 2.0); };
        TextureSampling any;
        any.wrapU = random.pick({Wrap::repeat, Wrap::mirror, Wrap::clamp});
        any.wrapV = random.pick({Wrap::repeat, Wrap::mirror, Wrap::clamp});
        any.transformed = random.chance(0.5);
        any.rowU = {number(), number(), number()};
        any.rowV = {number(), number(), number()};
        return any;
    };
    scene.textures.emplace_back("normals", 4, 6, bytes(4 * 6 * 3), TexelEncoding::linear);
    scene.scalarTextures = {{"rough", 3, 5, bytes(15)}, {"metal", 5, 2, bytes(10)}};
    for (Texture& texture : scene.textures) texture = texture.with(sampling());
    for (int i = 0; i < 6; ++i)
        scene.scalarTextures.push_back(scene.scalarTextures[(size_t) i % 2].with(sampling()));
    for (size_t i = 0; i < scene.materials.size(); ++i) {
        Material& m = scene.materials[i];
        const auto data = [&] {
            return random.chance(0.7) ? (uint32_t) random.below(8) : kNoTexture;
        };
        m.diffuseMapFactor = {0.9f, (float) random.uniform(), 0.5f};
        m.normalMap = i == 1 ? kNoTexture : 3;
        m.normalScale = (float) random.uniform(-1.0, 1.5);
        m.bumpMap = data(); // of which a normal map takes the place
        m.reflectance = 0.25f;
        m.metallic = 0.8f;
        m.roughness = 0.7f;
        m.roughnessMap = data();
        m.metallicMap = i == 0 ? 1 : data();
        m.opacityMap = i == 2 ? 2 : kNoTexture;
        m.opacity = 0.9f;
    }
    for (size_t i = 0; i < scene.mesh.positions.size(); ++i)
        scene.mesh.colors.push_back(
            {(float) random.uniform(), (float) random.uniform(), (float) random.uniform()});
    return scene;
}

TEST(GlPasses, EqualTheCpusOnMappedSurfaces) {
    ThreadPool pool(2);
    Random random(8);
    for (int i = 0; i < cases(2, 100); ++i) {
        RenderSettings settings;
        settings.grid.mode = i % 2 ? ViewMode::single : ViewMode::full;
        settings.grid.width = 41;
        settings.grid.height = 23;
        settings.bounces = 2;
        settings.fetch = i % 2 ? Fetch::direct : Fetch::raster;
        settings.shading = i % 2 ? Shading::packed : Shading::full;
        settings.primary = i % 2 ? Primary::raster : Primary::traced;
        const Scene scene = mappedRoom(random);
        BothBackends both(scene, settings, sharedBackend(), pool);
        both.sample((uint32_t) i);
        ASSERT_FALSE(HasFailure()) << "case " << i;
        EXPECT_GT(both.hits, 100u);
    }
}

/// Bytes of a buffer of the scene's; 0: there is none.
uint64_t sceneBytes(const Scene& scene, const char* name) {
    GlBackend& gl = sharedBackend();
    const RenderSettings settings;
    gl.beginFrame(scene, settings, requirementsOf(scene, settings, true));
    for (const BufferSize& buffer : gl.memory())
        if (buffer.name == name) return buffer.bytes;
    return 0;
}

/// Where a scene has none of it, a material has 64 bytes, a texture's entry 16, and the decoded
/// bytes are those of sRGB; textures that share their texels have them once.
TEST(GlPasses, KeepOnlyWhatTheSceneHas) {
    Random random(10);
    Scene scene = texturedRoom(random);
    const uint64_t triangles = scene.mesh.triangles.size(), materials = scene.materials.size();
    const uint64_t texels = 4 * (5 * 3 + 2 * 7 * 3 + 1), decoded = 256 * 4;
    EXPECT_EQ(sceneBytes(scene, "materials"), 4 * triangles + 64 * materials);
    EXPECT_EQ(sceneBytes(scene, "textures"), texels + 3 * 16 + decoded);
    EXPECT_EQ(sceneBytes(scene, "vertex colours"), 0u);

    TextureSampling sampling;
    sampling.wrapU = Wrap::mirror;
    scene.textures[2] = scene.textures[0].with(sampling);
    EXPECT_EQ(sceneBytes(scene, "textures"), texels - 4 + 3 * 16 + decoded);
    sampling.transformed = true;
    scene.textures[2] = scene.textures[0].with(sampling);
    EXPECT_EQ(sceneBytes(scene, "textures"), texels - 4 + 3 * 48 + decoded);
    scene.materials[0].diffuseMapFactor.x = 0.5f;
    EXPECT_EQ(sceneBytes(scene, "materials"), 4 * triangles + 96 * materials);
    scene.mesh.colors.assign(scene.mesh.positions.size(), glm::vec3(1.0f));
    EXPECT_EQ(sceneBytes(scene, "vertex colours"),
              12 * triangles + 12 * scene.mesh.positions.size());
}

/// Colours and metal need no texture coordinates.
TEST(GlPasses, EqualTheCpusOnColouredVertices) {
    ThreadPool pool(2);
    Random random(9);
    Scene scene = mappedRoom(random);
    scene.mesh.texcoords.clear();
    scene.mesh.texcoordIndices.assign(scene.mesh.triangles.size(), {kNoIndex, kNoIndex, kNoIndex});
    RenderSettings settings;
    settings.grid.width = 41;
    settings.grid.height = 23;
    BothBackends both(scene, settings, sharedBackend(), pool);
    both.sample(1);
    EXPECT_GT(both.hits, 500u);
}

TEST(GlPasses, EqualTheCpusOnSmallScenes) {
    ThreadPool pool(2);
    Random random(3);
    for (int i = 0; i < cases(4, 600); ++i) {
        const RenderSettings settings = randomSettings(random);
        const ViewSet set(settings.grid, Camera{});
        Scene scene = sceneOf(smallScene(random, set));
        scene.background = {0.1f, 0.2f, 0.3f};
        if (random.chance(0.7)) {
            Spotlight light;
            light.position = uniformPoint(random, 1.0);
            light.target = uniformPoint(random, 1.0);
            light.conical = random.chance(0.7);
            light.exponent = random.pick({1.0f, 3.0f});
            light.resolution = random.range(1, 50);
            light.softShadowSize = (float) random.uniform(0.0, 0.5);
            scene.lights = {light};
        }
        BothBackends both(scene, settings, sharedBackend(), pool);
        both.sample((uint32_t) i);
        ASSERT_FALSE(HasFailure()) << "case " << i << ", " << describe(set);
    }
}

/// Microfacets of all models, bumps, cut-outs, emission from textures, a lens, roulette, points in
/// full and packed.
TEST(GlPasses, EqualTheCpusOnMaterials) {
    ThreadPool pool(2);
    int index = 0;
    for (const char* name : {"materials", "materials_ggx", "cards", "lens", "cards_shadow_map"}) {
        RenderSettings settings;
        settings.grid.mode = index % 2 ? ViewMode::single : ViewMode::full;
        settings.grid.width = 40;
        settings.grid.height = 30;
        settings.bounces = index == 0 ? 5 : 2;
        settings.fetch = index % 2 ? Fetch::direct : Fetch::raster;
        settings.rayType = index == 1 ? RayType::glossy : RayType::normal;
        settings.primary = std::string(name) == "cards" ? Primary::traced : Primary::raster;
        settings.shading = index == 1 || index == 2 ? Shading::packed : Shading::full;
        const std::string file =
            std::string(DIRT_SOURCE_DIR "/tests/golden/scenes/") + name + ".scene";
        const LoadedScene loaded = loadScene(file, {});
        settings.visibility = loaded.settings.visibility.value_or(settings.visibility);
        Scene scene = loaded.scene;
        for (Spotlight& light : scene.lights) light.resolution = 100;
        BothBackends both(scene, settings, sharedBackend(), pool);
        both.sample(3);
        ASSERT_FALSE(HasFailure()) << name;
        EXPECT_GT(both.hits, 100u) << name;
        ++index;
    }
}

decltype(epoxy_glGetIntegerv) realGetIntegerv = nullptr;

/// A driver whose buffer textures are short.
void APIENTRY shortBufferTextures(GLenum name, GLint* value) {
    realGetIntegerv(name, value);
    if (name == GL_MAX_TEXTURE_BUFFER_SIZE) *value = 2000; // a power of two fits: 1024
}

/// Texels that need two buffer textures, one texture across both; a third would be refused.
TEST(GlPasses, EqualTheCpusWithTexelsInTwoPieces) {
    GlBackend gl;
    ThreadPool pool(2);
    Random random(6);
    RenderSettings settings;
    settings.grid.width = 31;
    settings.grid.height = 17;
    settings.bounces = 1;
    Scene scene = texturedRoom(random);
    std::vector<float> texels;
    for (int i = 0; i < 20 * 20 * 3; ++i) texels.push_back((float) random.uniform());
    scene.textures[1] = Texture("floats", 20, 20, texels);
    realGetIntegerv = epoxy_glGetIntegerv;
    const Replaced limits(epoxy_glGetIntegerv, &shortBufferTextures);
    {
        BothBackends both(scene, settings, gl, pool);
        both.sample(0);
    }
    texels.resize(40 * 20 * 3);
    scene.textures[1] = Texture("floats", 40, 20, texels);
    EXPECT_THROW(gl.beginFrame(scene, settings, requirementsOf(scene, settings, true)), InputError);
}

/// What no frame leaves behind: dead paths with rays, rays that are no numbers.
TEST(GlPasses, EqualTheCpusOnOddPaths) {
    ThreadPool pool(2);
    RenderSettings settings;
    settings.grid.width = 16;
    settings.grid.height = 8;
    const Scene scene = room();
    const Requirements need = requirementsOf(scene, settings, true);
    CpuBackend cpu(pool);
    GlBackend& gl = sharedBackend();
    for (Backend* backend : {(Backend*) &cpu, (Backend*) &gl}) {
        backend->build(scene.mesh, scene.camera, settings.grid);
        backend->beginFrame(scene, settings, need);
    }
    cpu.rays(0, 0);
    PathBuffers paths = cpu.readPaths();
    for (size_t i = 0; i < paths.mask.size(); ++i) paths.mask[i] = i % 3 != 0;
    paths.rays[4].direction.x = NAN;
    paths.rays[5].origin.y = HUGE_VALF;
    paths.rays[7].direction = glm::vec3(0.0f);
    for (Backend* backend : {(Backend*) &cpu, (Backend*) &gl}) {
        backend->writePaths(paths);
        backend->trace(1);
        backend->fetch(1);
        backend->visibility(1);
        backend->shade(1);
        backend->depthMask(2);
    }
    EXPECT_TRUE(samePaths(gl.readPaths(), cpu.readPaths()));
    EXPECT_EQ(gl.counts().rays, cpu.counts().rays);
    EXPECT_EQ(gl.counts().shadowRays, cpu.counts().shadowRays);
}

} // namespace
} // namespace dirt::test
