#include "app/cli/commands.h"
#include "app/cli/input.h"
#include "app/cli/option_values.h"
#include "app/cli/verify_report.h"
#include "core/io/error.h"

#ifdef DIRT_HAVE_EMBREE
#include "backend_embree/embree_backend.h"
#endif

#include <memory>
#include <vector>

namespace dirt {

namespace {

struct VerifyOptions {
    CommonOptions common;
    VerifySettings settings;
    std::vector<std::string> kinds;
    bool json = false;
};

std::vector<RayKind> kindsOf(const VerifyOptions& options) {
    if (options.kinds.empty()) return {kRayKinds.begin(), kRayKinds.end()};
    std::vector<RayKind> kinds;
    for (const std::string& name : options.kinds) {
        const auto kind = rayKindByName(name);
        if (!kind)
            throw InputError("--kinds: '" + name + "' is none of primary, diffuse, vertex, edge, " +
                             "axis, grazing");
        kinds.push_back(*kind);
    }
    return kinds;
}

/// Embree as its users get it, by default and robust.
std::vector<std::unique_ptr<Backend>> makePeers([[maybe_unused]] Executor& executor) {
#ifdef DIRT_HAVE_EMBREE
    std::vector<std::unique_ptr<Backend>> peers;
    for (const bool robust : {false, true})
        peers.push_back(std::make_unique<EmbreeBackend>(executor, robust, EmbreeDecision::plain));
    return peers;
#else
    throw CapabilityError("verify compares with Embree, and this build is without it");
#endif
}

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
    std::vector<std::string> names;
    std::vector<PassTime> build; // of the first
    for (Tracer* tracer : tracers) {
        const auto passes = tracer->build(geometry, camera, grid);
        if (tracer == tested.get()) build = passes;
        names.push_back(tracer->name());
    }
    names[0] = "dirt " + names[0];

    VerifySettings settings = options.settings;
    settings.seed = input.settings.seed;
    Verifier verifier(geometry, camera, grid, tracers, settings, *executor);
    std::FILE* const table = options.json ? stderr : stdout;
    const bool printed = !options.json || !options.common.quiet;
    Json results = Json::object();
    bool right = true;
    if (printed) printVerifyHeader(table);
    for (const RayKind kind : kinds) {
        const KindReport report = verifier.run(kind);
        if (printed) printKind(table, report, names);
        printWrongAnswers(stderr, report, options.common.scene, input, settings);
        results[std::string(rayKindName(kind))] = kindJson(report, names);
        right = right && report.backends[0].errors() == 0;
    }
    if (options.json) {
        Json report = reportOf(input, *tested, *executor, build);
        report["kinds"] = std::move(results);
        std::printf("%s\n", report.dump(2).c_str());
    }
    return right;
}

} // namespace

void addVerify(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "verify", "casts rays through the structure and through Embree, and judges exactly");
    const auto options = std::make_shared<VerifyOptions>();
    addCommonOptions(*command, options->common);
    addInteger(*command, "--rays", 1, 100'000'000, "rays of each kind (default: 1000000)",
               [options](int64_t n) { options->settings.rays = (uint32_t) n; });
    command
        ->add_option("--kinds", options->kinds,
                     "of primary,diffuse,vertex,edge,axis,grazing (default: all)")
        ->delimiter(',');
    command->add_flag("--json", options->json, "print one JSON object on standard output");
    command->callback([options, &status] { status = runVerify(*options) ? 0 : 1; });
}

} // namespace dirt
