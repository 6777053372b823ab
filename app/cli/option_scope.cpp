#include "app/cli/option_scope.h"

#include "core/base/error.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace dirt {

namespace {

enum CommandBit : unsigned {
    kRender = 1,
    kInfo = 2,
    kDump = 4,
    kCheck = 8,
    kVerify = 16,
    kFrame = 32, ///< dirt bench …
    kTradeoff = 64,
    kScaling = 128,
    kExplain = 256,
    kPreview = 512,
    kReplay = 1024,
    kAll = 2047,
    kScene = kAll & ~kReplay,     ///< a dump has its settings
    kShading = kScene & ~kVerify, ///< verify casts rays at geometry
};

constexpr unsigned bit(BackendKind kind) {
    return 1u << (unsigned) kind;
}
constexpr unsigned kCpu = bit(BackendKind::cpu), kGl = bit(BackendKind::gl),
                   kEmbree = bit(BackendKind::embree), kGrid = kCpu | kGl, kAny = kGrid | kEmbree;

struct Scope {
    std::string_view option;
    unsigned commands, backends; ///< that honour it
    /// Whether the value that was given is what all others do anyway; null: none is.
    bool (*isWhatTheyDo)(const CommonOptions&) = nullptr;
};

/// Which commands and backends honour an option. One that is not here all do.
constexpr Scope kScopes[] = {
    {"--backend", kScene & ~kCheck, kAny}, // check has --backends
    {"--device", kScene, kGl},
    {"--view", kScene, kAny},
    {"--tile", kScene, kGrid},
    {"--bins", kScene, kGrid},
    {"--view-size", kScene, kGrid},
    {"--max-mip", kScene, kGrid},
    {"--traversal", kScene, kGrid},
    {"--primary", kShading, kGrid,
     [](const CommonOptions& o) { return o.primary == Primary::traced; }},
    {"--fetch", kShading, kGrid, [](const CommonOptions& o) { return o.fetch == Fetch::direct; }},
    {"--visibility", kShading, kAny},
    {"--shading", kShading, kAny},
    {"--precision", kScene, kGrid,
     [](const CommonOptions& o) { return o.precision == Precision::exact; }},
    {"--size", kScene, kAny},
    {"--spp", kRender | kInfo | kPreview, kAny},        // others take one sample, or say how many
    {"--bounces", kShading & ~(unsigned) kFrame, kAny}, // one bounce of light is timed
    {"--ray-type", kShading, kAny},
    {"--seed", kScene, kAny},
    {"--camera", kScene, kAny},
    {"--eye", kScene, kAny},
    {"--target", kScene, kAny},
    {"--up", kScene, kAny},
    {"--fov", kScene, kAny},
    {"--frame", kScene & ~kScaling, kAny}, // its scene does not move
    {"--threads", kAll, kAny},
    {"--memory", kScene, kAny},
    {"--quiet", kAll, kAny},
    {"--no-cache", kScene, kAny},
    {"--strict", kScene, kAny},
    {"--materials", kShading, kAny},
};

CommandBit commandOf(const std::string& name) {
    constexpr std::pair<std::string_view, CommandBit> kNames[] = {
        {"render", kRender},     {"info", kInfo},       {"dump", kDump},
        {"check", kCheck},       {"verify", kVerify},   {"frame", kFrame},
        {"tradeoff", kTradeoff}, {"scaling", kScaling}, {"explain", kExplain},
        {"preview", kPreview},   {"replay", kReplay}};
    for (const auto& [known, command] : kNames)
        if (name == known) return command;
    return kAll;
}

bool isGiven(const CommonOptions& o, std::string_view option) {
    return std::find(o.given.begin(), o.given.end(), option) != o.given.end();
}

/// As they are chosen: "--backend cpu", "--backends cpu,embree".
std::string backendText(const std::vector<BackendKind>& backends) {
    std::string text = backends.size() > 1 ? "--backends " : "--backend ";
    for (const BackendKind kind : backends)
        text.append(kind == backends.front() ? "" : ",").append(nameOf(kind));
    return text;
}

/// \p where: "in dirt verify", "with --backend cpu".
[[noreturn]] void refuse(std::string_view option, const std::string& where) {
    throw InputError(std::string(option) + ": has no effect " + where);
}

} // namespace

void limitOptions(Command command, CommonOptions& o) {
    o.sweeps = command.name() == "tradeoff";
    for (const Scope& scope : kScopes) {
        const std::optional<Option> option = command.find(std::string(scope.option));
        if (!option) continue;
        if ((scope.commands & commandOf(command.name())) == 0)
            option->hide().onValue(
                [path = command.path(), scope] { refuse(scope.option, "in " + path); });
        else if (scope.backends != kAny)
            option->onValue([&o, scope] { o.given.emplace_back(scope.option); });
    }
}

void refuseIdleOptions(const CommonOptions& o) {
    const std::vector<BackendKind> backends =
        o.backends.empty() ? std::vector<BackendKind>{o.backend} : o.backends;
    unsigned used = 0;
    for (const BackendKind kind : backends) used |= bit(kind);
    for (const Scope& scope : kScopes)
        if ((scope.backends & used) == 0 && isGiven(o, scope.option) &&
            !(scope.isWhatTheyDo && scope.isWhatTheyDo(o)))
            refuse(scope.option, "with " + backendText(backends));
}

void refuseIdleOptions(const CommonOptions& o, const RenderSettings& settings) {
    if (o.sweeps) return; // other choices are made in turn
    if (settings.grid.mode == ViewMode::single && o.viewSize)
        refuse("--view-size", "with a single view, which has the image's size");
    if (settings.grid.traversal == Traversal::linear && o.maxMip)
        refuse("--max-mip", "with --traversal linear, which uses no level but the lowest");
    if (settings.rayType == RayType::visibility && o.bounces)
        refuse("--bounces", "with --ray-type visibility, which has two");
    if (settings.bounces == 1 && o.rayType && o.bounces)
        refuse("--ray-type", "with --bounces 1, which has no indirect rays");
}

} // namespace dirt
