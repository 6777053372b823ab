#pragma once

namespace dirt {

/// The program: runs the command that the arguments name and returns the exit status. It prints to
/// standard output and standard error, and throws nothing. It may be called again.
int runProgram(int argc, const char* const* argv);

} // namespace dirt
