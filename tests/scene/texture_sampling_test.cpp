// Wrap modes and transforms of textures, against a plain evaluation in double.

#include "core/scene/scalar_texture.h"
#include "core/scene/texture.h"
#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <vector>

namespace dirt {
namespace {

constexpr int kWidth = 5, kHeight = 3;

/// Texels that differ from all others by much.
std::vector<float> values() {
    std::vector<float> texels;
    for (int i = 0; i < kWidth * kHeight; ++i) texels.push_back((float) (i * 7 % 15) / 14.0f);
    return texels;
}

/// The texel that stands \p i to the right of, or below, the image's first.
int wrapped(double i, int size, Wrap wrap) {
    if (wrap == Wrap::clamp) return (int) std::fmin(std::fmax(i, 0.0), size - 1.0);
    const double periods = wrap == Wrap::repeat ? size : 2.0 * size;
    const int within = (int) (i - periods * std::floor(i / periods));
    return within < size ? within : 2 * size - 1 - within;
}

/// What is at (\p u, \p v) of the image, v upwards.
double plainValue(const std::vector<float>& texels, double u, double v, Wrap wrapU, Wrap wrapV) {
    const double x = u * kWidth - 0.5, y = (1.0 - v) * kHeight - 0.5;
    const double left = std::floor(x), top = std::floor(y);
    double sum = 0.0;
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
            const int column = wrapped(left + i, kWidth, wrapU);
            const int row = wrapped(top + j, kHeight, wrapV);
            sum += texels[(size_t) (row * kWidth + column)] *
                   (i == 1 ? x - left : 1.0 - (x - left)) * (j == 1 ? y - top : 1.0 - (y - top));
        }
    return sum;
}

/// Texels differ by at most 1, so an error of e texels in the position, in each direction, changes
/// the value by at most e. Positions in [0, 1] are rounded twice, which is multiplied by the size,
/// then twice as numbers of texels below 8; three blends round three times each. \p lost: what the
/// image's coordinates are off by before.
double tolerance(double lost) {
    return 2.0 * (kWidth * (lost + FLT_EPSILON) + 8.0 * FLT_EPSILON) + 9.0 * FLT_EPSILON;
}

constexpr Wrap kWraps[] = {Wrap::repeat, Wrap::mirror, Wrap::clamp};

/// Each texture of both kinds at \p uv, against the plain value at \p u and \p v.
void expectSame(const TextureSampling& sampling, glm::vec2 uv, double u, double v,
                double lost = 0.0) {
    const std::vector<float> texels = values();
    const ScalarTexture scalars("s", kWidth, kHeight, texels);
    std::vector<float> colours;
    for (const float x : texels) colours.insert(colours.end(), {x, 1.0f - x, 0.5f * x});
    const Texture texture("c", kWidth, kHeight, std::move(colours));
    const double plain = plainValue(texels, u, v, sampling.wrapU, sampling.wrapV);
    const double most = tolerance(lost);
    const auto where = [&] {
        return testing::Message() << uv.x << ", " << uv.y << " wraps " << (int) sampling.wrapU
                                  << ", " << (int) sampling.wrapV;
    };
    EXPECT_NEAR(scalars.with(sampling).sample(uv), plain, most) << where();
    const glm::vec3 colour = texture.with(sampling).sample(uv);
    EXPECT_NEAR(colour.x, plain, most) << where();
    EXPECT_NEAR(colour.y, 1.0 - plain, most) << where();
    EXPECT_NEAR(colour.z, 0.5 * plain, most) << where();
}

TEST(TextureSampling, WrapsAsAPlainEvaluationDoes) {
    // At, beside and between borders and texel centres, on both sides of 0; whole periods away.
    std::vector<float> places;
    for (const float whole : {0.0f, 1.0f, -1.0f, 2.0f, -2.0f, 3.0f, 1000.0f, -1001.0f})
        for (const float part : {0.0f, 0.03125f, 0.1f, 0.25f, 0.5f, 0.75f, 0.9f, 0.96875f}) {
            const float x = whole + part;
            places.insert(places.end(),
                          {x, std::nextafter(x, -FLT_MAX), std::nextafter(x, FLT_MAX)});
        }
    for (const Wrap u : kWraps)
        for (const Wrap v : kWraps)
            for (const float x : places)
                for (const float y : {0.0f, 0.2f, 0.99f, 1.0f, -0.3f, 1.4f, -7.7f, 12.5f}) {
                    TextureSampling sampling;
                    sampling.wrapU = u;
                    sampling.wrapV = v;
                    expectSame(sampling, {x, y}, x, y);
                    expectSame(sampling, {y, x}, y, x);
                }
}

TEST(TextureSampling, ClampsToTheBordersTexels) {
    const ScalarTexture ramp("r", 4, 1, std::vector<float>{0.0f, 0.25f, 0.5f, 1.0f});
    TextureSampling clamp;
    clamp.wrapU = clamp.wrapV = Wrap::clamp;
    for (const float u : {0.0f, 0.125f, -0.001f, -5.0f, -1e30f})
        EXPECT_EQ(ramp.with(clamp).sample({u, 0.5f}), 0.0f) << u;
    for (const float u : {1.0f, 0.875f, 1.001f, 7.0f, FLT_MAX})
        EXPECT_EQ(ramp.with(clamp).sample({u, -3.0f}), 1.0f) << u;
    EXPECT_EQ(ramp.with(clamp).slopes({2.0f, 0.5f}), glm::vec2(0.0f));
}

TEST(TextureSampling, MirrorsEverySecondPeriod) {
    const ScalarTexture ramp("r", 4, 1, std::vector<float>{0.0f, 0.25f, 0.5f, 1.0f});
    TextureSampling mirror;
    mirror.wrapU = Wrap::mirror;
    const ScalarTexture mirrored = ramp.with(mirror);
    // Dyadic coordinates: no operation rounds.
    for (const float u : {0.0f, 0.125f, 0.25f, 0.4375f, 0.875f, 1.0f}) {
        for (const float period : {2.0f, -2.0f, 4096.0f})
            EXPECT_EQ(mirrored.sample({u + period, 0}), mirrored.sample({u, 0})) << u;
        EXPECT_EQ(mirrored.sample({-u, 0}), mirrored.sample({u, 0})) << u;
        EXPECT_EQ(mirrored.sample({2.0f - u, 0}), mirrored.sample({u, 0})) << u;
    }
    EXPECT_EQ(mirrored.sample({1.0f, 0}), 1.0f); // beside the border is the border again
    EXPECT_EQ(mirrored.slopes({1.5f, 0}).x, -ramp.slopes({0.5f, 0}).x);
}

TEST(TextureSampling, TakesAnyFiniteCoordinates) {
    const ScalarTexture texture("t", kWidth, kHeight, values());
    const float coordinates[] = {
        0.0f,  -0.0f, 1.0f,   FLT_MIN, -FLT_MIN, 1e-45f, -1e-45f, 8388607.5f, -8388607.5f, 1e9f,
        -1e9f, 3e30f, -3e30f, FLT_MAX, -FLT_MAX, 1e-8f,  -1e-8f,  16777216,   -16777218};
    for (const Wrap wrap : kWraps)
        for (const float huge : {1.0f, -3.0f, FLT_MAX}) {
            TextureSampling sampling;
            sampling.wrapU = sampling.wrapV = wrap;
            sampling.transformed = true;
            sampling.rowU = {huge, -huge, huge};
            sampling.rowV = {huge, huge, -huge};
            TextureSampling plain = sampling;
            plain.transformed = false;
            for (const float u : coordinates)
                for (const float v : coordinates)
                    for (const TextureSampling& s : {sampling, plain}) {
                        const float value = texture.with(s).sample({u, v});
                        EXPECT_TRUE(value >= 0.0f && value <= 1.0f) << u << ' ' << v;
                    }
        }
}

TEST(TextureSampling, TransformsCoordinates) {
    test::Random random(0x5a3);
    for (int i = 0; i < 2000; ++i) {
        const auto number = [&](double size) { return (float) random.uniform(-size, size); };
        TextureSampling sampling;
        sampling.wrapU = kWraps[i % 3];
        sampling.wrapV = kWraps[i / 3 % 3];
        sampling.transformed = true;
        const float angle = number(3.2), size = 1.0f + number(0.9), squeeze = 1.0f + number(0.9);
        const float cosine = std::cos(angle), sine = std::sin(angle); // scaled, turned and moved
        sampling.rowU = {cosine * size, -sine * squeeze, number(2.0)};
        sampling.rowV = {sine * size, cosine * squeeze, number(2.0)};
        const glm::vec2 uv{number(2.0), number(2.0)};
        const glm::dvec3 at(uv, 1.0f);
        const glm::dvec3 u = glm::dvec3(sampling.rowU) * at, v = glm::dvec3(sampling.rowV) * at;
        // Half an ulp of two products below 4, of a sum below 8 and one below 16.
        expectSame(sampling, uv, u.x + u.y + u.z, v.x + v.y + v.z, 8.0 * FLT_EPSILON);
    }
}

TEST(TextureSampling, SharesTexels) {
    const Texture texture("t", 2, 3, std::vector<uint8_t>(18, 9), TexelEncoding::linear);
    TextureSampling sampling;
    sampling.wrapU = Wrap::clamp;
    const Texture other = texture.with(sampling);
    EXPECT_EQ(other.encodedTexels().data(), texture.encodedTexels().data());
    EXPECT_EQ(other.identity(), texture.identity());
    EXPECT_EQ(other.encoding(), TexelEncoding::linear);
    EXPECT_EQ(other.sampling(), sampling);
    EXPECT_EQ(texture.sampling(), TextureSampling());
    EXPECT_EQ(other.file(), "t");

    const ScalarTexture scalars("s", 2, 2, std::vector<float>(4, 0.5f));
    EXPECT_EQ(scalars.with(sampling).identity(), scalars.identity());
    EXPECT_NE(ScalarTexture("s", 2, 2, std::vector<float>(4, 0.5f)).identity(), scalars.identity());
}

TEST(TextureSampling, TexelsOutliveTheFirstTexture) {
    Texture copy;
    {
        const Texture first("t", 1, 1, std::vector<float>{0.25f, 0.5f, 1.0f});
        copy = first.with({});
    }
    EXPECT_EQ(copy.sample({0.3f, 0.3f}), glm::vec3(0.25f, 0.5f, 1.0f));
}

TEST(TextureSampling, LinearBytesAreFractions) {
    for (int i = 0; i < 256; ++i)
        EXPECT_EQ(Texture("t", 1, 1, std::vector<uint8_t>(3, (uint8_t) i), TexelEncoding::linear)
                      .sample({0, 0})
                      .x,
                  (float) i / 255.0f);
}

} // namespace
} // namespace dirt
