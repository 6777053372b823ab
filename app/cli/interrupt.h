#pragma once

namespace dirt {

/// From now on Ctrl-C, SIGTERM and SIGHUP end the program with status 128 + the signal's number
/// (130, 143, 129), and a pipe that nobody reads any more with 141; a file that is being written is
/// first finished (see exitBetweenFiles). SIGHUP and SIGTERM stay ignored where they are (nohup).
void exitOnInterrupt();

/// From now on the first of Ctrl-C, SIGTERM and SIGHUP only makes interrupted() true, so that a
/// command can write what it has; the second ends the program as above. A pipe that nobody reads
/// ends nothing: what counts goes to files.
void catchInterrupts();

/// Whether one of the signals has come.
bool interrupted();

/// The status to exit with after it.
int interruptStatus();

} // namespace dirt
