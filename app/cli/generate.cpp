#include "scenes/generate/generate.h"
#include "app/cli/commands.h"
#include "app/cli/log.h"
#include "app/cli/option_values.h"
#include "core/base/error.h"

#include <cstdio>
#include <memory>
#include <optional>

namespace dirt {

namespace {

struct GenerateOptions {
    std::string name, directory;
    std::optional<double> detail;
    bool list = false;
};

void printGenerators() {
    for (const GeneratorInfo& generator : generators())
        std::printf("%-14s %s; detail %.0f to %.0f, %.0f unless given\n", generator.name.c_str(),
                    generator.description.c_str(), generator.minDetail, generator.maxDetail,
                    generator.defaultDetail);
}

/// The generator of that name; throws InputError, with all names, where there is none.
GeneratorInfo find(const std::string& name) {
    std::string names;
    for (const GeneratorInfo& generator : generators()) {
        if (generator.name == name) return generator;
        names += (names.empty() ? "" : ", ") + generator.name;
    }
    throw InputError("generate: '" + name + "' is none of " + names);
}

void runGenerate(const GenerateOptions& options) {
    if (options.list && (!options.name.empty() || !options.directory.empty() || options.detail))
        throw InputError("generate: --list only prints what there is, and goes with nothing else");
    if (options.list) return printGenerators();
    if (options.name.empty()) throw InputError("generate: NAME is required (--list shows them)");
    if (options.directory.empty()) throw InputError("generate: -o DIR is required");
    const GeneratorInfo generator = find(options.name);
    const double detail = options.detail.value_or(generator.defaultDetail);
    if (detail < generator.minDetail || detail > generator.maxDetail) {
        char text[128];
        std::snprintf(text, sizeof text, "--detail: %.0f is not from %.0f to %.0f", detail,
                      generator.minDetail, generator.maxDetail);
        throw InputError(text);
    }
    for (const auto& file : generateScene(generator.name, detail, options.directory)) {
        std::printf("%s\n", file.c_str());
        logWritten(file);
    }
}

} // namespace

void addGenerate(Command program, int&) {
    const Command command = program.addCommand("generate", "writes a procedural scene");
    const auto options = std::make_shared<GenerateOptions>();
    command.addText("NAME", options->name, "which one");
    addInteger(command, "--detail", 1, 1'000'000'000, "about how many triangles",
               [options](int64_t n) { options->detail = (double) n; });
    command.addText("-o", options->directory, "folder to write to").typeName("DIR");
    command.addFlag("--list", options->list, "print what there is");
    command.onRun([options] { runGenerate(*options); });
}

} // namespace dirt
