// Energy, reciprocity and limits of the reflection of a surface.

#include "shaders/shared/bsdf.h"
#include "shaders/shared/random.h"

#include <cmath>

#include <gtest/gtest.h>

namespace dirt {
namespace {

constexpr uint kModels[] = {kBeckmann, kGgx, kCookTorrance, kPhong};
constexpr float kWidths[] = {1.0f, 0.6f, 0.25f, 0.05f, 0.004f, 0.0f};
constexpr int kDirections = 10;
constexpr uint kSamples = 16384;

glm::vec3 directionAt(float cosine, float azimuth) {
    const float sine = std::sqrt(1.0f - cosine * cosine);
    return unitVector({sine * std::cos(azimuth), sine * std::sin(azimuth), cosine});
}

/// Ten directions to look from, the last within half a degree of the horizon.
glm::vec3 view(int i) {
    const float cosines[kDirections] = {1.0f,  0.95f, 0.85f, 0.7f,  0.5f,
                                        0.35f, 0.2f,  0.1f,  0.03f, 0.008f};
    return directionAt(cosines[i], 1.3f * (float) i);
}

struct Reflected {
    double mean, error; ///< of a sum of weights: its standard deviation
};

/// What a surface under a sky of 1 reflects towards a direction, its largest component.
Reflected reflected(const Lobes& lobes, glm::vec3 v, uint event) {
    double sum = 0.0, squares = 0.0;
    for (uint i = 0; i < kSamples; ++i) {
        float u[4];
        for (uint d = 0; d < 4; ++d) u[d] = randomUnit(i, 0, event, d, 5);
        const Scattering next = sampleBsdf(lobes, v, u[0], u[1], u[2], u[3]);
        const double weight = std::max({next.weight.x, next.weight.y, next.weight.z});
        if (!(std::min({next.weight.x, next.weight.y, next.weight.z}) >= 0.0f && weight < HUGE_VAL))
            ADD_FAILURE() << "a weight of " << weight;
        sum += weight;
        squares += weight * weight;
    }
    const double mean = sum / kSamples;
    return {mean, std::sqrt(std::max(squares / kSamples - mean * mean, 0.0) / kSamples)};
}

/// A white surface with these lobes reflects no more than it receives. Means of weights that
/// scatter are off by their standard error; of 240 a surface, none by more than five.
void expectBounded(float reflectance, float metallic, const char* what) {
    uint event = 0;
    for (const uint model : kModels)
        for (const float alpha : kWidths)
            for (int i = 0; i < kDirections; ++i) {
                const Lobes lobes = makeLobes(glm::vec3(1), reflectance, metallic, alpha, model);
                const Reflected r = reflected(lobes, view(i), ++event);
                EXPECT_LE(r.mean, 1.0 + 1e-6 + 5.0 * r.error)
                    << what << ", model " << model << ", alpha " << alpha << ", direction " << i;
            }
}

TEST(Bsdf, LambertsLobeReflectsAll) {
    for (int i = 0; i < kDirections; ++i) {
        const Reflected r =
            reflected(makeLobes(glm::vec3(1), 0.0f, 0.0f, 0.5f, kBeckmann), view(i), 1);
        EXPECT_NEAR(r.mean, 1.0, 1e-6); // three roundings a sample
    }
}

TEST(Bsdf, MicrofacetsReflectAtMostAll) {
    expectBounded(1.0f, 1.0f, "white metal");
}

TEST(Bsdf, EachWeightOfMetalIsAtMostOne) {
    // The choice of visible normals leaves F G2 / G1.
    for (const uint model : kModels)
        for (const float alpha : kWidths)
            for (int i = 0; i < kDirections; ++i)
                for (uint n = 0; n < 1000; ++n) {
                    const Scattering next =
                        sampleBsdf(makeLobes(glm::vec3(1), 1.0f, 1.0f, alpha, model), view(i), 0.0f,
                                   randomUnit(n, 0, 0, 1, 0), randomUnit(n, 0, 0, 2, 0),
                                   randomUnit(n, 0, 0, 3, 0));
                    ASSERT_LE(next.weight.x, 1.0f + 1e-5f); // a dozen roundings
                }
}

TEST(Bsdf, BothLobesReflectAtMostAll) {
    for (const float reflectance : {0.04f, 0.5f})
        for (const float metallic : {0.0f, 0.5f})
            expectBounded(
                reflectance, metallic,
                (std::to_string(reflectance) + " metallic " + std::to_string(metallic)).c_str());
}

TEST(Bsdf, SmoothMetalReflectsNearlyAll) {
    // The limit: little roughness hides little. At 1.15 degrees from the horizon a slope of 0.004
    // shadows next to nothing.
    for (const uint model : kModels)
        for (int i = 0; i < 8; ++i)
            EXPECT_GT(
                reflected(makeLobes(glm::vec3(1), 1.0f, 1.0f, 0.004f, model), view(i), 9).mean,
                0.98)
                << "model " << model << ", direction " << i;
}

TEST(Bsdf, IsReciprocal) {
    uint n = 0;
    for (const uint model : kModels)
        for (const float alpha : {1.0f, 0.6f, 0.25f, 0.05f})
            for (int i = 0; i < kDirections; ++i)
                for (int k = 0; k < 200; ++k) {
                    ++n;
                    const Lobes lobes = makeLobes({0.9f, 0.5f, 0.1f}, 0.3f, 0.4f, alpha, model);
                    const glm::vec3 v = view(i);
                    // Around the reflection as well as anywhere.
                    const glm::vec3 m = visibleNormal(model, alpha, v, randomUnit(n, 0, 0, 0, 0),
                                                      randomUnit(n, 0, 0, 1, 0), 0.5f);
                    glm::vec3 l = k % 2 ? m * (2.0f * dotProduct(v, m)) - v
                                        : cosineHemisphere(randomUnit(n, 0, 0, 2, 0),
                                                           randomUnit(n, 0, 0, 3, 0));
                    if (!(l.z > 0.001f)) continue;
                    const glm::vec3 there = bsdfTimesCosine(lobes, v, l) / l.z;
                    const glm::vec3 back = bsdfTimesCosine(lobes, l, v) / v.z;
                    // The half vector is the same; v.m and l.m differ by a few roundings of 2^-24,
                    // relatively of their size, which is at least the smaller cosine's.
                    const float error = 1e-6f / std::min(l.z, v.z) + 2e-6f;
                    for (int c = 0; c < 3; ++c)
                        ASSERT_NEAR(there[c] / back[c], 1.0f, error)
                            << "model " << model << ", alpha " << alpha;
                }
}

TEST(Bsdf, AMirrorHasOneDirectionAndNoDensity) {
    for (const uint model : kModels) {
        const Lobes lobes = makeLobes({0.9f, 0.5f, 0.1f}, 1.0f, 1.0f, 0.0f, model);
        for (int i = 0; i < kDirections; ++i) {
            const glm::vec3 v = view(i);
            const Scattering next = sampleBsdf(lobes, v, 0.999f, 0.3f, 0.6f, 0.1f);
            EXPECT_EQ(next.direction, glm::vec3(-v.x, -v.y, v.z));
            EXPECT_EQ(next.pdf, 0.0f);
            EXPECT_EQ(next.weight, fresnel(lobes, v.z));
            EXPECT_EQ(bsdfTimesCosine(lobes, v, next.direction), glm::vec3(0.0f));
        }
    }
}

TEST(Bsdf, EvaluationOfTheNarrowestLobeIsWithinItsBound) {
    // The oracle: D by the formulas in double, from half vectors in double.
    const float alpha = kMirrorRoughness;
    for (const uint model : kModels)
        for (int i = 0; i < 8; ++i)
            for (uint n = 0; n < 2000; ++n) {
                const glm::vec3 v = view(i);
                const glm::vec3 m = visibleNormal(model, alpha, v, randomUnit(n, 0, 0, 0, 0),
                                                  randomUnit(n, 0, 0, 1, 0), 0.5f);
                const glm::vec3 l = m * (2.0f * dotProduct(v, m)) - v;
                if (!(l.z > 0.01f)) continue;
                const glm::dvec3 h = glm::dvec3(v) + glm::dvec3(l);
                const double a2 = (double) alpha * alpha;
                const double t = (h.x * h.x + h.y * h.y) / (h.z * h.z), c4 = 1 / (1 + t) / (1 + t);
                if (std::sqrt(t) > 4.0 * alpha) continue;
                double d = std::exp(-t / a2) / (M_PI * a2 * c4);
                if (model == kGgx) d = 1 / (M_PI * a2 * c4 * (1 + t / a2) * (1 + t / a2));
                if (model == kPhong) d = (1 + t) * std::exp(-std::log1p(t) / a2) / (M_PI * a2);
                const glm::vec3 both = v + l;
                EXPECT_NEAR(facetDensity(model, alpha, unitVector(both)) / d, 1.0, 0x1p-10)
                    << "model " << model << ", tan " << std::sqrt(t) / alpha << " alpha";
            }
}

} // namespace
} // namespace dirt
