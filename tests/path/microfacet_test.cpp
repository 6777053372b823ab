// The choice of visible normals and of directions, each against its own density.

#include "shaders/shared/bsdf.h"
#include "shaders/shared/random.h"

#include "tests/path/chi_square_sphere.h"
#include "tests/support/random.h"

#include <iostream>

#include <gtest/gtest.h>

namespace dirt {
namespace {

constexpr uint kDistributions[] = {kBeckmann, kGgx, kCookTorrance, kPhong};
constexpr float kRoughnesses[] = {1.0f, 0.3f, 0.02f, kMirrorRoughness};
constexpr float kCosines[] = {1.0f, 0.7f, 0.25f, 0.08f};

/// Directions to draw: a million in the long form.
uint drawn() {
    return (uint) test::cases(1 << 17, 1'000'000);
}

float uniform(uint i, uint event, uint dimension) {
    return randomUnit(i, 7, event, dimension, 3);
}

glm::vec3 viewAt(float cosine, float azimuth) {
    const float sine = std::sqrt(1.0f - cosine * cosine);
    return unitVector({sine * std::cos(azimuth), sine * std::sin(azimuth), cosine});
}

TEST(Microfacets, VisibleNormalsFollowTheirDensity) {
    const double level =
        test::sidak(2 * std::size(kDistributions) * std::size(kRoughnesses) * std::size(kCosines));
    uint event = 0;
    for (const uint model : kDistributions)
        for (const float alpha : kRoughnesses)
            for (const float cosine : kCosines) {
                ++event;
                const glm::vec3 v = viewAt(cosine, 0.4f + (float) event);
                test::DirectionBins bins(24, 24, alpha);
                for (uint i = 0; i < drawn(); ++i)
                    bins.count(
                        glm::dvec3(visibleNormal(model, alpha, v, uniform(i, event, 0),
                                                 uniform(i, event, 1), uniform(i, event, 2))));
                const double p = bins.p(drawn(), test::cases(16, 64), [&](glm::dvec3 exact) {
                    const glm::vec3 m(exact);
                    const float seen = largestOf(dotProduct(v, m), 0.0f);
                    return (double) (facetMasking(model, alpha, v, m) *
                                     facetDensity(model, alpha, m) * seen / v.z);
                });
                EXPECT_GT(p, level)
                    << "model " << model << ", alpha " << alpha << ", cosine " << cosine;
                EXPECT_LT(p, 1.0 - level)
                    << "model " << model << ", alpha " << alpha << ", cosine " << cosine;
            }
}

struct Surface {
    glm::vec3 kd;
    float reflectance, metallic;
};
constexpr Surface kSurfaces[] = {{{0.8f, 0.6f, 0.3f}, 0.05f, 0.0f},
                                 {{0.9f, 0.7f, 0.2f}, 0.9f, 1.0f},
                                 {{0.5f, 0.5f, 0.5f}, 0.5f, 0.3f}};

TEST(Bsdf, DirectionsFollowTheirDensity) {
    const float widths[] = {1.0f, 0.4f, 0.15f};
    const float cosines[] = {0.95f, 0.5f, 0.1f};
    const double level =
        test::sidak(2 * std::size(kDistributions) * std::size(widths) * std::size(cosines));
    uint event = 1000;
    for (const uint model : kDistributions)
        for (const float alpha : widths)
            for (const float cosine : cosines) {
                ++event;
                const Surface& surface = kSurfaces[event % 3];
                const Lobes lobes =
                    makeLobes(surface.kd, surface.reflectance, surface.metallic, alpha, model);
                const glm::vec3 v = viewAt(cosine, 0.4f + (float) event);
                test::DirectionBins bins(32, 32, 1.0);
                uint total = 0;
                for (uint i = 0; i < drawn(); ++i) {
                    const Scattering next =
                        sampleBsdf(lobes, v, uniform(i, event, 0), uniform(i, event, 1),
                                   uniform(i, event, 2), uniform(i, event, 3));
                    if (next.direction.z > 0.0f && next.pdf > 0.0f) {
                        // The densities: that of the choice, and the one that light would be given.
                        const float again = bsdfPdf(lobes, v, next.direction);
                        ASSERT_NEAR(next.pdf / again, 1.0f, 1e-3f);
                        bins.count(glm::dvec3(next.direction));
                    } else {
                        bins.count(glm::dvec3(0.0)); // absorbed, or a mirror's
                    }
                    ++total;
                }
                const double p = bins.p(total, test::cases(16, 48), [&](glm::dvec3 exact) {
                    return (double) bsdfPdf(lobes, v, glm::vec3(exact));
                });
                EXPECT_GT(p, level)
                    << "model " << model << ", alpha " << alpha << ", cosine " << cosine;
                EXPECT_LT(p, 1.0 - level)
                    << "model " << model << ", alpha " << alpha << ", cosine " << cosine;
            }
}

} // namespace
} // namespace dirt
