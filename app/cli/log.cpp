#include "app/cli/log.h"

#include "app/cli/again.h"
#include "core/base/error.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <mutex>

namespace dirt {

namespace {

/// For the log and standard error, so that both have messages in the same order.
std::mutex sayMutex;
std::unique_ptr<LogFile> logFile; ///< null: none

void print(const char* begin, std::string_view text) noexcept {
    std::fprintf(stderr, "%s%.*s\n", begin, (int) text.size(), text.data());
}

/// A disk that is full ends the log and nothing else.
void writeToLog(LogLevel level, std::string_view text) noexcept {
    if (!logFile || logFile->write(level, text)) return;
    std::fprintf(stderr, "dirt: %s: cannot write: %s: the log ends here\n", logFile->path().c_str(),
                 std::strerror(errno));
    logFile.reset();
}

/// The log comes first: a pipe of standard error that nobody reads may end the process.
void say(LogLevel level, const char* begin, std::string_view text, bool quiet) noexcept {
    const std::lock_guard lock(sayMutex);
    writeToLog(level, text);
    if (!quiet) print(begin, text);
}

} // namespace

void sayError(std::string_view text) noexcept {
    say(LogLevel::error, "dirt: ", text, false);
}

void sayWarning(std::string_view text, bool quiet) {
    say(LogLevel::warning, "dirt: warning: ", text, quiet);
}

void sayNote(std::string_view text, bool quiet) {
    say(LogLevel::note, "dirt: ", text, quiet);
}

void sayPlain(std::string_view text) {
    say(LogLevel::note, "", text, false);
}

void sayWritten(const std::string& file, bool quiet) {
    const std::string text = "wrote " + file;
    const std::lock_guard lock(sayMutex);
    writeToLog(LogLevel::note, text);
    if (!quiet) print("", file);
}

void logWritten(const std::string& file) {
    sayWritten(file, true);
}

void logOnly(LogLevel level, std::string_view text) {
    say(level, "", text, true);
}

Log::Log(int argc, const char* const* argv) noexcept : argc_(argc), argv_(argv) {}

Log::~Log() {
    const std::lock_guard lock(sayMutex);
    logFile.reset();
}

void Log::open(const std::string& path) {
    std::string first = "dirt " DIRT_VERSION ":";
    for (int i = 0; i < argc_; ++i) first += " " + shellWord(argv_[i]);
    const std::lock_guard lock(sayMutex);
    if (logFile) throw InputError("--log: given twice");
    logFile = std::make_unique<LogFile>(path, first);
}

void Log::discard() {
    const std::lock_guard lock(sayMutex);
    if (logFile) logFile->discard();
    logFile.reset();
}

} // namespace dirt
