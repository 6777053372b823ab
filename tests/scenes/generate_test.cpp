#include "scenes/generate/generate.h"

#include <gtest/gtest.h>

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "scenes/generate/scene_text.h"
#include "tests/support/random.h"

namespace {

namespace fs = std::filesystem;

std::string readFile(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    EXPECT_TRUE(stream) << path;
    return {std::istreambuf_iterator<char>(stream), {}};
}

fs::path freshFolder(const std::string& name) {
    const fs::path folder = fs::path(testing::TempDir()) / ("dirt_generate_" + name);
    fs::remove_all(folder);
    return folder;
}

/// What a generated OBJ holds; the reader takes only the form that the generator writes.
struct Obj {
    std::vector<std::array<float, 3>> positions;
    std::vector<std::array<float, 3>> normals;
    std::size_t texcoords = 0;
    std::size_t triangles = 0;
    std::size_t badIndices = 0;
    std::size_t badNumbers = 0;
    std::size_t zeroAreas = 0;
};

double doubledArea(const Obj& obj, const std::array<std::size_t, 3>& corner) {
    double e[2][3];
    for (int k = 0; k < 3; ++k) {
        e[0][k] = double(obj.positions[corner[1]][k]) - obj.positions[corner[0]][k];
        e[1][k] = double(obj.positions[corner[2]][k]) - obj.positions[corner[0]][k];
    }
    return std::hypot(e[0][1] * e[1][2] - e[0][2] * e[1][1], e[0][2] * e[1][0] - e[0][0] * e[1][2],
                      e[0][0] * e[1][1] - e[0][1] * e[1][0]);
}

Obj readObj(const fs::path& path) {
    const std::string text = readFile(path);
    Obj obj;
    const char* at = text.data();
    const char* const end = at + text.size();
    const auto number = [&](auto& value) {
        while (at < end && (*at == ' ' || *at == '/')) ++at;
        const auto result = std::from_chars(at, end, value);
        if (result.ec != std::errc()) ++obj.badNumbers;
        at = result.ptr;
    };
    while (at < end) {
        const std::string_view line(at,
                                    std::min<std::size_t>(3, static_cast<std::size_t>(end - at)));
        if (line.starts_with("v ") || line.starts_with("vn ")) {
            auto& list = line[1] == ' ' ? obj.positions : obj.normals;
            at += line[1] == ' ' ? 1 : 2;
            auto& vector = list.emplace_back();
            for (float& value : vector) {
                number(value);
                if (!std::isfinite(value)) ++obj.badNumbers;
            }
        } else if (line.starts_with("vt ")) {
            at += 2;
            float value = 0;
            number(value);
            number(value);
            ++obj.texcoords;
        } else if (line.starts_with("f ")) {
            ++at;
            std::array<std::size_t, 3> corner{};
            bool valid = true;
            for (std::size_t& index : corner) {
                std::size_t texcoord = 0;
                std::size_t normal = 0;
                number(index);
                number(texcoord);
                number(normal);
                valid = valid && index >= 1 && index <= obj.positions.size() && texcoord >= 1 &&
                        texcoord <= obj.texcoords && normal >= 1 && normal <= obj.normals.size();
                --index;
            }
            ++obj.triangles;
            if (!valid) {
                ++obj.badIndices;
            } else if (!(doubledArea(obj, corner) > 0)) {
                ++obj.zeroAreas;
            }
        }
        while (at < end && *at++ != '\n') {
        }
    }
    return obj;
}

class SceneDetail : public testing::TestWithParam<std::pair<std::string, double>> {};

TEST_P(SceneDetail, MeshIsSoundAndAsLargeAsWished) {
    const auto& [name, wished] = GetParam();
    const fs::path folder = freshFolder(name + std::to_string(static_cast<int>(wished)));
    dirt::generateScene(name, wished, folder);
    const Obj obj = readObj(folder / (name + ".obj"));
    EXPECT_NEAR(static_cast<double>(obj.triangles), wished, 0.2 * wished);
    EXPECT_EQ(obj.badNumbers, 0u);
    EXPECT_EQ(obj.badIndices, 0u);
    EXPECT_EQ(obj.zeroAreas, 0u);
    EXPECT_EQ(obj.texcoords, obj.positions.size());
    EXPECT_EQ(obj.normals.size(), obj.positions.size());
    std::size_t notUnit = 0;
    for (const auto& normal : obj.normals) {
        const double length = std::hypot(normal[0], normal[1], normal[2]);
        notUnit += std::abs(length - 1) > 1e-3; // normals are written with four decimals
    }
    EXPECT_EQ(notUnit, 0u);
    fs::remove_all(folder);
}

std::vector<std::pair<std::string, double>> wishes() {
    std::vector<std::pair<std::string, double>> all;
    for (const dirt::GeneratorInfo& info : dirt::generators()) {
        if (info.name == "cornell") continue; // has no ornament that could go
        all.emplace_back(info.name, info.minDetail);
        if (info.name == "atrium" || dirt::test::fullTests()) {
            all.emplace_back(info.name, info.defaultDetail);
        }
        if (dirt::test::fullTests()) all.emplace_back(info.name, 1e6);
    }
    return all;
}

INSTANTIATE_TEST_SUITE_P(Wishes, SceneDetail, testing::ValuesIn(wishes()));

TEST(Generate, SameArgumentsGiveTheSameBytes) {
    const fs::path first = freshFolder("first");
    const fs::path second = freshFolder("second");
    for (const dirt::GeneratorInfo& info : dirt::generators()) {
        const auto paths = dirt::generateScene(info.name, info.minDetail, first);
        dirt::generateScene(info.name, info.minDetail, second);
        for (const fs::path& path : paths) {
            EXPECT_TRUE(readFile(path) == readFile(second / path.filename())) << path;
        }
    }
    fs::remove_all(first);
    fs::remove_all(second);
}

TEST(Generate, CornellBoxHasThirtySixTriangles) {
    const fs::path folder = freshFolder("cornell");
    dirt::generateScene("cornell", 36, folder);
    const Obj obj = readObj(folder / "cornell.obj");
    EXPECT_EQ(obj.triangles, 36u);
    EXPECT_EQ(obj.zeroAreas, 0u);
    fs::remove_all(folder);
}

TEST(Generate, NothingTemporaryRemains) {
    const fs::path folder = freshFolder("listing");
    const auto paths = dirt::generateScene("cornell", 36, folder);
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        EXPECT_NE(entry.path().filename().string()[0], '.') << entry.path();
        ++files;
    }
    EXPECT_EQ(files, paths.size());
    fs::remove_all(folder);
}

TEST(Generate, BadArgumentsAreRefusedWithTheirRange) {
    const fs::path folder = freshFolder("refused");
    EXPECT_THROW(dirt::generateScene("nowhere", 1e5, folder), std::runtime_error);
    for (const double detail : {9e3, 2e7, -1.0, 0.0, std::nan("")}) {
        try {
            dirt::generateScene("atrium", detail, folder);
            FAIL() << detail;
        } catch (const std::runtime_error& error) {
            EXPECT_NE(std::string(error.what()).find("10000 to 10000000"), std::string::npos)
                << error.what();
        }
    }
    EXPECT_FALSE(fs::exists(folder));
}

TEST(Generate, SceneFilesOfTheRepositoryFollowTheTemplate) {
    for (const dirt::GeneratorInfo& info : dirt::generators()) {
        for (const std::string& scene : info.scenes) {
            const fs::path file = fs::path(DIRT_SOURCE_DIR) / "scenes" / (scene + ".scene");
            EXPECT_EQ(readFile(file),
                      dirt::generate::sceneText(scene, "generated/" + info.name + ".obj"));
        }
    }
}

} // namespace
