// Bad options and bad input end in one line on standard error and the right exit status.

#include "tests/cli/program.h"

#include <gtest/gtest.h>

namespace dirt::test {
namespace {

/// One line that begins with "dirt: " and says all of \p parts; nothing on standard output.
void expectLine(const Outcome& run, int status, const std::vector<std::string>& parts) {
    EXPECT_EQ(run.status, status) << run.err;
    EXPECT_EQ(run.out, "");
    ASSERT_FALSE(run.err.empty());
    EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
    EXPECT_EQ(run.err.rfind("dirt: ", 0), 0u) << run.err;
    for (const std::string& part : parts)
        EXPECT_NE(run.err.find(part), std::string::npos) << part << " is not in " << run.err;
}

struct BadOption {
    const char *name, *value;
};

void PrintTo(const BadOption& option, std::ostream* out) {
    *out << option.name << " '" << option.value << "'";
}

class OptionOutOfRange : public testing::TestWithParam<BadOption> {};

TEST_P(OptionOutOfRange, IsNamedWithItsText) {
    const auto [name, value] = GetParam();
    const TemporaryFolder folder;
    const std::string scene = folder.write("a.obj", kTriangleObj);
    expectLine(dirt({"info", scene, name, value}), 2,
               {std::string(name) + ":", std::string("'") + value + "'"});
}

INSTANTIATE_TEST_SUITE_P(
    All, OptionOutOfRange,
    testing::Values(BadOption{"--size", "0x5"}, BadOption{"--size", "5"}, BadOption{"--size", "5x"},
                    BadOption{"--size", "-5x5"}, BadOption{"--size", "5x5x5"},
                    BadOption{"--size", "5x0"}, BadOption{"--size", "0x0"},
                    BadOption{"--size", "1000000x1"}, BadOption{"--size", "1000000x1000000"},
                    BadOption{"--size", "65537x1"}, BadOption{"--size", "99999999999x1"},
                    BadOption{"--tile", "0"}, BadOption{"--tile", "65"}, BadOption{"--tile", "-1"},
                    BadOption{"--tile", "2.5"}, BadOption{"--tile", "two"}, BadOption{"--tile", ""},
                    BadOption{"--tile", "8 "}, BadOption{"--bins", "0"}, BadOption{"--bins", "257"},
                    BadOption{"--view-size", "0"}, BadOption{"--view-size", "65537"},
                    BadOption{"--view-size", "1000000"}, BadOption{"--tile", "1000000"},
                    BadOption{"--bins", "1000000"}, BadOption{"--max-mip", "-1"},
                    BadOption{"--max-mip", "14"}, BadOption{"--traversal", "Linear"},
                    BadOption{"--view", "both"}, BadOption{"--backend", "vulkan"},
                    BadOption{"--spp", "0"}, BadOption{"--spp", "1e3"},
                    BadOption{"--spp", "18446744073709551617"}, BadOption{"--bounces", "0"},
                    BadOption{"--bounces", "1025"}, BadOption{"--seed", "-1"},
                    BadOption{"--seed", "4294967296"}, BadOption{"--threads", "0"},
                    BadOption{"--precision", "double"}, BadOption{"--eye", "1,2"},
                    BadOption{"--eye", "1,2,3,4"}, BadOption{"--eye", "1,2,nan"},
                    BadOption{"--up", "0,inf,0"}, BadOption{"--target", "1,,2"},
                    BadOption{"--fov", "0"}, BadOption{"--fov", "180"}, BadOption{"--fov", "nan"}));

/// What main() adds to what all other tests here call without starting a process.
TEST(Errors, TheProcessEndsWithTheStatus) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("a.obj", kTriangleObj);
    EXPECT_EQ(startDirt({"info", scene}).status, 0);
    expectLine(startDirt({"info", folder / "none.obj"}), 2, {folder / "none.obj"});
    expectLine(startDirt({"info", scene, "--backend", "gl", "--device", "63"}), 3, {});
}

TEST(Errors, UnknownCommandsAndOptionsAreNamed) {
    expectLine(dirt({"frobnicate"}), 2, {"'frobnicate'"});
    expectLine(dirt({"--frob"}), 2, {"'--frob'"});
    expectLine(dirt({"info", "a.obj", "--frob"}), 2, {"'--frob'"});
    expectLine(dirt({"info", "a.obj", "b.obj"}), 2, {"'b.obj'"});
}

TEST(Errors, WhatIsMissingIsNamed) {
    expectLine(dirt({"info"}), 2, {"SCENE"});
    expectLine(dirt({"info", "a.obj", "--tile"}), 2, {"--tile"});
    expectLine(dirt({"generate"}), 2, {"NAME"});
    expectLine(dirt({"generate", "atrium"}), 2, {"-o"});
}

TEST(Errors, CapabilitiesThatAreMissingHaveTheirOwnStatus) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("a.obj", kTriangleObj);
    expectLine(dirt({"info", scene, "--backend", "gl", "--device", "63"}), 3, {});
}

TEST(Errors, SceneFilesThatCannotBeReadAreNamed) {
    const TemporaryFolder folder;
    expectLine(dirt({"info", folder / "none.obj"}), 2, {folder / "none.obj"});
    expectLine(dirt({"info", folder / "none.scene"}), 2, {folder / "none.scene"});
    expectLine(dirt({"info", folder.path()}), 2, {folder.path()});
    expectLine(dirt({"info", folder.write("a.txt", kTriangleObj)}), 2, {"a.txt"});
    expectLine(dirt({"info", folder.write("empty.obj", "")}), 2, {"empty.obj"});
    expectLine(dirt({"info", folder.write("points.obj", "v 0 0 0\n")}), 2, {"points.obj"});
}

TEST(Errors, BadGeometryIsNamedWithFileAndLine) {
    const TemporaryFolder folder;
    expectLine(dirt({"info", folder.write("nan.obj", "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n")}), 2,
               {"nan.obj:2"});
    expectLine(dirt({"info", folder.write("range.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n")}), 2,
               {"range.obj:4"});
    expectLine(dirt({"info", folder.write("bad.scene", "<world>\n<camera\n</world>\n")}), 2,
               {"bad.scene:"});
}

TEST(Errors, CamerasThatShowNothingAreRefused) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("a.obj", kTriangleObj);
    expectLine(dirt({"info", scene, "--eye", "1,2,3", "--target", "1,2,3"}), 2, {"--eye"});
    expectLine(dirt({"info", scene, "--up", "0,0,0"}), 2, {"--up"});
    expectLine(dirt({"info", scene, "--eye", "0,0,0", "--target", "0,-1,0"}), 2, {"up"});
}

TEST(Errors, SizesBeyondTheMachineAreRefusedBeforeTheyAreTried) {
    const TemporaryFolder folder;
    const std::string scene = folder.write("a.obj", kTriangleObj);
    // 4 G pixels, 10^11 cells: 275 GB and 412 GB.
    expectLine(dirt({"info", scene, "--size", "65536x65536"}), 2, {"65536x65536", "GB"});
    expectLine(dirt({"info", scene, "--view-size", "8192", "--tile", "1", "--bins", "256"}), 2,
               {"--tile 1 --bins 256", "GB", "would fit"});
}

TEST(Errors, StrictMakesWarningsErrors) {
    const TemporaryFolder folder;
    const std::string scene =
        folder.write("a.obj", std::string("mtllib none.mtl\n") + kTriangleObj);
    EXPECT_EQ(dirt({"info", scene}).status, 0);
    expectLine(dirt({"info", scene, "--strict"}), 2, {"a.obj:1", "none.mtl"});
}

} // namespace
} // namespace dirt::test
