#pragma once

namespace dirt {

/// Exit status of a command that Ctrl-C has stopped.
inline constexpr int kInterrupted = 130;

/// From now on the first Ctrl-C only makes interrupted() true, so that a command can write what it
/// has; the second ends the program at once.
void catchInterrupts();

/// Whether Ctrl-C was pressed.
bool interrupted();

} // namespace dirt
