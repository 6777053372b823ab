// The picture of a bare model does not depend on its unit of length: eye, light and all are found
// alike at any scale, on every backend.

#include "core/io/image.h"
#include "tests/cli/program.h"

#include <cmath>
#include <cstdio>

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

/// The sides of some boxes in a row, times \p scale.
std::string boxes(double scale) {
    std::string obj;
    const auto vertex = [&](int x, int y, int z) {
        char line[96];
        std::snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", x * scale, y * scale, z * scale);
        obj += line;
    };
    for (int box = 0; box < 4; ++box) {
        for (int corner = 0; corner < 8; ++corner)
            vertex(3 * box + (corner & 1 ? 2 : 0), corner & 2 ? 1 + box : 0, corner & 4 ? 2 : 0);
        obj += "f -8 -6 -5 -7\nf -4 -3 -1 -2\nf -8 -7 -3 -4\nf -6 -2 -1 -5\nf -8 -4 -2 -6\n"
               "f -7 -5 -1 -3\n";
    }
    return obj;
}

class Scales : public testing::TestWithParam<const char*> {
protected:
    Image render(double scale) {
        const Outcome run =
            dirt({"render", folder_.write("a.obj", boxes(scale)), "--size", "32x16", "--spp", "2",
                  "--bounces", "2", "--backend", GetParam(), "-o", folder_ / "a.exr"});
        EXPECT_EQ(run.status, 0) << run.err;
        EXPECT_EQ(run.err.find("warning"), std::string::npos) << run.err;
        return readImage(folder_ / "a.exr");
    }
    bool isThere() {
        const Outcome run = dirt({"render", folder_.write("one.obj", kTriangleObj), "--size", "2x2",
                                  "--backend", GetParam(), "-o", folder_ / "one.exr"});
        return run.status != 3;
    }

    TemporaryFolder folder_;
};

double meanOf(const Image& image) {
    double sum = 0.0;
    for (const glm::vec3& pixel : image.pixels) sum += pixel.x;
    return sum / (double) image.pixels.size();
}

TEST_P(Scales, PowersOfTwoAreEqualToTheBit) {
    if (!isThere()) GTEST_SKIP() << "no " << GetParam();
    const Image one = render(1.0);
    EXPECT_GT(meanOf(one), 0.3);
    for (const int exponent : {-83, -30, 30, 83}) // 1e-25 to 1e25
        EXPECT_EQ(render(std::ldexp(1.0, exponent)).pixels, one.pixels) << exponent;
}

/// Coordinates are rounded otherwise, so that single samples beside an edge see another side of it.
TEST_P(Scales, PowersOfTenAreClose) {
    if (!isThere()) GTEST_SKIP() << "no " << GetParam();
    const Image one = render(1.0);
    for (const double scale : {1e-25, 1e-10, 1e10, 1e25}) {
        const Image other = render(scale);
        size_t far = 0;
        for (size_t i = 0; i < one.pixels.size(); ++i)
            far += !(std::abs(other.pixels[i].x - one.pixels[i].x) < 1e-3f);
        EXPECT_LE(far, one.pixels.size() / 50) << scale;
        EXPECT_NEAR(meanOf(other) / meanOf(one), 1.0, 0.005) << scale;
    }
}

INSTANTIATE_TEST_SUITE_P(Backends, Scales, testing::Values("cpu", "embree", "gl"));

} // namespace
} // namespace dirt::test
