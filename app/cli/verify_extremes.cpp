#include "core/verify/verify_extremes.h"
#include "app/cli/extremes_report.h"
#include "app/cli/input.h"
#include "app/cli/verify_options.h"
#include "app/cli/verify_report.h"

namespace dirt {

namespace {

/// Small, as there are many variants.
constexpr ImageSize kSize{64, 64};
constexpr uint32_t kRaysOfVariant = 1000; ///< of each kind, where nothing else is said

} // namespace

bool runExtremes(VerifyOptions options) {
    const std::vector<RayKind> kinds = kindsOf(options);
    if (!options.common.size) options.common.size = kSize;
    const auto executor = makeExecutor(options.common);
    const auto peers = makePeers(*executor);
    const auto tested = makeBackend(options.common, *executor);
    const Input input = openInput(options.common, *executor);

    std::vector<Backend*> backends{tested.get()};
    for (const auto& peer : peers) backends.push_back(peer.get());
    const std::vector<std::string> names = verifiedNames({backends.begin(), backends.end()});
    VerifySettings settings;
    settings.rays = options.rays.value_or(kRaysOfVariant);
    settings.seed = input.settings.seed;
    std::string kindsOption;
    for (const std::string& kind : options.kinds)
        kindsOption += (kindsOption.empty() ? " --kinds " : ",") + kind;

    ExtremeVerifier verifier(input.scene, input.settings, backends, settings, *executor);
    std::FILE* const table = options.json ? stderr : stdout;
    const bool printed = !options.json || !options.common.quiet;
    ExtremesSum sum;
    Json results = Json::object();
    if (printed) printExtremesHeader(table);
    for (const Extreme* extreme : extremesOf(options)) {
        const ExtremeReport report = verifier.run(*extreme, kinds);
        sum.add(report);
        if (printed) printExtreme(table, report, names);
        printWrongAnswers(stderr, report.wrong);
        if (!report.backends[0].right())
            printAgain(stderr, verifyCommand(options.common, input, settings) + kindsOption +
                                   " --extremes --only " + std::string(extreme->name));
        results[std::string(extreme->name)] = extremeJson(report, names);
    }
    if (printed) printSum(table, sum);
    if (options.json) {
        Json report = reportOf(input, *tested, *executor, {});
        report["extremes"] = std::move(results);
        std::printf("%s\n", report.dump(2).c_str());
    }
    return sum.wrong == 0;
}

} // namespace dirt
