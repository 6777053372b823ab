#pragma once

#include <string>
#include <string_view>

namespace dirt {

/// How much a message matters.
enum class LogLevel { error, warning, note };

/// A file of messages, each on a line of its own behind the time and its level:
///
///     2026-02-03T04:05:06.789Z warning: a.obj:1: a.mtl: no such file
///
/// A line is in the file when it has been written, whole, whatever ends the process then.
class LogFile {
public:
    /// Makes the file, or empties it where it is a log of ours or empty: no other file is lost.
    /// \p first is its first line, a note, which has to begin with "dirt ". Throws InputError where
    /// that cannot be: see checkWritable.
    LogFile(const std::string& path, std::string_view first);
    ~LogFile();
    LogFile(const LogFile&) = delete;
    LogFile& operator=(const LogFile&) = delete;

    const std::string& path() const { return path_; }

    /// A line for each of \p text. Returns whether the file took them; else errno says why not.
    /// Takes no memory.
    bool write(LogLevel level, std::string_view text) noexcept;

    /// Removes the file, but where it was there before.
    void discard();

private:
    std::string path_;
    bool isNew_ = false;
    int descriptor_ = -1;
};

} // namespace dirt
