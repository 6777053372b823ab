#include "app/cli/commands.h"
#include "app/cli/input.h"
#include "app/cli/json_report.h"
#include "app/cli/option_values.h"
#include "core/base/error.h"

#ifdef DIRT_HAVE_EMBREE
#include "backend_embree/embree_backend.h"
#include "bench/frame_bench.h"
#endif

#include <cstdio>
#include <memory>
#include <vector>

namespace dirt {

namespace {

struct BenchOptions {
    CommonOptions common;
    std::vector<std::string> scenes;
    int rounds = 9;
    bool json = false;
};

#ifdef DIRT_HAVE_EMBREE

std::array<std::pair<const char*, uint64_t>, 9> namedCounts(const LeafCounts& c) {
    return {{{"steps", c.steps},
             {"tiles", c.tiles},
             {"nodes", c.nodes},
             {"blocks", c.blocks},
             {"triangles", c.triangles},
             {"exact", c.exact},
             {"scalar", c.scalar},
             {"lookups", c.lookups},
             {"listed", c.listed}}};
}

void printFrame(std::FILE* file, const Input& input, const FrameReport& report) {
    std::fprintf(file, "%s, %zu triangles, %llu list entries\n", input.scene.name.c_str(),
                 input.scene.mesh.triangles.size(), (unsigned long long) report.listEntries);
    std::fprintf(file, "  %-8s %26s %26s %7s %10s\n", "", "dirt ms", "embree ms", "ratio",
                 "Mrays/s");
    for (const FramePart part : kFrameParts) {
        const Timing& dirt = report.dirt.parts[(size_t) part];
        const Timing& embree = report.embree.parts[(size_t) part];
        const WorkReport& work = report.work[(size_t) part];
        std::fprintf(file, "  %-8s %9.1f (%6.1f-%6.1f) %9.1f (%6.1f-%6.1f) %7.2f",
                     framePartName(part), dirt.median(), dirt.least(), dirt.most(), embree.median(),
                     embree.least(), embree.most(), dirt.median() / embree.median());
        if (work.rays > 0) std::fprintf(file, " %10.2f", (double) work.rays / dirt.median() * 1e-3);
        std::fprintf(file, "\n");
    }
    const double build = report.dirt.parts[(size_t) FramePart::build].median();
    std::fprintf(file, "  build beside Embree's Morton rebuild of %.1f ms (%.1f-%.1f): %.2f\n",
                 report.mortonBuild.median(), report.mortonBuild.least(), report.mortonBuild.most(),
                 build / report.mortonBuild.median());
    std::fprintf(file, "  build beside its floor, %.1f MB at %.1f GB/s, %.1f ms: %.1f\n",
                 (double) report.floorBytes * 1e-6, report.bytesPerMs * 1e-6, report.floorMs(),
                 build / report.floorMs());
    for (const FramePart part : kFrameParts) {
        const WorkReport& work = report.work[(size_t) part];
        if (work.rays == 0 || work.counts.steps + work.counts.lookups == 0) continue;
        const double rays = (double) work.rays;
        std::fprintf(file, "  %-8s %9llu rays, each:", framePartName(part),
                     (unsigned long long) work.rays);
        for (const auto& [name, count] : namedCounts(work.counts))
            std::fprintf(file, " %.2f %s", (double) count / rays, name);
        std::fprintf(file, "\n");
    }
    std::fprintf(file, "  memory   %9.1f MB %23.1f MB\n", (double) report.dirt.bytes * 1e-6,
                 (double) report.embree.bytes * 1e-6);
    std::fflush(file);
}

Json timesJson(const SideReport& side, double (Timing::*value)() const) {
    Json json = Json::object();
    for (const FramePart part : kFrameParts)
        json[framePartName(part)] = (side.parts[(size_t) part].*value)();
    return json;
}

Json frameJson(const Input& input, const FrameReport& report) {
    Json json;
    json["scene"] = input.scene.name;
    json["triangles"] = input.scene.mesh.triangles.size();
    json["dirt_ms"] = timesJson(report.dirt, &Timing::median);
    json["embree_ms"] = timesJson(report.embree, &Timing::median);
    json["ratio"] = Json::object();
    json["spread"] = {{"dirt_least_ms", timesJson(report.dirt, &Timing::least)},
                      {"dirt_most_ms", timesJson(report.dirt, &Timing::most)},
                      {"embree_least_ms", timesJson(report.embree, &Timing::least)},
                      {"embree_most_ms", timesJson(report.embree, &Timing::most)}};
    json["memory"] = {{"dirt_ads", report.dirt.bytes}, {"embree_bvh", report.embree.bytes}};
    const Timing& morton = report.mortonBuild;
    json["embree_morton"] = {{"build_ms", morton.median()},
                             {"build_least_ms", morton.least()},
                             {"build_most_ms", morton.most()},
                             {"build_ratio", report.dirt.parts[0].median() / morton.median()}};
    json["build_floor"] = {{"bytes", report.floorBytes},
                           {"bandwidth_gb_s", report.bytesPerMs * 1e-6},
                           {"ms", report.floorMs()}};
    json["list_entries"] = report.listEntries;
    for (const FramePart part : kFrameParts) {
        const size_t p = (size_t) part;
        json["ratio"][framePartName(part)] =
            report.dirt.parts[p].median() / report.embree.parts[p].median();
        const WorkReport& work = report.work[p];
        if (work.rays == 0) continue;
        Json& counts = json["work"][framePartName(part)];
        counts["rays"] = work.rays;
        for (const auto& [name, count] : namedCounts(work.counts)) counts[name] = count;
    }
    return json;
}

/// The peer is Embree alone, without core's exact test in its filter: what its users get.
void runFrame(const BenchOptions& options) {
    const auto executor = makeExecutor(options.common);
    std::FILE* const table = options.json ? stderr : stdout;
    Json scenes = Json::array();
    for (const std::string& scene : options.scenes) {
        CommonOptions common = options.common;
        common.scene = scene;
        const Input input = openInput(common, *executor);
        const auto dirt = makeBackend(common, *executor);
        EmbreeBackend embree(*executor, false, EmbreeDecision::plain);
        EmbreeBackend morton(*executor, false, EmbreeDecision::plain, EmbreeQuality::low);
        const FrameReport report = benchFrame(input.scene, input.settings, *dirt, embree, morton,
                                              *executor, options.rounds);
        if (!options.json || !common.quiet) printFrame(table, input, report);
        scenes.push_back(frameJson(input, report));
    }
    if (!options.json) return;
    Json report;
    report["threads"] = executor->threads();
    report["rounds"] = options.rounds;
    report["scenes"] = std::move(scenes);
    std::printf("%s\n", report.dump(2).c_str());
}

#else

void runFrame(const BenchOptions&) {
    throw CapabilityError("bench compares with Embree, and this build is without it");
}

#endif

} // namespace

void addBench(Command program, int& status) {
    const Command command = program.addCommand("bench", "measures speed and memory");
    command.requireCommand();
    const Command frame = command.addCommand("frame", "each part of a frame beside Embree's time");
    const auto options = std::make_shared<BenchOptions>();
    frame.addTexts("SCENE", options->scenes, ".scene or .obj files").required();
    addSettingsOptions(frame, options->common);
    addInteger(frame, "--rounds", 1, 1000, "measured, after one that is not (default: 9)",
               [options](int64_t n) { options->rounds = (int) n; });
    frame.addFlag("--json", options->json, "print one JSON object on standard output");
    frame.onRun([options, &status] {
        runFrame(*options);
        status = 0;
    });
    addBenchTradeoff(command, status);
    addBenchScaling(command, status);
}

} // namespace dirt
