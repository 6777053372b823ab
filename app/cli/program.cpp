#include "app/cli/program.h"

#include "app/cli/commands.h"
#include "app/cli/log.h"
#include "core/base/error.h"
#include "core/io/input_files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace dirt {

namespace {

/// As where the signal ends the program.
constexpr int kBrokenPipe = 141;

enum ExitStatus { kDone = 0, kBadInput = 2, kMissingCapability = 3 };

/// Says the one line that explains a status of 2 or 3.
int fail(ExitStatus status, std::string_view message) {
    sayError(message.substr(0, message.find('\n')));
    return status;
}

/// The same without a text of its own, for which there may be no memory either.
int failForMemory() {
    sayError("out of memory: a smaller --size, fewer --bins or a larger --tile needs less");
    return kBadInput;
}

/// One line for what CLI11 says on one or two, in our words where its own are not clear.
std::string describe(const CLI::App& program, const CLI::ParseError& error) {
    const auto chosen = program.get_subcommands();
    const std::string help = " (dirt " + (chosen.empty() ? "" : chosen.front()->get_name() + " ") +
                             "--help shows what there is)";
    const auto is = [&](CLI::ExitCodes kind) { return error.get_exit_code() == (int) kind; };
    const std::string text = error.what();
    const std::vector<std::string> extras = program.remaining(true);
    if (is(CLI::ExitCodes::ExtrasError) && !extras.empty())
        return "unexpected argument '" + extras.front() + "'" + help;
    if (is(CLI::ExitCodes::ArgumentMismatch))
        return text.substr(0, text.find(':')) + ": its value is missing" + help;
    return is(CLI::ExitCodes::RequiredError) ? text + help : text;
}

/// Gives --log to \p app, or to its commands where it has some. The file is opened as soon as its
/// name is read, so that what is wrong with the other options is in it.
void addLog(CLI::App& app, const std::function<void(const std::string&)>& open) {
    const auto commands = app.get_subcommands([](const CLI::App*) { return true; });
    for (CLI::App* command : commands) addLog(*command, open);
    if (!commands.empty()) return;
    app.add_option_function<std::string>(
           "--log", open,
           "also write what is said on standard error, quiet or not, to FILE, with time and level; "
           "an earlier log is replaced, any other file refused")
        ->type_name("FILE")
        ->trigger_on_parse();
}

/// At its end, a log that the next run would read as an input goes.
class LogSpares {
public:
    LogSpares(InputFiles& inputs, Log& log) : inputs_(inputs), log_(log) {}
    ~LogSpares() {
        if (inputs_.readsLog()) log_.discard();
    }
    LogSpares(const LogSpares&) = delete;
    LogSpares& operator=(const LogSpares&) = delete;

private:
    InputFiles& inputs_;
    Log& log_;
};

int run(int argc, const char* const* argv, Log& log) {
    InputFiles inputs; // from here on none is written over
    const LogSpares spares(inputs, log);
    CLI::App program("Deferred Image-based Ray Tracing: the reference implementation", "dirt");
    program.set_version_flag("--version", "dirt " DIRT_VERSION);
    program.require_subcommand(0, 1);
    program.get_formatter()->column_width(36);

    int status = kDone;
    const Command root(&program);
    addRender(root, status);
    addVerify(root, status);
    addCheck(root, status);
    addCompare(root, status);
    addBench(root, status);
    addInfo(root, status);
    addDump(root, status);
    addExplain(root, status);
    addPreview(root, status);
    addView(root, status);
    addReplay(root, status);
    addGenerate(root, status);
    addLog(program, [&](const std::string& file) {
        log.open(file);
        inputs.keepLog(file);
    });

    try {
        program.parse(argc, argv);
        if (program.get_subcommands().empty()) std::fputs(program.help().c_str(), stdout);
        return status;
    } catch (const CLI::Success& request) { // --help, --version
        return program.exit(request);
    } catch (const CLI::ParseError& error) {
        return fail(kBadInput, describe(program, error));
    } catch (const InputError& error) {
        return fail(kBadInput, error.what());
    } catch (const CapabilityError& error) {
        return fail(kMissingCapability, error.what());
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        return fail(kBadInput, error.what());
    }
}

/// Also where memory is out before there are options, or while something else is being said.
int runWithinMemory(int argc, const char* const* argv, Log& log) {
    try {
        return run(argc, argv, log);
    } catch (const std::bad_alloc&) {
        return failForMemory();
    }
}

} // namespace

int runProgram(int argc, const char* const* argv) {
    Log log(argc, argv);
    std::clearerr(stdout);
    errno = 0;
    const int status = runWithinMemory(argc, argv, log);
    // A full disk may show only now.
    const bool flushed = std::fflush(stdout) == 0;
    if (!flushed && errno == EPIPE) return kBrokenPipe; // whoever read it has what he wanted
    if ((!flushed || std::ferror(stdout)) && status == kDone)
        return fail(kBadInput, std::string("standard output: cannot write: ") +
                                   std::strerror(errno != 0 ? errno : EIO));
    return status;
}

} // namespace dirt
