// `dirt compare`: its figures, its picture, and what it refuses.

#include "core/io/image.h"
#include "tests/cli/program.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace dirt::test {
namespace {

using nlohmann::json;

class Compare : public testing::Test {
protected:
    std::string png(const std::string& name, int width, int height,
                    const std::vector<uint8_t>& rgb) {
        writePng(folder / name, width, height, rgb, {});
        return folder / name;
    }
    std::string exr(const std::string& name, const Image& image) {
        writeExr(folder / name, image, {});
        return folder / name;
    }
    void expectRefusal(const std::vector<std::string>& arguments, const std::string& part) {
        std::vector<std::string> all = arguments;
        all.insert(all.begin(), "compare");
        const Outcome run = dirt(all);
        EXPECT_EQ(run.status, 2);
        EXPECT_EQ(run.out, "");
        EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
        EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
    }

    TemporaryFolder folder;
};

json compared(const std::string& a, const std::string& b, int status = 0) {
    const Outcome run = dirt({"compare", a, b, "--json"});
    EXPECT_EQ(run.status, status) << run.err;
    return json::parse(run.out);
}

TEST_F(Compare, DisplayValuesOfPng) {
    const std::string a = png("a.png", 2, 1, {255, 0, 0, 51, 51, 51});
    const std::string b = png("b.png", 2, 1, {255, 0, 0, 51, 102, 51});
    const json got = compared(a, b);
    EXPECT_EQ(got["size"], json({2, 1}));
    EXPECT_EQ(got["values"], "display");
    EXPECT_NEAR(got["rmse"], std::sqrt(0.04 / 6), 1e-7); // 8-bit values as float: 2^-24 each
    EXPECT_NEAR(got["relative_mse"], 0.04 / (0.16 + 0.01) / 6, 1e-7);
    EXPECT_NEAR(got["psnr"], 10 * std::log10(6 / 0.04), 1e-5);
    EXPECT_NEAR(got["max"], 0.2, 1e-7);
    EXPECT_EQ(got["max_at"], json({1, 0}));
    EXPECT_GT(got["flip"], 0.0);
    EXPECT_LT(got["flip"], 1.0);
}

TEST_F(Compare, RadianceOfExr) {
    const json got = compared(exr("a.exr", {1, 1, {{4.0f, 2.0f, 0.0f}}}),
                              exr("b.exr", {1, 1, {{4.0f, 5.0f, 0.0f}}}));
    EXPECT_EQ(got["values"], "linear");
    EXPECT_DOUBLE_EQ(got["rmse"], std::sqrt(3.0));
    EXPECT_DOUBLE_EQ(got["relative_mse"], 9 / 25.01 / 3);
    EXPECT_DOUBLE_EQ(got["psnr"], 20 * std::log10(5 / std::sqrt(3.0)));
    EXPECT_EQ(got["max"], 3.0);
}

TEST_F(Compare, EqualImagesHaveAnInfinitePsnrWhichJsonHasNot) {
    const std::string a = exr("a.exr", {2, 2, std::vector<glm::vec3>(4, {0.5f, 0.1f, 9.0f})});
    const json got = compared(a, a);
    EXPECT_EQ(got["rmse"], 0.0);
    EXPECT_EQ(got["relative_mse"], 0.0);
    EXPECT_EQ(got["max"], 0.0);
    EXPECT_EQ(got["flip"], 0.0);
    EXPECT_TRUE(got["psnr"].is_null());
    const Outcome text = dirt({"compare", a, a});
    EXPECT_EQ(text.status, 0);
    EXPECT_NE(text.out.find("infinite"), std::string::npos) << text.out;
}

TEST_F(Compare, PixelsThatAreNotFiniteAreCountedAndFailTheCheck) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float infinity = std::numeric_limits<float>::infinity();
    const std::string a = exr("a.exr", {3, 1, {{nan, 0, 0}, {1, 1, 1}, {1, 1, 1}}});
    const std::string b = exr("b.exr", {3, 1, {{0, 0, 0}, {infinity, 1, 1}, {1, 1, 1}}});
    const json got = compared(a, b, 1);
    EXPECT_EQ(got["not_finite"], json({{"image", 1}, {"reference", 1}}));
    EXPECT_EQ(got["compared"], 1);
    EXPECT_EQ(got["rmse"], 0.0);
    EXPECT_EQ(got["flip"], 0.0);
    const Outcome run = dirt({"compare", a, b});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.err.find("2 of 3 pixels"), std::string::npos) << run.err;

    const std::string none = exr("none.exr", {1, 1, {{nan, nan, nan}}});
    const json nothing = compared(none, none, 1);
    for (const char* key : {"rmse", "relative_mse", "psnr", "max", "flip"})
        EXPECT_TRUE(nothing[key].is_null()) << key;
}

TEST_F(Compare, DiffShowsWhereTheDifferenceIs) {
    std::vector<uint8_t> black(40 * 30 * 3, 0), dot = black;
    for (int c = 0; c < 3; ++c) dot[(15 * 40 + 17) * 3 + c] = 255;
    const std::string diff = folder / "diff.png";
    const Outcome run = dirt(
        {"compare", png("dot.png", 40, 30, dot), png("black.png", 40, 30, black), "--diff", diff});
    EXPECT_EQ(run.status, 0) << run.err;
    const Image map = readImage(diff);
    ASSERT_EQ(map.width, 40);
    ASSERT_EQ(map.height, 30);
    EXPECT_EQ(map.pixels[0], glm::vec3(0.0f));
    const glm::vec3 bright = map.pixels[15 * 40 + 17]; // 0.865: orange
    EXPECT_GT(bright.r, 0.9f);
    EXPECT_GT(bright.g, 0.6f);
    EXPECT_LT(bright.b, 0.7f);
}

TEST_F(Compare, RefusesWhatCannotBeCompared) {
    const std::string a = png("a.png", 2, 1, std::vector<uint8_t>(6));
    const std::string b = png("b.png", 1, 2, std::vector<uint8_t>(6));
    const std::string c = exr("c.exr", {2, 1, std::vector<glm::vec3>(2, glm::vec3(0.0f))});
    expectRefusal({a, b}, "2x1");
    expectRefusal({a, c}, "two of a kind");
    expectRefusal({a, folder / "none.png"}, "none.png");
    expectRefusal({a, folder.write("text.png", "text")}, "text.png");
    expectRefusal({a, folder.write("a.jpg", "")}, "a.jpg");
    expectRefusal({a, a, "--diff", folder / "diff.exr"}, "diff.exr");
    expectRefusal({a, a, "--diff", folder / "no/such/diff.png"}, "diff.png");
    expectRefusal({a}, "B");
    EXPECT_FALSE(std::filesystem::exists(folder / "diff.exr"));
}

} // namespace
} // namespace dirt::test
