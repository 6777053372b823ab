#pragma once

#include "app/cli/log_file.h"

#include <memory>
#include <string>
#include <string_view>

namespace dirt {

// What the program says about itself: on standard error, and in the file of --log, if there is one.
// Any thread may say something. --quiet leaves errors on standard error, and all in the log.
// Tables and progress are no messages.

/// Says "dirt: TEXT": why the program ends with another status than 0. Takes no memory.
void sayError(std::string_view text) noexcept;

/// Says "dirt: warning: TEXT".
void sayWarning(std::string_view text, bool quiet);

/// Says "dirt: TEXT".
void sayNote(std::string_view text, bool quiet);

/// Says TEXT as it is, of one line or more.
void sayPlain(std::string_view text);

/// Says that a file was written: its name alone, in the log with "wrote" before it.
void sayWritten(const std::string& file, bool quiet);

/// The same, in the log only.
void logWritten(const std::string& file);

/// In the log only: what is said elsewhere than on standard error.
void logOnly(LogLevel level, std::string_view text);

/// The log of a run. While one lives, what is said is in its file, too.
class Log {
public:
    /// \p argc and \p argv: the command line, which must outlive it.
    Log(int argc, const char* const* argv) noexcept;
    ~Log();
    Log(const Log&) = delete;
    Log& operator=(const Log&) = delete;

    /// Throws InputError where \p path cannot be a log, see LogFile, or there is one.
    void open(const std::string& path);
    /// Nothing is logged any more, and a file that is new goes.
    void discard();

private:
    const int argc_;
    const char* const* const argv_;
};

} // namespace dirt
