#include "app/cli/commands.h"
#include "app/cli/input.h"
#include "app/cli/json_report.h"
#include "app/cli/log.h"
#include "app/cli/option_values.h"
#include "core/base/error.h"
#include "core/io/input_files.h"
#include "core/io/output_file.h"

#ifdef DIRT_HAVE_EMBREE
#include "backend_embree/embree_backend.h"
#include "bench/plot.h"
#include "bench/scaling_bench.h"
#include "scenes/generate/generate.h"
#endif

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>

namespace dirt {

namespace {

struct ScalingCommand {
    CommonOptions common;
    std::string directory;
    int rounds = 9;
    int64_t mostTriangles = 10'000'000;
    bool json = false;
};

#ifdef DIRT_HAVE_EMBREE

/// A new sub-folder of the output folder, removed in the end, for scenes that serve only to be
/// timed.
class Workshop {
public:
    explicit Workshop(const std::filesystem::path& directory) {
        std::string name = (directory / "scenes-XXXXXX").string();
        if (!mkdtemp(name.data()))
            throw InputError(name + ": cannot make this folder: " + std::strerror(errno));
        path_ = name;
    }
    ~Workshop() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

Json jsonOf(const ScalingPoint& point) {
    return {{"triangles", point.triangles},
            {"size", {point.width, point.height}},
            {"build_ms", point.build.median()},
            {"build_least_ms", point.build.least()},
            {"build_most_ms", point.build.most()},
            {"sample_ms", point.sample.median()},
            {"embree_build_ms", point.peerBuild.median()},
            {"embree_sample_ms", point.peerSample.median()},
            {"memory", point.bytes}};
}

void print(std::FILE* file, const ScalingPoint& point) {
    std::fprintf(file, "%10llu %5dx%-5d %9.1f %9.1f %9.1f %9.1f %9.1f MB\n",
                 (unsigned long long) point.triangles, point.width, point.height,
                 point.build.median(), point.sample.median(), point.peerBuild.median(),
                 point.peerSample.median(), (double) point.bytes * 1e-6);
    std::fflush(file);
}

using PlotValue = double (*)(const ScalingPoint&);

void plot(const std::string& file, const std::string& title, const std::string& xLabel, PlotValue x,
          const std::vector<ScalingPoint>& points) {
    const std::pair<const char*, PlotValue> values[] = {
        {"build", [](const ScalingPoint& p) { return p.build.median(); }},
        {"sample", [](const ScalingPoint& p) { return p.sample.median(); }},
        {"Embree build", [](const ScalingPoint& p) { return p.peerBuild.median(); }},
        {"Embree sample", [](const ScalingPoint& p) { return p.peerSample.median(); }}};
    Plot result{title, xLabel, "ms", {}};
    for (const auto& [name, y] : values) {
        PlotSeries series{name, {}};
        for (const ScalingPoint& point : points) series.points.emplace_back(x(point), y(point));
        result.series.push_back(std::move(series));
    }
    writeFile(file, svgOf(result));
    logWritten(file);
}

/// The exponents of build times over triangles, from 10^5 on: below, a frame's fixed costs rule.
std::pair<double, double> exponents(const std::vector<ScalingPoint>& points) {
    std::vector<double> triangles, ours, theirs;
    for (const ScalingPoint& point : points) {
        if (point.triangles < 90'000) continue;
        triangles.push_back((double) point.triangles);
        ours.push_back(point.build.median());
        theirs.push_back(point.peerBuild.median());
    }
    if (triangles.size() < 2) return {NAN, NAN};
    return {fittedExponent(triangles, ours), fittedExponent(triangles, theirs)};
}

void runScaling(const ScalingCommand& command) {
    const std::filesystem::path directory = command.directory;
    std::filesystem::create_directories(directory);
    checkWritable((directory / "scaling.json").string());
    const auto executor = makeExecutor(command.common);
    const auto backend = makeBackend(command.common, *executor);
    EmbreeBackend peer(*executor, false, EmbreeDecision::plain);
    std::FILE* const table = command.json ? stderr : stdout;
    std::fprintf(table, "%10s %11s %9s %9s %9s %9s\n", "triangles", "size", "build", "sample",
                 "E. build", "E. sample");

    const Workshop workshop(directory);
    const auto measure = [&](double detail, const std::vector<ImageSize>& sizes) {
        const InputFiles ofThisScene; // the next one takes its place
        generateScene("atrium", detail, workshop.path());
        CommonOptions common = command.common;
        common.scene = (workshop.path() / "atrium.scene").string();
        Input input = openInput(common, *executor);
        std::vector<ScalingPoint> points;
        for (const ImageSize size : sizes) {
            if (size.width > 0) {
                input.settings.grid.width = size.width;
                input.settings.grid.height = size.height;
            }
            points.push_back(
                benchScaling(input.scene, input.settings, *backend, peer, command.rounds));
            print(table, points.back());
        }
        return points;
    };

    std::vector<ScalingPoint> byTriangles;
    for (const double detail : {1e4, 3e4, 1e5, 3e5, 1e6, 3e6, 1e7})
        if (detail <= (double) command.mostTriangles)
            byTriangles.push_back(measure(detail, {ImageSize{}}).front());
    const std::vector<ScalingPoint> bySize =
        measure(std::min(250e3, (double) command.mostTriangles),
                {{256, 128}, {512, 256}, {1024, 512}, {2048, 1024}, {3840, 2160}});

    const auto [ours, theirs] = exponents(byTriangles);
    Json json;
    json["threads"] = executor->threads();
    json["rounds"] = command.rounds;
    for (const ScalingPoint& point : byTriangles) json["triangles"].push_back(jsonOf(point));
    for (const ScalingPoint& point : bySize) json["sizes"].push_back(jsonOf(point));
    json["build_exponent"] = ours;
    json["embree_build_exponent"] = theirs;
    const std::string file = (directory / "scaling.json").string();
    writeFile(file, json.dump(2) + "\n");
    logWritten(file);
    plot((directory / "scaling-triangles.svg").string(), "Time against triangles", "triangles",
         [](const ScalingPoint& p) { return (double) p.triangles; }, byTriangles);
    plot((directory / "scaling-size.svg").string(), "Time against pixels", "pixels",
         [](const ScalingPoint& p) { return (double) p.width * p.height; }, bySize);
    if (command.json)
        std::printf("%s\n", json.dump(2).c_str());
    else
        std::printf("build ~ triangles^%.3f from 100,000 on (Embree: %.3f)\n", ours, theirs);
}

#else

void runScaling(const ScalingCommand&) {
    throw CapabilityError("bench compares with Embree, and this build is without it");
}

#endif

} // namespace

void addBenchScaling(Command bench, int& status) {
    const Command command =
        bench.addCommand("scaling", "time against triangles and resolution, on the atrium");
    const auto options = std::make_shared<ScalingCommand>();
    addSettingsOptions(command, options->common);
    command.addText("-o", options->directory, "folder for tables and plots")
        .typeName("DIR")
        .required();
    addInteger(command, "--rounds", 1, 1000, "measured, after one that is not (default: 9)",
               [options](int64_t n) { options->rounds = (int) n; });
    addInteger(command, "--most", 10'000, 10'000'000,
               "triangles of the largest scene (default: 10000000)",
               [options](int64_t n) { options->mostTriangles = n; });
    command.addFlag("--json", options->json, "print one JSON object on standard output");
    command.onRun([options, &status] {
        runScaling(*options);
        status = 0;
    });
}

} // namespace dirt
