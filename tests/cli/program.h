#pragma once

#include "tests/support/temporary_folder.h"

#include <cstdio>
#include <cstdlib>
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

/// Runs \p program with \p arguments, passed as they are.
inline Outcome runProgram(const std::string& program, const std::vector<std::string>& arguments) {
    const TemporaryFolder folder;
    const std::string out = folder / "out", err = folder / "err";
    const pid_t child = fork();
    if (child == 0) {
        std::vector<char*> argv{const_cast<char*>(program.c_str())};
        for (const std::string& argument : arguments)
            argv.push_back(const_cast<char*>(argument.c_str()));
        argv.push_back(nullptr);
        if (!std::freopen(out.c_str(), "w", stdout) || !std::freopen(err.c_str(), "w", stderr))
            _exit(126);
        execv(program.c_str(), argv.data());
        _exit(127);
    }
    int state = 0;
    if (child < 0 || waitpid(child, &state, 0) != child) std::abort();
    Outcome run;
    run.status = WIFEXITED(state) ? WEXITSTATUS(state) : 128 + WTERMSIG(state);
    run.out = readFile(out);
    run.err = readFile(err);
    return run;
}

/// Runs `dirt` of this build.
inline Outcome dirt(const std::vector<std::string>& arguments) {
    return runProgram(DIRT_PROGRAM, arguments);
}

/// A triangle before a camera at the origin that looks along -Z.
inline constexpr const char* kTriangleObj = "v -1 -1 -2\nv 1 -1 -2\nv 0 1 -2\nf 1 2 3\n";

} // namespace dirt::test
