// The OpenGL context, and the way from a shader's files to the compiler and back to its lines.

#include "backend_gl/gl_backend.h"
#include "backend_gl/loop_probe.h"
#include "backend_gl/proposal_test.h"
#include "backend_gl/self_test.h"
#include "core/base/error.h"
#include "tests/gl/overlapping_halves.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <functional>

namespace dirt::test {
namespace {

std::string messageOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

TEST(GlContext, ListsWhatItOpens) {
    const std::vector<GlDevice> devices = listGlDevices();
    ASSERT_FALSE(devices.empty());
    for (size_t i = 0; i < devices.size(); ++i) {
        EXPECT_NE(devices[i].name.empty(), devices[i].problem.empty());
        if (devices[i].problem.empty()) {
            EXPECT_EQ(GlContext((int) i).name(), devices[i].name);
        }
    }
    EXPECT_THROW(GlContext((int) devices.size()), CapabilityError);
}

TEST(GlContext, ThrowsWhatTheDriverReports) {
    const GlContext context;
    EXPECT_NO_THROW(context.check());
    glEnable(GL_RGBA);
    EXPECT_THROW(context.check(), std::runtime_error);
    EXPECT_NO_THROW(context.check()) << "once";
}

TEST(GlContext, SeveralLiveSideBySide) {
    GlBackend first, second;
    first.clear(Camera{}, GridSettings{});
    second.clear(Camera{}, GridSettings{});
    first.fillDepth();
    EXPECT_EQ(first.readGrid().views.size(), 6u);
}

TEST(GlContext, ComputesAsTheHost) {
    GlContext context;
    Programs programs{ShaderFiles()};
    const std::string faults = arithmeticFaults(programs);
    context.check();
    if (context.name().find("llvmpipe") == std::string::npos && !faults.empty())
        GTEST_SKIP() << "not IEEE: " << faults;
    EXPECT_EQ(faults, "");
}

TEST(GlContext, ItsSelfTestCanFail) {
    GlContext context;
    const TemporaryFolder folder;
    for (const std::string& file : ShaderFiles::builtIn()) {
        std::string text = ShaderFiles().read(file);
        const std::string sum = "product + v.z;", fused = "float(double(v.x) * v.y + v.z);";
        if (file == "include/self_test.glsl") text.replace(text.find(sum), sum.size(), fused);
        if (file.find("self_test") != file.npos) folder.write(file, text);
    }
    Programs programs{ShaderFiles(folder.path())};
    EXPECT_EQ(arithmeticFaults(programs), "vertex, geometry, fragment, compute");
}

/// What the driver is asked before it may draw triangles for tiles; without conservative
/// rasterization they miss some. Both halves of a rectangle may be offered all its tiles.
TEST(GlContext, ItsProposalsAreTestedForMissingAndRepeatedTiles) {
    GlContext context;
    Programs programs{ShaderFiles()};
    EXPECT_FALSE(proposalFaults(programs, Proposal::rectangles).any());
    const ProposalFaults triangles = proposalFaults(programs, Proposal::triangles);
    EXPECT_GT(triangles.missed, 0u);
    EXPECT_EQ(triangles.repeated, 0u);

    const EditedShaders shaders;
    overlapHalves(shaders);
    Programs overlapping{shaders.files()};
    EXPECT_FALSE(proposalFaults(overlapping, Proposal::triangles).any());
    ownAllTiles(shaders);
    Programs repeating{shaders.files()};
    const ProposalFaults twice = proposalFaults(repeating, Proposal::triangles);
    EXPECT_EQ(twice.missed, 0u);
    EXPECT_GT(twice.repeated, 1000u);
    context.check();
}

/// Whether rays need several dispatches.
TEST(GlContext, ItsLoopsAreTested) {
    const GlContext context;
    Programs programs{ShaderFiles()};
    const bool isLlvmpipe = context.name().find("llvmpipe") != std::string::npos;
    const bool isKnown = context.name().find("Mesa 22.3") != std::string::npos;
    if (!isLlvmpipe || isKnown) {
        EXPECT_EQ(leavesLoops(programs), isLlvmpipe);
    }
    // What goes round 65535 times in all is through on any.
    const EditedShaders shaders;
    shaders.replace("loop_probe.comp", "i < rounds", "i < min(rounds, 60000u)");
    Programs shorter{shaders.files()};
    EXPECT_TRUE(leavesLoops(shorter));
    context.check();
}

TEST(ShaderFiles, NamesFileAndLineOfAnError) {
    const GlContext context;
    const TemporaryFolder folder;
    folder.write(
        "a.comp",
        "#version 450 core\nlayout(local_size_x = 1) in;\n#include \"b.glsl\"\nvoid main() {}\n");
    folder.write("b.glsl", "// \n#include \"c.glsl\"\n#include \"c.glsl\"\nfloat broken(;\n");
    folder.write("c.glsl", "float c;\n");
    const auto compile = [&] {
        Program(ShaderFiles(folder.path()), {"test", {"a.comp"}, {"X 1", "Y 2"}, {}});
    };
    EXPECT_EQ(messageOf(compile).substr(0, 9), "b.glsl:4:") << messageOf(compile);
    folder.write("b.glsl", "\nfloat fine;\n");
    EXPECT_EQ(messageOf(compile), "");
    folder.write("a.comp", "#version 450 core\nlayout(local_size_x = 1) in;\n#include "
                           "\"b.glsl\"\nvoid main() {\n  broken;\n}\n");
    EXPECT_EQ(messageOf(compile).substr(0, 9), "a.comp:5:") << messageOf(compile);
    folder.write("b.glsl", "\n#include \"none.glsl\"\n");
    EXPECT_EQ(messageOf(compile).substr(0, 23), "b.glsl:2: there is no s") << messageOf(compile);
}

TEST(ShaderFiles, ReadsTheLogsOfOtherDrivers) {
    const ShaderText text{"", {"a.frag", "b.glsl"}};
    EXPECT_EQ(text.withNames("1:12(5): error: x\n0:3(1): error: y\n"),
              "b.glsl:12: error: x\na.frag:3: error: y\n");
    EXPECT_EQ(text.withNames("1(12) : error C0000: x"), "b.glsl:12: error C0000: x");
    EXPECT_EQ(text.withNames("ERROR: 1:12: 'x' : y\nERROR: 1 compilation errors"),
              "b.glsl:12: 'x' : y\nERROR: 1 compilation errors");
}

TEST(ShaderFiles, ReloadsWhatWasEdited) {
    const TemporaryFolder folder;
    for (const std::string& file : ShaderFiles::builtIn()) {
        folder.write(file, ShaderFiles().read(file));
    }
    GlOptions options;
    options.shaders = ShaderFiles(folder.path());
    GlBackend backend(options);
    backend.clear(Camera{}, GridSettings{});
    backend.setGeometry({});
    backend.fillDepth();
    folder.write("fill_depth.frag", "#version 450 core\nbroken\n");
    EXPECT_NO_THROW(backend.fillDepth());
    const auto reload = [&] { backend.reloadShaders(); };
    EXPECT_EQ(messageOf(reload).substr(0, 18), "fill_depth.frag:2:");
    EXPECT_NO_THROW(backend.fillDepth()) << "those that it had stay";
    folder.write("fill_depth.frag", ShaderFiles().read("fill_depth.frag"));
    EXPECT_EQ(messageOf(reload), "");
    EXPECT_NO_THROW(backend.fillDepth());
}

} // namespace
} // namespace dirt::test
