#pragma once

#include "app/cli/program.h"
#include "tests/support/captured_stream.h"
#include "tests/support/temporary_folder.h"

#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace dirt::test {

/// What a run of the program gave.
struct Outcome {
    int status = -1; ///< exit status; 128 + signal where a signal ended it
    std::string out, err;
};

/// Runs `dirt` of this build inside this process.
inline Outcome dirt(const std::vector<std::string>& arguments) {
    std::vector<const char*> argv{"dirt"};
    for (const std::string& argument : arguments) argv.push_back(argument.c_str());
    CapturedStream out(stdout), err(stderr);
    Outcome run;
    run.status = runProgram((int) argv.size(), argv.data());
    run.out = out.text();
    run.err = err.text();
    return run;
}

/// A run of the program in a process of its own.
class Process {
public:
    /// Starts \p program with \p arguments, passed as they are. \p prepare is called in the new
    /// process before the program takes its place; streams can be redirected there.
    template <typename Prepare>
    Process(const std::string& program, const std::vector<std::string>& arguments,
            Prepare&& prepare) {
        child_ = fork();
        if (child_ < 0) std::abort();
        if (child_ > 0) return;
        std::vector<char*> argv{const_cast<char*>(program.c_str())};
        for (const std::string& argument : arguments)
            argv.push_back(const_cast<char*>(argument.c_str()));
        argv.push_back(nullptr);
        const std::string out = folder_ / "out", err = folder_ / "err";
        if (!std::freopen(out.c_str(), "w", stdout) || !std::freopen(err.c_str(), "w", stderr))
            _exit(126);
        prepare();
        execv(program.c_str(), argv.data());
        _exit(127);
    }

    pid_t id() const { return child_; }

    /// Waits for the end.
    Outcome wait() {
        int state = 0;
        if (waitpid(child_, &state, 0) != child_) std::abort();
        Outcome run;
        run.status = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
        run.out = readFile(folder_ / "out");
        run.err = readFile(folder_ / "err");
        return run;
    }

private:
    TemporaryFolder folder_;
    pid_t child_ = -1;
};

/// Starts \p program and waits.
inline Outcome start(const std::string& program, const std::vector<std::string>& arguments) {
    return Process(program, arguments, [] {}).wait();
}

/// Starts `dirt` of this build as its users do, and waits.
inline Outcome startDirt(const std::vector<std::string>& arguments) {
    return start(DIRT_PROGRAM, arguments);
}

/// The same, with \p prepare called in the process beforehand.
template <typename Prepare>
Outcome startDirt(const std::vector<std::string>& arguments, Prepare&& prepare) {
    return Process(DIRT_PROGRAM, arguments, prepare).wait();
}

/// The arguments of the last `dirt` command that a report says after \p label ("again: "), as one
/// in a shell would give them; without what stands before "dirt". None of them needs quotes.
inline std::vector<std::string> saidCommand(const std::string& report, const std::string& label) {
    const size_t line = report.rfind(label);
    const size_t at = line == report.npos ? line : report.find("dirt ", line);
    if (at == report.npos) return {};
    std::istringstream words(report.substr(at + 5, report.find('\n', at) - at - 5));
    return {std::istream_iterator<std::string>(words), {}};
}

/// A triangle before a camera at the origin that looks along -Z.
inline constexpr const char* kTriangleObj = "v -1 -1 -2\nv 1 -1 -2\nv 0 1 -2\nf 1 2 3\n";

/// A lit triangle before the camera.
inline std::string litTriangle(const TemporaryFolder& folder) {
    folder.write("a.obj", kTriangleObj);
    return folder.write("a.scene", "<world background=\"0.25 0.5 1\"><object file=\"a.obj\"/>"
                                   "<light type=\"spotlight\" position=\"0 0 0\" target=\"0 0 -1\" "
                                   "flux=\"20\" aperture=\"120\" penumbra=\"100\"/>"
                                   "<user position=\"0 0 0\" lookat=\"0 0 -1\"/></world>");
}

} // namespace dirt::test
