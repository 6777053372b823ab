#pragma once

namespace dirt {

/// Exit status of a command that Ctrl-C has stopped.
inline constexpr int kInterrupted = 130;

/// From now on Ctrl-C ends the program with that status; a file that is being written is first
/// finished (see exitBetweenFiles).
void exitOnInterrupt();

/// From now on the first Ctrl-C only makes interrupted() true, so that a command can write what it
/// has; the second ends the program as above.
void catchInterrupts();

/// Whether Ctrl-C was pressed.
bool interrupted();

} // namespace dirt
