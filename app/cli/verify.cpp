#include "app/cli/commands.h"
#include "app/cli/input.h"
#include "app/cli/option_values.h"
#include "app/cli/verify_options.h"
#include "app/cli/verify_report.h"

#include <memory>
#include <vector>

namespace dirt {

namespace {

constexpr uint32_t kRays = 1'000'000; ///< of each kind, where nothing else is said

/// Whether the backend under test answered every ray rightly.
bool runVerify(const VerifyOptions& options) {
    const std::vector<RayKind> kinds = kindsOf(options);
    const auto executor = makeExecutor(options.common);
    const auto peers = makePeers(*executor);
    const auto tested = makeBackend(options.common, *executor);
    const Input input = openInput(options.common, *executor);
    const GridSettings& grid = input.settings.grid;
    const Camera& camera = input.scene.camera;
    const FrameGeometry geometry = makeFrameGeometry(input.scene.mesh, camera, grid.mode);

    std::vector<Tracer*> tracers{tested.get()};
    for (const auto& peer : peers) tracers.push_back(peer.get());
    std::vector<PassTime> build; // of the first
    for (Tracer* tracer : tracers) {
        const auto passes = tracer->build(geometry, camera, grid);
        if (tracer == tested.get()) build = passes;
    }
    const std::vector<std::string> names = verifiedNames(tracers);

    VerifySettings settings;
    settings.rays = options.rays.value_or(kRays);
    settings.seed = input.settings.seed;
    Verifier verifier(geometry, camera, grid, tracers, settings, *executor);
    std::FILE* const table = options.json ? stderr : stdout;
    const bool printed = !options.json || !options.common.quiet;
    Json results = Json::object();
    std::optional<WrongAnswer> first;
    bool right = true;
    if (printed) printVerifyHeader(table);
    for (const RayKind kind : kinds) {
        const KindReport report = verifier.run(kind);
        if (printed) printKind(table, report, names);
        printWrongAnswers(stderr, report.wrong);
        if (report.backends[0].errors() > 0)
            printAgain(stderr, verifyCommand(options.common, input, settings) + " --kinds " +
                                   std::string(rayKindName(kind)));
        if (!first && !report.wrong.empty()) first = report.wrong.front();
        results[std::string(rayKindName(kind))] = kindJson(report, names);
        right = right && report.backends[0].errors() == 0;
    }
    if (first) printLook(stderr, options.common, input, *first);
    if (options.json) {
        Json report = reportOf(input, *tested, *executor, build);
        report["kinds"] = std::move(results);
        std::printf("%s\n", report.dump(2).c_str());
    }
    return right;
}

} // namespace

void addVerify(Command program, int& status) {
    const Command command = program.addCommand(
        "verify", "casts rays through the structure and through Embree, and judges exactly");
    const auto options = std::make_shared<VerifyOptions>();
    addCommonOptions(command, options->common);
    addInteger(command, "--rays", 1, 100'000'000,
               "rays of each kind (default: 1000000; 1000 of each variant)",
               [options](int64_t n) { options->rays = (uint32_t) n; });
    command.addTexts("--kinds", options->kinds, "of " + rayKindNames() + " (default: all)")
        .commaSeparated();
    command.addFlag("--extremes", options->extremes,
                    "verify hard variants of the scene, at 64x64 pixels unless --size is given");
    command.addTexts("--only", options->only, "these variants alone, by their names")
        .commaSeparated();
    command.addFlag("--json", options->json, "print one JSON object on standard output");
    command.onRun([options, &status] {
        extremesOf(*options); // or there is an unknown one
        status = (options->extremes ? runExtremes(*options) : runVerify(*options)) ? 0 : 1;
    });
}

} // namespace dirt
