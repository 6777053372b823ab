// Scenes whose radiance is known in closed form, for every single path and not only on average.

#include "backend_cpu/cpu_backend.h"
#include "core/frame/renderer.h"
#include "shaders/shared/random.h"
#include "tests/frame/shapes.h"

#include <gtest/gtest.h>

namespace dirt {
namespace {

RenderSettings settings(ViewMode mode, int bounces) {
    RenderSettings result;
    result.grid.mode = mode;
    result.grid.width = 48;
    result.grid.height = 32;
    result.samples = 4;
    result.bounces = bounces;
    result.roulette = false;
    return result;
}

Image render(const Scene& scene, const RenderSettings& settings) {
    SerialExecutor executor;
    CpuBackend backend(executor);
    return Renderer(scene, settings, backend).render().image;
}

/// What a wall of radiance Le and reflectance rho shows after n events: Le (1 + rho + …), n terms.
double furnaceRadiance(double emission, double reflectance, int bounces) {
    double sum = 0.0, weight = 1.0;
    for (int k = 0; k < bounces; ++k, weight *= reflectance) sum += emission * weight;
    return sum;
}

/// Floats only: a product and a sum per event and a sum per sample, 2^-24 each.
constexpr double kRounding = 1e-5;

TEST(Furnace, ClosedBoxShowsTheGeometricSeries) {
    Scene scene;
    const glm::vec3 reflectance(0.8f, 0.5f, 1.0f), emission(1.0f, 3.0f, 0.25f);
    scene.materials = {test::material(reflectance, emission)};
    test::addBox(scene.mesh, {-1, -2, -3}, {2, 3, 1}, 0);
    test::addSphere(scene.mesh, {0.3f, 0.2f, -1.4f}, 0.4f, 8, false, 0);
    scene.camera.eye = {0.1f, 0.2f, 0.3f};
    scene.background = glm::vec3(1000.0f); // would betray a leak
    for (int bounces : {1, 2, 3, 8, 20}) {
        const Image image = render(scene, settings(ViewMode::full, bounces));
        for (const glm::vec3& pixel : image.pixels)
            for (int c = 0; c < 3; ++c) {
                const double exact = furnaceRadiance(emission[c], reflectance[c], bounces);
                ASSERT_NEAR(pixel[c] / exact, 1.0, kRounding) << bounces << " bounces";
            }
    }
}

TEST(Furnace, ClosedBoxApproachesItsLimit) {
    // After 20 events 2^-20 of Le / (1 - rho) is missing, and less after more.
    Scene scene;
    scene.materials = {test::material(glm::vec3(0.5f), glm::vec3(3.0f))};
    test::addBox(scene.mesh, {-1, -2, -3}, {2, 3, 1}, 0);
    scene.camera.eye = {0.1f, 0.2f, 0.3f};
    for (int bounces : {20, 30}) {
        const Image image = render(scene, settings(ViewMode::full, bounces));
        for (const glm::vec3& pixel : image.pixels) ASSERT_NEAR(pixel.x / 6.0, 1.0, kRounding);
    }
}

TEST(Furnace, RouletteKeepsTheMean) {
    Scene scene;
    scene.materials = {test::material(glm::vec3(0.8f), glm::vec3(1.0f))};
    test::addBox(scene.mesh, {-1, -2, -3}, {2, 3, 1}, 0);
    scene.camera.eye = {0.1f, 0.2f, 0.3f};
    RenderSettings withRoulette = settings(ViewMode::full, 24);
    withRoulette.roulette = true;
    const Image image = render(scene, withRoulette);
    double sum = 0.0, squares = 0.0;
    for (const glm::vec3& pixel : image.pixels) {
        sum += pixel.x;
        squares += (double) pixel.x * pixel.x;
    }
    const double n = (double) image.pixels.size(), mean = sum / n;
    const double error = std::sqrt((squares / n - mean * mean) / n);
    EXPECT_GT(error, 1e-3); // paths do end by chance
    // The numbers are fixed: four standard errors say how far a right answer may be off.
    EXPECT_NEAR(mean, furnaceRadiance(1.0, 0.8, 24), 4.0 * error);
}

TEST(Furnace, MirrorShowsTheSkyTimesFresnel) {
    Scene scene;
    Material metal = test::material({0.9f, 0.6f, 0.3f});
    metal.reflectance = metal.metallic = 1.0f;
    metal.roughness = 0.0f;
    scene.materials = {metal};
    test::addQuad(scene.mesh, {-5, 0, -5}, {10, 0, 0}, {0, 0, 10}, 0);
    scene.camera.eye = {0, 3, 0.5f};
    scene.camera.target = {0, 0, 0};
    scene.background = glm::vec3(1.0f);
    const Image image = render(scene, settings(ViewMode::full, 2));
    // The centre's cosine is 6 / sqrt(37): F - F0 is (1 - F0) (1 - cos)^5, below 2e-10.
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(image.pixels[16 * 48 + 24][c], metal.diffuse[c], kRounding);
}

/// Bumps and interpolated normals turn what mirrors as far as they like, and none of it is lost in
/// the surface; what leaves it meets nothing else.
TEST(Furnace, MirrorsKeepTheirLightWhateverTheirNormals) {
    Material mirror = test::material(glm::vec3(1.0f));
    mirror.reflectance = mirror.metallic = 1.0f;
    mirror.roughness = 0.0f;
    Scene plate;
    plate.materials = {mirror};
    plate.materials[0].bumpMap = 0;
    plate.materials[0].bumpScale = 4.0f;
    std::vector<float> heights;
    for (uint32_t i = 0; i < 64 * 64; ++i) heights.push_back(randomUnit(i, 0, 0, 0, 0));
    plate.scalarTextures = {ScalarTexture("noise", 64, 64, std::move(heights))};
    test::addQuad(plate.mesh, {-10, 0, -10}, {20, 0, 0}, {0, 0, 20}, 0);
    plate.mesh.texcoords = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
    plate.mesh.texcoordIndices = {{0, 1, 2}, {0, 2, 3}};
    plate.camera.eye = {0, 1.2f, 9};
    plate.camera.target = {0, 0, 0};
    Scene ball; // of few and large triangles, to whose rim interpolated normals turn away
    ball.materials = {mirror};
    test::addSphere(ball.mesh, glm::vec3(0.0f), 1.0f, 5, true, 0);
    ball.camera.eye = {0, 0.5f, 3};
    ball.camera.target = {0, 0, 0};
    for (Scene* scene : {&plate, &ball}) {
        scene->background = glm::vec3(1.0f);
        const Image image = render(*scene, settings(ViewMode::full, 8));
        for (const glm::vec3& pixel : image.pixels) ASSERT_NEAR(pixel.x, 1.0, kRounding);
    }
}

/// Each event adds what the walls emit, as long as the path goes on: nothing may leak or fade.
TEST(Furnace, LongPathsKeepTheirEnergy) {
    Material mirror = test::material(glm::vec3(1.0f), glm::vec3(1.0f, 0.5f, 0.25f));
    mirror.reflectance = mirror.metallic = 1.0f;
    mirror.roughness = 0.0f;
    const Material matte = test::material(glm::vec3(1.0f), mirror.emission);
    constexpr int kBounces = 1000;
    for (const Material& material : {mirror, matte})
        for (const bool roulette : {false, true}) {
            Scene scene;
            scene.materials = {material};
            test::addBox(scene.mesh, {-1, -2, -3}, {2, 3, 1}, 0);
            scene.camera.eye = {0.1f, 0.2f, 0.3f};
            scene.background = glm::vec3(1000.0f); // would betray a leak
            RenderSettings many = settings(ViewMode::full, kBounces);
            many.grid.width = 12;
            many.grid.height = 8;
            many.samples = 1;
            many.roulette = roulette;
            // A mirror's weight F / chance is 1 but for three roundings, below 2^-22 an event, so
            // that the mean weight is off by 2^-22 kBounces / 2 at most, the sum's roundings by as
            // much. Roulette may end a path whose weight is below 1 by that, and makes up for it.
            const double error = 2.0 * kBounces * 0x1p-23 + 0x1p-24 * kBounces;
            const Image image = render(scene, many);
            size_t whole = 0;
            for (const glm::vec3& pixel : image.pixels) {
                if (std::abs(pixel.x / kBounces - 1.0) <= error) ++whole;
                EXPECT_EQ(pixel.y, 0.5f * pixel.x);
                EXPECT_EQ(pixel.z, 0.25f * pixel.x);
            }
            EXPECT_EQ(whole, image.pixels.size());
        }
}

TEST(Furnace, NoSurfaceReflectsMoreThanTheSky) {
    for (uint32_t model = 0; model < 4; ++model)
        for (const float metallic : {0.0f, 1.0f}) {
            Scene scene;
            scene.microfacetModel = (MicrofacetModel) model;
            Material white = test::material(glm::vec3(1.0f));
            white.reflectance = metallic > 0.0f ? 1.0f : 0.3f;
            white.metallic = metallic;
            white.roughness = 0.3f;
            scene.materials = {white};
            // Interpolated normals turn away from the viewer at the rim.
            test::addSphere(scene.mesh, glm::vec3(0.0f), 1.0f, 6, true, 0);
            scene.camera.eye = {0, 0.5f, 3};
            scene.camera.target = {0, 0, 0};
            scene.background = glm::vec3(1.0f);
            RenderSettings many = settings(ViewMode::full, 2);
            many.samples = 64;
            const Image image = render(scene, many);
            double sum = 0.0, most = 0.0;
            for (const glm::vec3& pixel : image.pixels) {
                sum += pixel.x;
                most = std::max(most, (double) pixel.x);
                ASSERT_GE(pixel.x, 0.0f);
            }
            EXPECT_LE(sum, (double) image.pixels.size());
            // A metal's weights are at most 1 each; where lobes are mixed they scatter around it.
            EXPECT_LE(most, metallic > 0.0f ? 1.0 + kRounding : 1.25);
            EXPECT_GT(sum, 0.8 * (double) image.pixels.size());
        }
}

TEST(Furnace, ConvexBodyInAWhiteSkyShowsItsReflectance) {
    Scene scene;
    const glm::vec3 reflectance(0.9f, 0.5f, 0.1f);
    scene.materials = {test::material(reflectance)};
    test::addSphere(scene.mesh, glm::vec3(0.0f), 1.0f, 12, false, 0);
    scene.camera.eye = {0, 0.5f, 3};
    scene.camera.target = {0, 0, 0};
    scene.background = glm::vec3(1.0f);
    // Every path leaves the body at once and for good; more bounces change nothing.
    for (int bounces : {2, 4}) {
        const Image image = render(scene, settings(ViewMode::full, bounces));
        const glm::vec3 center = image.pixels[16 * 48 + 24], corner = image.pixels[0];
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(center[c] / reflectance[c], 1.0, kRounding);
            EXPECT_EQ(corner[c], 1.0f);
        }
    }
}

TEST(Furnace, SingleViewGivesBackgroundToPrimaryRaysOnly) {
    Scene scene;
    scene.materials = {test::material(glm::vec3(0.9f))};
    test::addSphere(scene.mesh, glm::vec3(0.0f), 1.0f, 12, false, 0);
    scene.camera.eye = {0, 0.5f, 3};
    scene.camera.target = {0, 0, 0};
    scene.background = glm::vec3(1.0f);
    const Image image = render(scene, settings(ViewMode::single, 3));
    EXPECT_EQ(image.pixels[16 * 48 + 24], glm::vec3(0.0f));
    EXPECT_EQ(image.pixels[0], glm::vec3(1.0f));
}

TEST(Furnace, NothingLeaksIntoAClosedBox) {
    // Light and sky outside, smooth normals inside that point anywhere: black, in every sample.
    Scene scene;
    scene.materials = {test::material(glm::vec3(0.9f))};
    test::addBox(scene.mesh, glm::vec3(-1.0f), glm::vec3(1.0f), 0);
    test::addSphere(scene.mesh, {0.2f, -0.4f, -0.5f}, 0.3f, 6, true, 0);
    scene.background = glm::vec3(1e6f);
    Spotlight light;
    light.position = {0, 1.01f, 0};
    light.target = {0, 0, 0};
    light.aperture = light.penumbra = 170.0f;
    light.flux = 1e6f;
    scene.lights = {light};
    scene.camera.eye = {0.3f, 0.2f, 0.8f};
    // In the full view only: in the single one a shadow ray that leaves the view is unoccluded.
    const Image image = render(scene, settings(ViewMode::full, 5));
    for (const glm::vec3& pixel : image.pixels) ASSERT_EQ(pixel, glm::vec3(0.0f));
}

} // namespace
} // namespace dirt
