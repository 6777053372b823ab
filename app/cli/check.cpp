#include "core/check/check.h"
#include "app/cli/commands.h"
#include "app/cli/input.h"
#include "app/cli/json_report.h"
#include "app/cli/structure_options.h"
#include "core/io/error.h"

#include <algorithm>
#include <cstdio>
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
    throw InputError("--backends: '" + name + "' is none of cpu, gl");
}

/// Lists are the one buffer whose entries are missing or too many, rather than wrong in value.
uint64_t wrongEntries(const std::vector<CheckRow>& rows) {
    uint64_t wrong = 0;
    for (const CheckRow& row : rows)
        if (row.buffer == "lists") wrong += row.different;
    return wrong;
}

bool allowed(const std::vector<CheckRow>& rows) {
    return std::all_of(rows.begin(), rows.end(),
                       [](const CheckRow& row) { return row.different == 0; });
}

void printRows(std::FILE* file, const std::vector<CheckRow>& rows) {
    std::fprintf(file, "%-16s %-24s %-13s %10s %10s %10s %10s\n", "pass", "buffer", "", "compared",
                 "equal", "tolerated", "different");
    for (const CheckRow& row : rows)
        std::fprintf(file, "%-16s %-24s %-13s %10llu %10llu %10llu %10llu\n", row.pass.c_str(),
                     row.buffer.c_str(), (row.tested + " on " + row.source).c_str(),
                     (unsigned long long) row.compared, (unsigned long long) row.equal,
                     (unsigned long long) row.withinTolerance, (unsigned long long) row.different);
    std::fprintf(file, "%llu wrong list entries\n", (unsigned long long) wrongEntries(rows));
}

void printExamples(std::FILE* file, const std::vector<CheckRow>& rows, const std::string& command) {
    for (const CheckRow& row : rows)
        for (const std::string& example : row.examples)
            std::fprintf(file, "%s, %s, %s on the data of %s: %s\n", row.pass.c_str(),
                         row.buffer.c_str(), row.tested.c_str(), row.source.c_str(),
                         example.c_str());
    if (!allowed(rows)) std::fprintf(file, "again: %s\n", command.c_str());
}

Json rowJson(const CheckRow& row) {
    return {{"pass", row.pass},
            {"buffer", row.buffer},
            {"backend", row.tested},
            {"data_of", row.source},
            {"compared", row.compared},
            {"equal", row.equal},
            {"within_tolerance", row.withinTolerance},
            {"different", row.different},
            {"examples", row.examples}};
}

/// Whether nothing differs that must not.
bool runCheck(const CheckOptions& options) {
    if (options.backends.size() != 2) throw InputError("--backends: two of cpu, gl, as in cpu,gl");
    const auto executor = makeExecutor(options.common);
    const auto first = makeBackend(kindOf(options.backends[0]), options.common, *executor);
    const auto second = makeBackend(kindOf(options.backends[1]), options.common, *executor);
    const Input input = openInput(options.common, *executor);
    const auto rows = checkConstruction(input.scene.mesh, input.scene.camera, input.settings.grid,
                                        *first, *second);

    std::FILE* const table = options.json ? stderr : stdout;
    if (!options.json || !options.common.quiet) printRows(table, rows);
    printExamples(stderr, rows,
                  "dirt check " + options.common.scene + " --backends " + options.backends[0] +
                      "," + options.backends[1] + structureOptions(input));
    if (options.json) {
        Json report = reportOf(input, *second, *executor, {});
        report["backends"] = options.backends;
        report["rows"] = Json::array();
        for (const CheckRow& row : rows) report["rows"].push_back(rowJson(row));
        report["wrong_entries"] = wrongEntries(rows);
        std::printf("%s\n", report.dump(2).c_str());
    }
    return allowed(rows);
}

} // namespace

void addCheck(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "check", "builds the structure on two backends and compares each of its buffers");
    const auto options = std::make_shared<CheckOptions>();
    addCommonOptions(*command, options->common);
    command->add_option("--backends", options->backends, "two of cpu, gl (default: cpu,gl)")
        ->delimiter(',');
    command->add_flag("--json", options->json, "print one JSON object on standard output");
    command->callback([options, &status] { status = runCheck(*options) ? 0 : 1; });
}

} // namespace dirt
