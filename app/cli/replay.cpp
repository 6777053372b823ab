#include "core/replay/replay.h"
#include "app/cli/commands.h"
#include "app/cli/input.h"
#include "app/cli/json_report.h"
#include "app/cli/log.h"
#include "app/cli/option_values.h"
#include "core/replay/against.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

namespace dirt {

namespace {

struct ReplayOptions {
    CommonOptions common; ///< of which replay honours a few
    std::string folder;
    std::optional<BackendKind> against;
    bool json = false;
};

/// What a backend has beside the dump.
struct Opponent {
    std::string name;
    std::vector<CheckRow> rows;
};

std::string faultsText(const JudgedPass& pass) {
    std::string text;
    for (const auto& [sort, count] : pass.faults) text += "  " + std::to_string(count) + " " + sort;
    if (pass.outside > 0) text += "  " + std::to_string(pass.outside) + " beyond the view";
    return text;
}

void printPasses(std::FILE* file, const std::vector<JudgedPass>& passes) {
    std::fprintf(file, "%-18s %-22s %10s %10s %10s %10s\n", "pass", "buffer", "compared", "right",
                 "wrong", "inherited");
    for (const JudgedPass& pass : passes)
        std::fprintf(file, "%-18s %-22s %10llu %10llu %10llu %10llu%s\n", pass.name().c_str(),
                     pass.buffer.c_str(), (unsigned long long) pass.compared,
                     (unsigned long long) pass.right, (unsigned long long) pass.wrong(),
                     (unsigned long long) pass.inherited, faultsText(pass).c_str());
    for (const JudgedPass& pass : passes)
        if (pass.wrong() > 0)
            std::fprintf(file, "%s, %s: %s\n", pass.name().c_str(), pass.buffer.c_str(),
                         pass.first.c_str());
}

std::string rowName(const CheckRow& row) {
    return row.event < 0 ? row.pass : row.pass + " " + std::to_string(row.event);
}

void printOpponent(std::FILE* file, const Opponent& opponent) {
    std::fprintf(file, "%-18s %-22s %10s %10s %10s %10s\n", ("beside " + opponent.name).c_str(), "",
                 "compared", "equal", "tolerated", "different");
    for (const CheckRow& row : opponent.rows)
        std::fprintf(file, "%-18s %-22s %10llu %10llu %10llu %10llu\n", rowName(row).c_str(),
                     row.buffer.c_str(), (unsigned long long) row.compared,
                     (unsigned long long) row.equal, (unsigned long long) row.withinTolerance,
                     (unsigned long long) row.different);
    for (const CheckRow& row : opponent.rows)
        for (const std::string& example : row.examples)
            std::fprintf(file, "%s, %s: %s\n", rowName(row).c_str(), row.buffer.c_str(),
                         example.c_str());
}

Json eventNumber(int event) {
    return event < 0 ? Json(nullptr) : Json(event);
}

/// With the place of the first fault, as far as it has one.
Json passJson(const ReplayInput& input, const JudgedPass& pass) {
    Json json = {{"pass", pass.pass},           {"event", eventNumber(pass.event)},
                 {"buffer", pass.buffer},       {"compared", pass.compared},
                 {"right", pass.right},         {"wrong", pass.wrong()},
                 {"inherited", pass.inherited}, {"outside", pass.outside},
                 {"faults", Json::object()},    {"max_t_error_ulp", pass.largestTError}};
    for (const auto& [sort, count] : pass.faults) json["faults"][sort] = count;
    if (pass.wrong() == 0) return json;
    const ReplayPlace& at = pass.place;
    Json& first = json["first"] = {{"text", pass.first}};
    if (at.view) {
        first["view"] = input.manifest.viewNames[*at.view];
        first["level"] = at.level.value_or(0);
        const auto columns =
            (uint32_t) input.grid->pyramids[*at.view].levels[at.level.value_or(0)].columns;
        first["tile"] = {*at.tile % columns, *at.tile / columns};
    }
    if (at.bin) first["bin"] = *at.bin;
    if (at.primitive && *at.primitive != kNoPrimitive) first["primitive"] = *at.primitive;
    if (at.pixel) {
        const auto width = (uint32_t) input.manifest.settings.width;
        first["pixel"] = {*at.pixel % width, *at.pixel / width};
    }
    return json;
}

Json opponentJson(const Opponent& opponent) {
    Json rows = Json::array();
    for (const CheckRow& row : opponent.rows)
        rows.push_back({{"pass", row.pass},
                        {"event", eventNumber(row.event)},
                        {"buffer", row.buffer},
                        {"compared", row.compared},
                        {"equal", row.equal},
                        {"within_tolerance", row.withinTolerance},
                        {"different", row.different},
                        {"examples", row.examples}});
    return {{"backend", opponent.name}, {"rows", rows}};
}

Json replayReport(const ReplayOptions& options, const ReplayInput& input,
                  const std::vector<JudgedPass>& passes, const std::optional<Opponent>& opponent) {
    const GridSettings& settings = input.manifest.settings;
    Json json = {{"dump", options.folder},
                 {"triangles", input.geometry.triangles.size()},
                 {"view", settings.mode == ViewMode::full ? "full" : "single"},
                 {"tile", settings.tile},
                 {"bins", settings.bins},
                 {"size", {settings.width, settings.height}},
                 {"list_entries", input.entries.size()},
                 {"passes", Json::array()}};
    for (const JudgedPass& pass : passes) json["passes"].push_back(passJson(input, pass));
    const JudgedPass* wrong = firstWrong(passes);
    json["first_wrong"] = wrong ? Json(wrong->name()) : Json(nullptr);
    json["verdict"] = verdictText(passes);
    json["ignored"] = input.ignored;
    if (opponent) json["against"] = opponentJson(*opponent);
    return json;
}

/// Whether all is right.
bool runReplay(const ReplayOptions& options) {
    const auto executor = makeExecutor(options.common);
    std::unique_ptr<Backend> backend;
    if (options.against) backend = makeBackend(*options.against, options.common, *executor);
    const ReplayInput input = readReplay(options.folder);
    const bool quiet = options.common.quiet;
    for (const std::string& text : input.ignored) sayWarning(text + ": has no effect", quiet);
    if (input.manifest.cutOuts && !(input.events.empty() && input.shadows.empty()))
        sayWarning("the scene has cut-outs or surfaces of one side, which no dump holds: hits and "
                   "shadow rays are not judged",
                   quiet);
    const std::vector<JudgedPass> passes = judgeDump(input, *executor);
    std::optional<Opponent> opponent;
    if (backend) opponent = Opponent{backend->name(), replayAgainst(input, *backend)};

    std::FILE* const table = options.json ? stderr : stdout;
    if (!options.json || !quiet) {
        printPasses(table, passes);
        if (opponent) printOpponent(table, *opponent);
        std::fprintf(table, "%s\n", verdictText(passes).c_str());
    }
    if (options.json)
        std::printf("%s\n", replayReport(options, input, passes, opponent).dump(2).c_str());
    return isRight(passes);
}

} // namespace

void addReplay(Command program, int& status) {
    const Command command = program.addCommand(
        "replay", "judges the buffers of a dump, of dirt or of another engine, and says which pass "
                  "went wrong first");
    const auto options = std::make_shared<ReplayOptions>();
    command.addText("DIR", options->folder, "a folder with manifest.json").required();
    addChoice(command, "--against", {"cpu", "gl", "embree"},
              "build and trace the same with this backend, and compare",
              [options](size_t i) { options->against = (BackendKind) i; });
    addSettingsOptions(command, options->common);
    command.addFlag("--json", options->json, "print one JSON object on standard output");
    command.onRun([options, &status] { status = runReplay(*options) ? 0 : 1; });
}

} // namespace dirt
