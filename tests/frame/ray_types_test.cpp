// What indirect rays take surfaces for, in scenes whose radiance is known.

#include "backend_cpu/cpu_backend.h"
#include "core/frame/renderer.h"
#include "tests/frame/shapes.h"

#include <gtest/gtest.h>

namespace dirt {
namespace {

Image render(const Scene& scene, RayType type, ViewMode mode = ViewMode::full) {
    RenderSettings settings;
    settings.grid.mode = mode;
    settings.grid.width = 48;
    settings.grid.height = 32;
    settings.samples = 4;
    settings.bounces = 2;
    settings.rayType = type;
    SerialExecutor executor;
    CpuBackend backend(executor);
    return Renderer(scene, settings, backend).render().image;
}

/// A floor of reflectance 1/2 that fills the picture, under a sky.
Scene floorUnderSky() {
    Scene scene;
    scene.materials = {test::material(glm::vec3(0.5f))};
    scene.materials[0].reflectance = 0.5f;
    scene.materials[0].roughness = 0.4f;
    test::addQuad(scene.mesh, {-50, 0, -50}, {100, 0, 0}, {0, 0, 100}, 0);
    scene.camera.eye = {0, 3, 0.5f};
    scene.camera.target = {0, 0, 0};
    scene.background = {1, 2, 4};
    return scene;
}

TEST(RayTypes, VisibilityIsThePartOfTheHemisphereThatIsOpen) {
    for (const glm::vec3& pixel : render(floorUnderSky(), RayType::visibility).pixels)
        ASSERT_EQ(pixel, glm::vec3(1.0f));
    Scene box;
    box.materials = {test::material(glm::vec3(0.0f), glm::vec3(5.0f))};
    test::addBox(box.mesh, {-1, -1, -1}, {1, 1, 1}, 0);
    for (const glm::vec3& pixel : render(box, RayType::visibility).pixels)
        ASSERT_EQ(pixel, glm::vec3(0.0f));
}

TEST(RayTypes, DiffuseReflectsTheSkyByKdAlone) {
    for (const glm::vec3& pixel : render(floorUnderSky(), RayType::diffuse).pixels)
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(pixel[c], 0.5f * floorUnderSky().background[c], 1e-5f);
}

TEST(RayTypes, SpecularMirrors) {
    Scene scene = floorUnderSky();
    // A panel above the floor hides the sky from what is mirrored at the centre.
    scene.materials.push_back(test::material(glm::vec3(0.0f), glm::vec3(7.0f)));
    test::addQuad(scene.mesh, {-20, 9, -20}, {40, 0, 0}, {0, 0, 40}, 1);
    const Image image = render(scene, RayType::specular);
    EXPECT_NEAR(image.pixels[16 * 48 + 24].x, 0.5f * 7.0f, 1e-4f);
    const Image usual = render(scene, RayType::normal);
    EXPECT_GT(std::abs(usual.pixels[16 * 48 + 24].x - 0.5f * 7.0f), 0.1f);
}

TEST(RayTypes, GlossyLosesLittleOfAnEvenSky) {
    // A metal of roughness 0.1 and F0 = Kd = 1/2, seen from above: all but what its facets hide.
    const Image image = render(floorUnderSky(), RayType::glossy);
    double sum = 0.0;
    for (const glm::vec3& pixel : image.pixels) sum += pixel.x / image.pixels.size();
    EXPECT_NEAR(sum, 0.5, 0.02);
}

} // namespace
} // namespace dirt
