// The picture of a bare model does not depend on its unit of length: eye, light and all are found
// alike at any scale, on every backend. Scales in each other, and copies in one place, are answered
// at once.

#include "core/io/image.h"
#include "tests/cli/program.h"
#include "tests/support/processor_time.h"

#include <algorithm>
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

class Answers : public testing::Test {
protected:
    /// In a time that does not grow with what is nested or repeated.
    Outcome render(const std::string& scene) {
        Outcome run;
        EXPECT_LT(processorTime([&] {
                      run = dirt({"render", scene, "--size", "32x16", "--spp", "2", "--quiet",
                                  "--no-cache", "-o", folder_ / "a.exr"});
                  }),
                  kGenerous);
        return run;
    }

    TemporaryFolder folder_;
};

TEST_F(Answers, ScalesInEachOtherMultiply) {
    folder_.write("a.obj", kTriangleObj);
    const auto nested = [&](const std::string& scale) {
        std::string open, close;
        for (int i = 0; i < 250; ++i) {
            open += "<transformation scale=\"" + scale + "\">";
            close += "</transformation>";
        }
        return folder_.write("a.scene", "<world background=\"1 1 1\">" + open +
                                            "<object file=\"a.obj\"/>" + close + "</world>");
    };
    for (const char* scale : {"1.4 1.4 1.4", "1 1 1", "0.75 0.75 0.75"}) {
        EXPECT_EQ(render(nested(scale)).status, 0) << scale;
        const double mean = meanOf(readImage(folder_ / "a.exr"));
        EXPECT_GT(mean, 0.5) << scale;
        EXPECT_LT(mean, 0.98) << scale << ": the triangle is dark before the sky";
    }
    const Outcome beyond = render(nested("1.5 1.5 1.5"));
    EXPECT_EQ(beyond.status, 2);
    EXPECT_EQ(std::count(beyond.err.begin(), beyond.err.end(), '\n'), 1) << beyond.err;
}

TEST_F(Answers, HundredsOfCopiesInOnePlaceAreSeenAsOne) {
    std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (int i = 0; i < 800; ++i) obj += "f 1 2 3\n";
    EXPECT_EQ(render(folder_.write("one.obj", obj.substr(0, obj.find('f') + 8))).status, 0);
    const Image one = readImage(folder_ / "a.exr");
    EXPECT_NE(meanOf(one), 0.5) << "else there is nothing but the background";
    EXPECT_EQ(render(folder_.write("many.obj", obj)).status, 0);
    EXPECT_EQ(readImage(folder_ / "a.exr").pixels, one.pixels);
}

INSTANTIATE_TEST_SUITE_P(Backends, Scales, testing::Values("cpu", "embree", "gl"));

} // namespace
} // namespace dirt::test
