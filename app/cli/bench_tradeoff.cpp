#include "app/cli/commands.h"
#include "app/cli/input.h"
#include "app/cli/json_report.h"
#include "app/cli/log.h"
#include "app/cli/option_values.h"
#include "core/base/error.h"
#include "core/io/input_files.h"
#include "core/io/output_file.h"

#ifdef DIRT_HAVE_EMBREE
#include "app/cli/tradeoff_errors.h"
#include "app/cli/tradeoff_pictures.h"
#include "backend_embree/embree_backend.h"
#include "bench/tradeoff_bench.h"
#endif

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <sstream>

namespace dirt {

namespace {

struct TradeoffCommand {
    CommonOptions common;
    std::string directory;
    std::string references; ///< folder; empty: none are kept
    std::string errors;     ///< file; empty: errors are taken
    int rounds = 9, samples = 64, referenceSamples = 1024;
    bool json = false;
};

#ifdef DIRT_HAVE_EMBREE

/// One row for each point of each sweep.
Json pointsJson(const TradeoffReport& report) {
    Json rows = Json::array();
    for (const Sweep& sweep : report.sweeps.sweeps)
        for (const auto& [value, index] : sweep.points) {
            const SettingsReport& cost = report.settings[index];
            Json row;
            row["sweep"] = sweep.name;
            row["value"] = value;
            row["settings"] = index;
            row["build_ms"] = cost.build.median();
            row["build_least_ms"] = cost.build.least();
            row["build_most_ms"] = cost.build.most();
            row["sample_ms"] = cost.sample.median();
            row["sample_least_ms"] = cost.sample.least();
            row["sample_most_ms"] = cost.sample.most();
            row["frame_ms"] = cost.build.median() + cost.sample.median();
            row["memory"] = cost.bytes;
            row["list_entries"] = cost.listEntries;
            row["same_image_as"] = cost.image;
            rows.push_back(std::move(row));
        }
    return rows;
}

Json errorsJson(const TradeoffReport& report) {
    Json rows = Json::array();
    for (size_t i = 0; i < report.settings.size(); ++i)
        for (const ErrorAt& error : report.settings[i].errors) {
            const SettingsReport& cost = report.settings[i];
            rows.push_back({{"settings", i},
                            {"samples", error.samples},
                            {"ms", cost.build.median() + error.samples * cost.sample.median()},
                            {"relative_mse", error.relativeMse},
                            {"flip", error.flip}});
        }
    return rows;
}

/// The rows of \p json, objects with the same keys.
std::string csvOf(const Json& json) {
    std::ostringstream csv;
    for (const Json& row : json) {
        const char* separator = "";
        if (&row == &json.front()) {
            for (const auto& item : row.items()) {
                csv << separator << item.key();
                separator = ",";
            }
            csv << "\n";
            separator = "";
        }
        for (const auto& item : row.items()) {
            csv << separator;
            if (item.value().is_string())
                csv << item.value().get<std::string>();
            else
                csv << item.value();
            separator = ",";
        }
        csv << "\n";
    }
    return csv.str();
}

/// What the run is about, which decides all its images.
Json headJson(const Input& input) {
    const RenderSettings& around = input.settings;
    const Camera& camera = input.scene.camera;
    const auto list = [](glm::dvec3 v) { return Json{v.x, v.y, v.z}; };
    Json json;
    json["scene"] = input.scene.name;
    json["triangles"] = input.scene.mesh.triangles.size();
    json["camera"] = {{"eye", list(input.scene.inFiles(camera.eye))},
                      {"target", list(input.scene.inFiles(camera.target))},
                      {"up", list(camera.up)},
                      {"fov", camera.verticalFov}};
    json["size"] = {around.grid.width, around.grid.height};
    json["tile"] = around.grid.tile;
    json["bins"] = around.grid.bins;
    json["bounces"] = around.bounces;
    json["seed"] = around.seed;
    return json;
}

void printTable(std::FILE* file, const TradeoffReport& report) {
    for (const Sweep& sweep : report.sweeps.sweeps) {
        std::fprintf(file, "%-14s %10s %10s %10s %12s  %s\n", sweep.name.c_str(), "build ms",
                     "sample ms", "memory MB", "entries", "image");
        for (const auto& [value, index] : sweep.points) {
            const SettingsReport& cost = report.settings[index];
            std::fprintf(file, "  %-12s %10.1f %10.1f %10.1f %12llu  ", value.c_str(),
                         cost.build.median(), cost.sample.median(), (double) cost.bytes * 1e-6,
                         (unsigned long long) cost.listEntries);
            const SettingsReport& image = report.settings[cost.image];
            if (cost.image == 0)
                std::fprintf(file, "the same\n");
            else
                std::fprintf(file, "relative MSE %.4g, FLIP %.4g at %d spp\n",
                             image.errors.back().relativeMse, image.errors.back().flip,
                             image.errors.back().samples);
        }
    }
    std::fflush(file);
}

/// Throws InputError where the folder cannot be written to, or one of its files whose names begin
/// so, as the pictures and tables to come do, cannot be replaced.
void checkFolder(const std::string& folder, const std::string& prefix) {
    checkWritable((std::filesystem::path(folder) / (prefix + "tradeoff.json")).string());
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().filename().string().starts_with(prefix))
            checkWritable(entry.path().string());
}

void runTradeoff(const TradeoffCommand& command) {
    const auto executor = makeExecutor(command.common);
    const Input input = openInput(command.common, *executor);
    std::filesystem::create_directories(command.directory);
    const std::string stem = (std::filesystem::path(command.directory) / input.scene.name).string();
    if (!command.errors.empty()) noteInput(command.errors);
    checkFolder(command.directory, input.scene.name + "-");
    Json json = headJson(input);
    TradeoffOptions options;
    options.rounds = command.rounds;
    options.samples = command.samples;
    options.referenceSamples = command.referenceSamples;
    if (!command.references.empty()) options.reference = KeptReferences(command.references, input);
    if (!command.errors.empty()) {
        const KnownErrors known(command.errors, json, makeSweeps(input.settings));
        options.referenceSamples = known.referenceSamples();
        options.knownErrors = [known](size_t settings) { return known.of(settings); };
    }
    if (!command.common.quiet)
        options.progress = [](const std::string& line) {
            std::fprintf(stderr, "%s\n", line.c_str());
        };
    const auto make = [&] { return makeBackend(command.common, *executor); };
    EmbreeBackend peer(*executor);
    const TradeoffReport report =
        benchTradeoff(input.scene, input.settings, make, peer, *executor, options);

    json["threads"] = executor->threads();
    json["rounds"] = options.rounds;
    json["reference_spp"] = options.referenceSamples;
    json["points"] = pointsJson(report);
    json["errors"] = errorsJson(report);
    for (const auto& [end, text] : {std::pair("-tradeoff.json", json.dump(2) + "\n"),
                                    {"-tradeoff.csv", csvOf(json["points"])},
                                    {"-errors.csv", csvOf(json["errors"])}}) {
        writeFile(stem + end, text);
        logWritten(stem + end);
    }
    writePictures(stem, report, DisplayEncoding(input.scene.toneMapping));
    if (command.json)
        std::printf("%s\n", json.dump(2).c_str());
    else
        printTable(stdout, report);
}

#else

void runTradeoff(const TradeoffCommand&) {
    throw CapabilityError("bench compares with Embree, and this build is without it");
}

#endif

} // namespace

void addBenchTradeoff(Command bench, int& status) {
    const Command command =
        bench.addCommand("tradeoff", "time, memory and error against each choice");
    const auto options = std::make_shared<TradeoffCommand>();
    addCommonOptions(command, options->common);
    command.addText("-o", options->directory, "folder for tables, plots and pictures")
        .typeName("DIR")
        .required();
    addInteger(command, "--rounds", 1, 1000, "measured, after one that is not (default: 9)",
               [options](int64_t n) { options->rounds = (int) n; });
    const Option samples = addInteger(command, "--error-spp", 1, 1 << 20,
                                      "samples of the images whose error is taken (default: 64)",
                                      [options](int64_t n) { options->samples = (int) n; });
    const Option referenceSamples = addInteger(
        command, "--reference-spp", 1, 1 << 20, "samples of the reference (default: 1024)",
        [options](int64_t n) { options->referenceSamples = (int) n; });
    const Option references = command
                                  .addText("--references", options->references,
                                           "folder that has the references, or is to keep them")
                                  .typeName("DIR");
    command.addText("--errors", options->errors, "take the errors from the JSON of an earlier run")
        .typeName("FILE")
        .excludes({samples, referenceSamples, references});
    command.addFlag("--json", options->json, "print one JSON object on standard output");
    command.onRun([options, &status] {
        runTradeoff(*options);
        status = 0;
    });
}

} // namespace dirt
