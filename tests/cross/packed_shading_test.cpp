// Frames with packed surface points beside those with full ones: how far the image is off, and what
// the memory is.

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/compare/differences.h"
#include "core/frame/memory_plan.h"
#include "core/frame/renderer.h"
#include "core/io/load.h"
#include "tests/frame/shapes.h"
#include "tests/support/golden_scenes.h"

#include <iostream>
#include <map>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

struct Frame {
    Image image;
    std::map<std::string, uint64_t> memory;
};

Frame render(const Scene& scene, RenderSettings settings, Shading shading, Executor& pool) {
    settings.shading = shading;
    CpuBackend cpu(pool);
    Frame frame{Renderer(scene, settings, cpu).render().image, {}};
    for (const BufferSize& buffer : cpu.memory()) frame.memory[buffer.name] = buffer.bytes;
    for (const PlannedBuffer& buffer :
         planPaths(requirementsOf(scene, settings, true), settings.grid))
        EXPECT_EQ(frame.memory[buffer.name], buffer.bytes) << buffer.name;
    return frame;
}

glm::dvec3 meanOf(const Image& image) {
    glm::dvec3 sum(0.0);
    for (const glm::vec3& pixel : image.pixels) sum += glm::dvec3(pixel);
    return sum / (double) image.pixels.size();
}

/// What is emitted is off by 2^-8 at most, what is reflected by 2^-13 a bounce. Paths that turn by
/// an angle of 6.5e-5 and then meet something else are as likely to be brighter as darker: one in
/// ten thousand, by as much as a sample's radiance.
void expectNear(const Scene& scene, const RenderSettings& settings, Executor& pool,
                const std::string& name) {
    const Frame full = render(scene, settings, Shading::full, pool);
    const Frame packed = render(scene, settings, Shading::packed, pool);
    const double off = std::ldexp(1.0, -8) + settings.bounces * std::ldexp(1.0, -13);
    const glm::dvec3 expected = meanOf(full.image), mean = meanOf(packed.image);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], expected[c], off * expected[c]) << name;
    const double error = differencesOf(packed.image, full.image).relativeMse;
    EXPECT_LT(error, off * off + 1e-4 / settings.samples) << name;
    EXPECT_GT(error, 0.0) << name;

    const size_t bytes = pointFormatOf([&] {
                             RenderSettings asked = settings;
                             asked.shading = Shading::packed;
                             return requirementsOf(scene, asked, true);
                         }())
                             .bytes();
    EXPECT_LE(bytes, 32u);
    for (const auto& [buffer, size] : full.memory)
        EXPECT_EQ(packed.memory.at(buffer),
                  buffer.starts_with("shading buffer") ? size / 80 * bytes : size)
            << name << ", " << buffer;
    std::cout << name << ": " << bytes << " bytes a point, relative MSE " << error << std::endl;
}

TEST(PackedShading, MakesNearlyTheSameImage) {
    ThreadPool pool;
    for (const char* name : {"materials", "cards", "lens"}) {
        const LoadedScene loaded =
            loadScene(goldenFolder() / "scenes" / (std::string(name) + ".scene"));
        RenderSettings settings = goldenSettings(loaded, 4);
        settings.grid.width = 96;
        settings.grid.height = 48;
        expectNear(loaded.scene, settings, pool, name);
    }
    RenderSettings settings;
    settings.grid.width = 96;
    settings.grid.height = 48;
    settings.fetch = Fetch::direct;
    expectNear(room(), settings, pool, "room");
}

} // namespace
} // namespace dirt::test
