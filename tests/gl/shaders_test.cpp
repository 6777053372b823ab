// Every variant of every shader through Khronos' own compiler, which drivers are stricter and laxer
// than in their own ways.

#include "backend_gl/programs.h"
#include "tests/support/random.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <regex>

namespace dirt::test {
namespace {

/// What a scene may have of normals, textures, heights and holes; texels in one piece or two. In
/// the suite each of them with and without the others, if not with each. Last, of normal, roughness
/// and metallic maps, factors, wraps, transforms, data and colours each alone, and all.
std::vector<SurfaceVariant> surfaceVariants() {
    std::vector<SurfaceVariant> variants;
    for (bool normals : {false, true})
        for (int pieces : {0, 1, 2}) // none: no textures
            if (fullTests() || normals == (pieces > 0))
                variants.push_back({normals, pieces > 0, pieces > 1, pieces == 1, pieces, 27});
    for (const auto has :
         {&SurfaceVariant::normalMaps, &SurfaceVariant::roughnessMaps,
          &SurfaceVariant::metallicMaps, &SurfaceVariant::factors, &SurfaceVariant::wraps,
          &SurfaceVariant::transforms, &SurfaceVariant::linearBytes, &SurfaceVariant::colors})
        if (fullTests() || has == &SurfaceVariant::transforms) {
            variants.push_back({false, true, false, true, 1, 27});
            variants.back().*has = true;
        }
    variants.push_back({.metallicMaps = true, .colors = true}); // without textures
    variants.push_back(
        {true, true, true, true, 2, 27, true, true, true, true, true, true, true, true});
    return variants;
}

/// Points in full; packed, with all words and with those alone that every point has.
std::vector<PointFormat> pointFormats() {
    Requirements need;
    std::vector<PointFormat> formats = {pointFormatOf(need)};
    need.packedShading = true;
    formats.push_back(pointFormatOf(need));
    need.shadingNormals = need.emission = need.gloss = true;
    formats.push_back(pointFormatOf(need));
    return formats;
}

/// Of packed points those variants that have most: words are read alike whatever else there is.
void addPointPasses(const PointFormat& format, std::vector<ProgramSource>& all) {
    const bool packed = format.packed();
    all.push_back(depthMaskSource(format));
    for (int has = packed ? 3 : 0; has < 4; ++has)
        all.push_back(clearPathsSource(format, (has & 1) != 0, (has & 2) != 0));
    for (int gloss = packed ? 1 : 0; gloss < 2; ++gloss) {
        for (bool scatters : {false, true}) all.push_back(raysSource(format, scatters, gloss));
        for (ViewMode mode : {ViewMode::full, ViewMode::single})
            all.push_back(shadowRaysSource(format, mode, gloss));
        for (int has : packed        ? std::vector{7}
                       : fullTests() ? std::vector{0, 1, 2, 3, 4, 5, 6, 7}
                                     : std::vector{0, 3, 5, 6}) // each pair of them
            for (LightShading light :
                 {LightShading::none, LightShading::traced, LightShading::shadowMap})
                all.push_back(shadeSource(format, (has & 1) != 0, (has & 2) != 0, (has & 4) != 0,
                                          light, gloss));
    }
    std::vector<SurfaceVariant> variants = surfaceVariants();
    if (packed) variants.resize(1);
    for (const SurfaceVariant& surfaces : variants) {
        all.push_back(firstPointsSource(format, surfaces));
        for (bool raster : {false, true}) all.push_back(fetchSource(format, surfaces, raster));
    }
}

void addPathPasses(std::vector<ProgramSource>& all) {
    all.insert(all.end(), {groupHitsSource(), visibilitySource(), resolveSource()});
    for (const PointFormat& format : pointFormats()) addPointPasses(format, all);
    for (const SurfaceVariant& surfaces : surfaceVariants()) {
        all.insert(all.end(), {fetchAtEyeSource(surfaces), directVisibilitySource(surfaces),
                               shadowMapSource(surfaces)});
        for (Search search : {Search::any, Search::paths})
            for (Precision precision : {Precision::exact, Precision::fast})
                all.push_back(
                    traceSource(search, precision, search == Search::any, 13, 24, &surfaces));
        for (ViewMode mode : {ViewMode::full, ViewMode::single})
            all.push_back(rasterFetchSource(mode, surfaces));
    }
}

std::vector<ProgramSource> allPrograms() {
    std::vector<ProgramSource> all = {loopProbeSource(),         transformSource(),
                                      largestCoordinateSource(), scaleTrianglesSource(),
                                      trianglesAtEyeSource(),    fillDepthMipmapSource(),
                                      selfTestRasterSource(),    selfTestComputeSource()};
    for (Search search : {Search::nearest, Search::any, Search::paths})
        for (Precision precision : {Precision::exact, Precision::fast})
            for (int segments : {1, kMostSegments})
                if (fullTests() || (precision == Precision::exact) == (segments == 1))
                    all.push_back(traceSource(search, precision, segments == 1, segments, 24));
    addPathPasses(all);
    for (ViewMode mode : {ViewMode::full, ViewMode::single})
        for (Proposal proposal : {Proposal::rectangles, Proposal::triangles}) {
            all.push_back(fillDepthSource(mode, proposal));
            for (int segments : {1, 2, 7, 8, kMostSegments})
                if (fullTests() || segments == 1 || mode == ViewMode::full)
                    all.push_back(fillPrimitivesSource(mode, proposal, segments, 24));
        }
    return all;
}

TEST(Shaders, CompileInEveryVariant) {
    if (std::system("glslangValidator --version > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "glslang-tools is not installed";
    const TemporaryFolder folder;
    const auto compile = [&](const std::string& arguments, const std::string& what) {
        const std::string log = folder / "log";
        EXPECT_EQ(std::system(("glslangValidator " + arguments + " > " + log).c_str()), 0)
            << what << "\n"
            << readFile(log);
    };
    std::string alone; // programs of one file have nothing to link: many to a process
    int count = 0;
    for (const ProgramSource& program : allPrograms()) {
        const std::string number = std::to_string(count++) + "_";
        std::string files;
        for (const std::string& file : program.files)
            files += " " +
                     folder.write(number + file, ShaderFiles().compose(file, program.defines).text);
        if (program.files.size() > 1)
            compile("-l" + files, program.name); // and link
        else
            alone += files;
    }
    compile(alone, "one file each");
    EXPECT_GT(count, 100);
}

/// Traces without doubles, which many GPUs have at a thirty-second of the rate of floats or less.
TEST(Shaders, FastTracesInFloatAlone) {
    if (std::system("glslangValidator --version > /dev/null 2>&1") != 0)
        GTEST_SKIP() << "glslang-tools is not installed";
    const TemporaryFolder folder;
    const auto doublesOf = [&](const ProgramSource& program) {
        const std::string file = folder.write(
            program.files[0], ShaderFiles().compose(program.files[0], program.defines).text);
        const std::string out = folder / "preprocessed";
        EXPECT_EQ(std::system(("glslangValidator -E " + file + " > " + out).c_str()), 0);
        const std::string text = readFile(out);
        const std::regex doubles("\\b(double|dvec[234]|dmat\\w*|\\w*Double2x32|[0-9.]+(lf|LF))\\b");
        return std::distance(std::sregex_iterator(text.begin(), text.end(), doubles), {});
    };
    SurfaceVariant surfaces;
    surfaces.textures = surfaces.cutOuts = true;
    for (Search search : {Search::nearest, Search::any, Search::paths})
        for (bool resumes : {false, true}) {
            EXPECT_EQ(doublesOf(traceSource(search, Precision::fast, resumes, 2, 24)), 0);
            EXPECT_EQ(doublesOf(traceSource(search, Precision::fast, resumes, 2, 24, &surfaces)),
                      0);
            EXPECT_GT(doublesOf(traceSource(search, Precision::exact, resumes, 2, 24)), 100);
        }
}

/// No file is left over that no program uses.
TEST(Shaders, AreAllUsed) {
    std::vector<std::string> used;
    for (const ProgramSource& program : allPrograms())
        for (const std::string& file : program.files)
            for (const std::string& part : ShaderFiles().compose(file, program.defines).files)
                used.push_back(part);
    for (const std::string& file : ShaderFiles::builtIn()) {
        if (file.starts_with("shared/")) continue;
        EXPECT_NE(std::find(used.begin(), used.end(), file), used.end()) << file;
    }
}

} // namespace
} // namespace dirt::test
