#include "shaders/shared/random.h"
#include "shaders/shared/sampling.h"

#include "tests/path/chi_square.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace dirt {
namespace {

const glm::vec3 kNormals[] = {
    {0, 0, 1},
    {0, 0, -1},
    {1, 0, 0},
    {0, -1, 0},
    {0.6f, 0.8f, 0.0f},
    glm::normalize(glm::vec3(1, 2, 3)),
    glm::normalize(glm::vec3(-3, 1, -0.2f)),
    glm::normalize(glm::vec3(1e-4f, -1e-4f, -1)),
    glm::normalize(glm::vec3(1e-4f, 1, -1e-9f)),
};

TEST(Sampling, BasisIsOrthonormal) {
    for (const glm::vec3& n : kNormals) {
        glm::vec3 t, b;
        orthonormalBasis(n, t, b);
        // A handful of roundings of values of at most 1 (2^-24 each); n itself is a rounded unit
        // vector, and near n.z = -1 the basis doubles what n misses of length 1.
        const float bound = 8 * 0x1p-24f;
        EXPECT_NEAR(glm::dot(t, t), 1.0f, bound);
        EXPECT_NEAR(glm::dot(b, b), 1.0f, bound);
        EXPECT_NEAR(glm::dot(t, b), 0.0f, bound);
        EXPECT_NEAR(glm::dot(t, n), 0.0f, bound);
        EXPECT_NEAR(glm::dot(b, n), 0.0f, bound);
        EXPECT_GT(glm::dot(glm::cross(t, b), n), 0.99f);
    }
}

TEST(Sampling, CosineHemisphereFollowsItsDensity) {
    // Bins of equal steps in cos(theta) and phi, measured in a frame of our own. The share of a bin
    // is the integral of cos(theta)/pi over it: (c1^2 - c0^2) / phiBins.
    const int count = 1 << 19, cosineBins = 16, phiBins = 32;
    std::vector<double> expected;
    for (int c = 0; c < cosineBins; ++c)
        for (int phi = 0; phi < phiBins; ++phi)
            expected.push_back(count * (2.0 * c + 1.0) / (cosineBins * cosineBins) / phiBins);

    uint event = 1;
    for (const glm::vec3& n : kNormals) {
        const glm::dvec3 z(n);
        const glm::dvec3 x = glm::normalize(glm::cross(z, glm::dvec3(0.3, -0.7, 0.5)));
        const glm::dvec3 y = glm::cross(z, x);
        std::vector<double> counts(expected.size(), 0.0);
        for (uint i = 0; i < (uint) count; ++i) {
            const float u = randomUnit(i, 0, event, kDimensionScatterU, 0);
            const float v = randomUnit(i, 0, event, kDimensionScatterV, 0);
            const glm::dvec3 d(cosineAround(n, u, v));
            ASSERT_NEAR(glm::length(d), 1.0, 1e-6); // about ten roundings
            const double cosine = glm::dot(d, z);
            ASSERT_GT(cosine, 0.0);
            const double turn =
                std::atan2(glm::dot(d, y), glm::dot(d, x)) / (2.0 * std::numbers::pi) + 0.5;
            const int c = std::min((int) (cosine * cosineBins), cosineBins - 1);
            const int phi = std::min((int) (turn * phiBins), phiBins - 1);
            counts[c * phiBins + phi] += 1.0;
        }
        const double p = test::chiSquareP(counts, expected);
        EXPECT_GT(p, test::kLeastP) << "normal " << n.x << " " << n.y << " " << n.z;
        EXPECT_LT(p, test::kGreatestP) << "normal " << n.x << " " << n.y << " " << n.z;
        ++event;
    }
}

TEST(Sampling, TheExtremesOfTheRandomNumbersStayAboveTheSurface) {
    const float most = 1.0f - 0x1p-24f;
    for (const glm::vec3& n : kNormals)
        for (float u : {0.0f, 0x1p-24f, most})
            for (float v : {0.0f, 0.25f, 0.5f, 0.75f, most})
                EXPECT_GT(dotProduct(n, cosineAround(n, u, v)), 0.0f);
}

} // namespace
} // namespace dirt
