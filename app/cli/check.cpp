#include "core/check/check.h"
#include "app/cli/again.h"
#include "app/cli/commands.h"
#include "app/cli/input.h"
#include "app/cli/json_report.h"
#include "app/cli/log.h"
#include "core/base/error.h"

#include <algorithm>
#include <cstdio>
#include <initializer_list>
#include <memory>
#include <vector>

namespace dirt {

namespace {

struct CheckOptions {
    CommonOptions common;
    std::vector<std::string> backends{"cpu", "gl"};
    bool json = false;
};

BackendKind kindOf(const std::string& name) {
    if (name == "cpu") return BackendKind::cpu;
    if (name == "gl") return BackendKind::gl;
    if (name == "embree") return BackendKind::embree;
    throw InputError("--backends: '" + name + "' is none of cpu, gl, embree");
}

/// Lists are the one buffer whose entries are missing or too many, rather than wrong in value. Each
/// counts once, though both directions see it.
uint64_t wrongEntries(const std::vector<CheckRow>& rows) {
    uint64_t wrong = 0;
    for (const CheckRow& row : rows)
        if (row.buffer == "lists") wrong = std::max(wrong, row.different);
    return wrong;
}

/// "Trace 1", or only the name where there is no path event.
std::string passName(const CheckRow& row) {
    return row.event < 0 ? row.pass : row.pass + " " + std::to_string(row.event);
}

void printRows(std::FILE* file, const CheckReport& report, const CheckOptions& options) {
    std::fprintf(file, "%-18s %-24s %-15s %10s %10s %10s %10s\n", "pass", "buffer", "", "compared",
                 "equal", "tolerated", "different");
    for (const CheckRow& row : report.rows)
        std::fprintf(file, "%-18s %-24s %-15s %10llu %10llu %10llu %10llu\n", passName(row).c_str(),
                     row.buffer.c_str(), (row.tested + " on " + row.source).c_str(),
                     (unsigned long long) row.compared, (unsigned long long) row.equal,
                     (unsigned long long) row.withinTolerance, (unsigned long long) row.different);
    std::fprintf(file, "%llu wrong list entries\n", (unsigned long long) wrongEntries(report.rows));
    for (size_t i = 0; i < 2; ++i)
        std::fprintf(file, "image mean of %-6s %.9g %.9g %.9g\n", options.backends[i].c_str(),
                     report.means[i].x, report.means[i].y, report.means[i].z);
    std::fflush(file); // what follows on standard error comes last where both are one
}

/// All that shapes the passes, said or not.
std::string checkCommand(const CheckOptions& options, const CommonOptions& common,
                         const Input& input) {
    return commandStart("check", options.common.scene) + " --backends " + options.backends[0] +
           "," + options.backends[1] + structureOptions(input, common) + pathOptions(input, common);
}

/// What shows \p place of a row in the backend that ran the pass; empty where nothing does.
std::string commandFor(const CheckRow& row, const CheckOptions& options, CommonOptions common,
                       const Input& input) {
    const Place& place = row.first;
    common.backends.clear();
    common.backend = kindOf(row.tested);
    const auto numbers = [](std::initializer_list<int> list) {
        std::string text;
        for (const int n : list) text += (text.empty() ? " " : ",") + std::to_string(n);
        return text;
    };
    std::string command = "explain", subject;
    switch (place.kind) {
    case Place::Kind::none:
        return "";
    case Place::Kind::primitive:
        subject = " --primitive " + std::to_string(place.id);
        break;
    case Place::Kind::tile:
        subject = " --tile" + numbers({place.view, place.x, place.y});
        break;
    case Place::Kind::pixel:
        subject = " --pixel" + numbers({place.x, place.y});
        if (row.event >= 0) subject += " --event " + std::to_string(row.event);
        break;
    case Place::Kind::texel:
        command = "preview";
        subject = " --show shadowmap -o shadowmap.png";
        break;
    }
    const bool needsPaths = place.kind == Place::Kind::pixel || place.kind == Place::Kind::texel;
    return commandStart(command, options.common.scene) + subject + " --backend " +
           nameOf(common.backend) + structureOptions(input, common) +
           (needsPaths ? pathOptions(input, common) : "");
}

/// The first differences, the command that finds them again, and last the one that shows the first.
void printExamples(std::FILE* file, const CheckReport& report, const CheckOptions& options,
                   const CommonOptions& common, const Input& input) {
    if (report.passed()) return;
    for (const CheckRow& row : report.rows)
        for (const std::string& example : row.examples)
            std::fprintf(file, "%s, %s, %s on the data of %s: %s\n", passName(row).c_str(),
                         row.buffer.c_str(), row.tested.c_str(), row.source.c_str(),
                         example.c_str());
    std::fprintf(file, "again: %s\n", checkCommand(options, common, input).c_str());
    const auto first = std::find_if(report.rows.begin(), report.rows.end(),
                                    [](const CheckRow& row) { return row.different > 0; });
    if (first == report.rows.end()) return; // the means alone
    const std::string command = commandFor(*first, options, common, input);
    if (!command.empty()) std::fprintf(file, "look: %s\n", command.c_str());
}

Json rowJson(const CheckRow& row) {
    return {
        {"pass", row.pass},           {"event", row.event < 0 ? Json(nullptr) : Json(row.event)},
        {"buffer", row.buffer},       {"backend", row.tested},
        {"data_of", row.source},      {"compared", row.compared},
        {"equal", row.equal},         {"within_tolerance", row.withinTolerance},
        {"different", row.different}, {"examples", row.examples}};
}

Json meanJson(glm::dvec3 mean) {
    return {mean.x, mean.y, mean.z};
}

/// Whether nothing differs that must not.
bool runCheck(const CheckOptions& options) {
    if (options.backends.size() != 2)
        throw InputError("--backends: two of cpu, gl, embree, as in cpu,gl");
    if (options.common.precision == Precision::fast)
        throw InputError("check: --precision fast promises nothing that two backends could be "
                         "compared by (dirt verify measures what it misses)");
    if (options.backends[0] == options.backends[1])
        sayWarning("--backends " + options.backends[0] + "," + options.backends[1] +
                       ": a backend is compared with itself",
                   options.common.quiet);
    CommonOptions common = options.common;
    for (const std::string& name : options.backends) common.backends.push_back(kindOf(name));
    const auto executor = makeExecutor(common);
    const auto first = makeBackend(common.backends[0], common, *executor);
    const auto second = makeBackend(common.backends[1], common, *executor);
    const Input input = openInput(common, *executor);
    const CheckReport report = checkBackends(input.scene, input.settings, *first, *second);

    std::FILE* const table = options.json ? stderr : stdout;
    if (!options.json || !options.common.quiet) printRows(table, report, options);
    printExamples(stderr, report, options, common, input);
    if (options.json) {
        Json json = reportOf(input, *second, *executor, {});
        json.erase("spp");
        json["backends"] = options.backends;
        json["rows"] = Json::array();
        for (const CheckRow& row : report.rows) json["rows"].push_back(rowJson(row));
        json["wrong_entries"] = wrongEntries(report.rows);
        json["image_means"] = {meanJson(report.means[0]), meanJson(report.means[1])};
        std::printf("%s\n", json.dump(2).c_str());
    }
    return report.passed();
}

} // namespace

void addCheck(Command program, int& status) {
    const Command command = program.addCommand(
        "check", "runs every pass on two backends, from the same buffers, and compares them");
    const auto options = std::make_shared<CheckOptions>();
    addCommonOptions(command, options->common);
    command.addTexts("--backends", options->backends, "two of cpu, gl, embree (default: cpu,gl)")
        .commaSeparated();
    command.addFlag("--json", options->json, "print one JSON object on standard output");
    command.onRun([options, &status] { status = runCheck(*options) ? 0 : 1; });
}

} // namespace dirt
