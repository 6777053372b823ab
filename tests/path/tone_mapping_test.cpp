#include "core/path/tone_mapping.h"

#include <cmath>

#include <gtest/gtest.h>

namespace dirt {
namespace {

double curve(double value, double key, double white) {
    return std::log(1.0001 + std::pow(10.0, key) * value) /
           std::log(1.0001 + std::pow(10.0, key) * white);
}

TEST(ToneMapping, FollowsTheFormula) {
    for (float key : {-1.0f, 0.0f, 1.0f, 2.5f})
        for (float white : {0.5f, 1.0f, 2.0f, 100.0f}) {
            const DisplayEncoding encode({key, white});
            for (float value : {0.0f, 1e-6f, 1e-3f, 0.1f, 0.5f, 1.0f, 7.0f, 1e4f}) {
                // The argument of the logarithm is rounded to float twice, each time by at most
                // 2^-24 of it, and so its logarithm moves by that; the rest is relative.
                const double white_ = std::log(1.0001 + std::pow(10.0, key) * white);
                const double exact = curve(value, key, white);
                const double bound =
                    2 * 0x1p-23 / white_ + exact * (8 * 0x1p-24 + 2 * 0x1p-23 / white_);
                EXPECT_NEAR(encode(glm::vec3(value)).x, exact, bound)
                    << "key " << key << ", white " << white << ", value " << value;
            }
        }
}

TEST(ToneMapping, KeepsHueAndSaturation) {
    const DisplayEncoding encode({1.0f, 2.0f});
    const glm::vec3 in(0.2f, 1.6f, 0.4f);
    const glm::vec3 out = encode(in);
    EXPECT_NEAR(out.x / out.y, in.x / in.y, 4 * 0x1p-24);
    EXPECT_NEAR(out.z / out.y, in.z / in.y, 4 * 0x1p-24);
    EXPECT_EQ(out.y, encode(glm::vec3(1.6f)).y);
}

TEST(ToneMapping, BytesAreClampedAndRounded) {
    const DisplayEncoding encode({1.0f, 1.0f});
    const float nan = std::nanf("");
    const glm::vec3 pixels[] = {{0, 0, 0}, {1, 1, 1}, {50, 50, 50}, {nan, nan, nan}};
    const std::vector<uint8_t> bytes = encode.bytes(pixels);
    ASSERT_EQ(bytes.size(), 12u);
    EXPECT_EQ(bytes[0], 0);
    EXPECT_EQ(bytes[3], 255);
    EXPECT_EQ(bytes[6], 255);
    EXPECT_EQ(bytes[9], 0);
    const glm::vec3 middle(0.3f);
    EXPECT_EQ(encode.bytes({&middle, 1})[0], std::lround(255.0 * curve(0.3, 1.0, 1.0)));
}

} // namespace
} // namespace dirt
