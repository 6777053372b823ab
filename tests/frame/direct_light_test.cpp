// Direct light of the spotlight on surfaces, against closed forms in double.

#include "core/frame/renderer.h"
#include "tests/frame/brute_force_backend.h"
#include "tests/frame/shapes.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace dirt {
namespace {

constexpr double kPi = std::numbers::pi;

/// A floor under a spotlight of half aperture 30 degrees, everything enlarged by \p scale.
Scene litFloor(float scale) {
    Scene scene;
    scene.materials = {test::material({0.5f, 0.25f, 1.0f})};
    test::addQuad(scene.mesh, glm::vec3(-10, 0, -10) * scale, glm::vec3(20, 0, 0) * scale,
                  glm::vec3(0, 0, 20) * scale, 0);
    Spotlight light;
    light.position = glm::vec3(0.5f, 3.0f, -0.25f) * scale;
    light.target = glm::vec3(0.5f, 0.0f, -0.25f) * scale;
    light.aperture = light.penumbra = 60.0f;
    light.flux = 10.0f * scale * scale;
    scene.lights = {light};
    scene.camera.eye = glm::vec3(0, 4, 4) * scale;
    scene.camera.target = glm::vec3(0.0f);
    return scene;
}

/// Renders one sample of direct light and calls \p check(hit point in world space, radiance) for
/// every pixel.
template <typename Check>
void forEachPixel(const Scene& scene, ViewMode mode, const Check& check) {
    RenderSettings settings;
    settings.grid.mode = mode;
    settings.grid.width = 64;
    settings.grid.height = 48;
    settings.samples = 1;
    settings.bounces = 1;
    SerialExecutor executor;
    test::BruteForceBackend backend(executor);
    const RenderResult result = Renderer(scene, settings, backend).render();
    const std::vector<Hit>& hits = backend.paths().hits;
    for (size_t i = 0; i < hits.size(); ++i) {
        ASSERT_TRUE(hits[i].found());
        const Corners& corners = scene.mesh.triangles[hits[i].primitive];
        const glm::dvec3 a(scene.mesh.positions[corners[0]]), b(scene.mesh.positions[corners[1]]),
            c(scene.mesh.positions[corners[2]]);
        const double u = hits[i].u, v = hits[i].v;
        check(a * (1.0 - u - v) + b * u + c * v, result.image.pixels[i]);
    }
}

TEST(DirectLight, FloorUnderASpotlight) {
    // E = I cos / d^2 with cos = h / d, and radiance Kd E / pi, in world units at any scale.
    for (float scale : {1.0f, 1e-6f, 1e6f})
        for (ViewMode mode : {ViewMode::full, ViewMode::single}) {
            const Scene scene = litFloor(scale);
            const double intensity =
                scene.lights[0].flux / (2.0 * kPi * (1.0 - std::cos(kPi / 6.0)));
            int lit = 0, dark = 0;
            forEachPixel(scene, mode, [&](glm::dvec3 point, glm::vec3 radiance) {
                const glm::dvec3 away = glm::dvec3(scene.lights[0].position) - point;
                const double distance = glm::length(away), cosine = away.y / distance;
                const double exact = intensity * cosine / (distance * distance) / kPi;
                if (cosine < std::cos(kPi / 6.0) - 1e-5) {
                    EXPECT_EQ(radiance, glm::vec3(0.0f));
                    ++dark;
                } else if (cosine > std::cos(kPi / 6.0) + 1e-5) {
                    for (int c = 0; c < 3; ++c)
                        EXPECT_NEAR(radiance[c] / (exact * scene.materials[0].diffuse[c]), 1.0,
                                    1e-5);
                    ++lit;
                }
            });
            EXPECT_GT(lit, 100);
            EXPECT_GT(dark, 100);
        }
}

TEST(DirectLight, BothSidesOfASurfaceAreLit) {
    // Seen from below and lit from below, whichever way its triangles are wound.
    Scene scene = litFloor(1.0f);
    for (Corners& corners : scene.mesh.triangles) std::swap(corners[0], corners[1]);
    float brightest = 0.0f;
    forEachPixel(scene, ViewMode::full, [&](glm::dvec3, glm::vec3 radiance) {
        brightest = std::max(brightest, radiance.x);
    });
    EXPECT_GT(brightest, 0.0f);
    scene.lights[0].position.y *= -1.0f; // beneath, and out of sight
    forEachPixel(scene, ViewMode::full,
                 [&](glm::dvec3, glm::vec3 radiance) { EXPECT_EQ(radiance, glm::vec3(0.0f)); });
}

TEST(DirectLight, ABlockerCastsAShadow) {
    Scene scene = litFloor(1.0f);
    // At half the light's height, so its shadow on the floor is twice its size.
    test::addQuad(scene.mesh, {0.3f, 1.5f, -0.45f}, {0.4f, 0, 0}, {0, 0, 0.4f}, 0);
    int shadowed = 0;
    forEachPixel(scene, ViewMode::single, [&](glm::dvec3 point, glm::vec3 radiance) {
        if (point.y != 0.0) return;
        const double away = std::max(std::abs(point.x - 0.5), std::abs(point.z + 0.25));
        if (away < 0.4 - 1e-5) {
            EXPECT_EQ(radiance, glm::vec3(0.0f));
            ++shadowed;
        } else if (away > 0.4 + 1e-5 && away < 1.0) {
            EXPECT_GT(radiance.x, 0.0f);
        }
    });
    EXPECT_GT(shadowed, 10);

    // But where the light is to cast none: the floor is as lit as without it.
    scene.lights[0].shadows = false;
    const double intensity = scene.lights[0].flux / (2.0 * kPi * (1.0 - std::cos(kPi / 6.0)));
    int lit = 0;
    forEachPixel(scene, ViewMode::single, [&](glm::dvec3 point, glm::vec3 radiance) {
        if (point.y != 0.0) return;
        const glm::dvec3 away = glm::dvec3(scene.lights[0].position) - point;
        const double distance = glm::length(away), cosine = away.y / distance;
        if (cosine < std::cos(kPi / 6.0) + 1e-5) return;
        EXPECT_NEAR(radiance.z / (intensity * cosine / (distance * distance) / kPi), 1.0, 1e-5);
        ++lit;
    });
    EXPECT_GT(lit, shadowed + 100);
}

TEST(DirectLight, InterpolatedNormalsShade) {
    // A floor whose normals lean by the same 0.3 everywhere, turned to either side of the floor.
    const glm::vec3 lean = glm::normalize(glm::vec3(0.3f, 1.0f, 0.0f));
    for (float sign : {1.0f, -1.0f}) {
        Scene scene = litFloor(1.0f);
        scene.mesh.normals = {lean * sign};
        scene.mesh.normalIndices.assign(2, {0, 0, 0});
        const double intensity = scene.lights[0].flux / (2.0 * kPi * (1.0 - std::cos(kPi / 6.0)));
        forEachPixel(scene, ViewMode::single, [&](glm::dvec3 point, glm::vec3 radiance) {
            if (!(radiance.x > 0.0f)) return;
            const glm::dvec3 away = glm::dvec3(scene.lights[0].position) - point;
            const double distance = glm::length(away);
            const double cosine = glm::dot(away, glm::dvec3(lean)) / distance;
            EXPECT_NEAR(radiance.z / (intensity * cosine / (distance * distance) / kPi), 1.0, 1e-5);
        });
    }
}

TEST(DirectLight, TexturesReplaceKd) {
    Scene scene = litFloor(1.0f);
    scene.textures.emplace_back("texels", 1, 1, std::vector<float>{0.125f, 0.5f, 0.75f});
    scene.materials[0].diffuseMap = 0;
    float withoutCoordinates = 0.0f, ratio = 0.0f;
    forEachPixel(scene, ViewMode::full, [&](glm::dvec3, glm::vec3 radiance) {
        if (radiance.x > 0.0f) withoutCoordinates = radiance.y / radiance.x;
    });
    EXPECT_NEAR(withoutCoordinates, 0.25f / 0.5f, 1e-6f); // Kd's
    scene.mesh.texcoords = {{0.5f, 0.5f}};
    scene.mesh.texcoordIndices.assign(2, {0, 0, 0});
    forEachPixel(scene, ViewMode::full, [&](glm::dvec3, glm::vec3 radiance) {
        if (radiance.x > 0.0f) ratio = radiance.y / radiance.x;
    });
    EXPECT_NEAR(ratio, 0.5f / 0.125f, 1e-5f);
}

} // namespace
} // namespace dirt
