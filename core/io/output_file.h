#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace dirt {

/// A file that appears whole or not at all: it is written in the same folder without a name, which
/// the system removes whatever ends the process, flushed to the disk, then takes its place. An old
/// file's mode stays, and a symbolic link, whose target is written. Whatever fails throws
/// InputError "path: why not", and leaves what was at the path before untouched. Refuses to replace
/// what is not a regular file, is write-protected, or is an input of the run or its log (see
/// InputFiles).
class OutputFile {
public:
    /// What it is while it is written. Named: for file systems that know no unnamed files; what
    /// SIGKILL leaves of one is removed when the same file is written again.
    enum class Temporary { unnamed, named };

    explicit OutputFile(const std::string& path, Temporary temporary = Temporary::unnamed);
    /// Removes what was written, but after takePlace().
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    void write(std::span<const std::byte> bytes);
    /// The file is whole; nothing may be written any more.
    void takePlace();

private:
    /// While one lives, exitBetweenFiles waits.
    struct ExitDelay {
        ExitDelay();
        ~ExitDelay();
    };

    void checkPlace() const;
    bool openUnnamed();
    void openNamed();
    void keepMode() const;
    void nameUnnamed();

    ExitDelay delay_;                 // the first, and so the last to go
    std::string path_;                ///< as given
    std::filesystem::path target_;    ///< where a link at the path leads
    std::filesystem::path temporary_; ///< empty: the file has no name
    int descriptor_ = -1;
};

/// Writes \p bytes as an OutputFile.
void writeFile(const std::string& path, std::span<const std::byte> bytes);

/// The same for text.
void writeFile(const std::string& path, const std::string& text);

/// Throws the InputError that writeFile would end in, as far as that can be known beforehand
/// (missing folder, no permission, a folder of that name), so that no render is in vain.
void checkWritable(const std::string& path);

/// Ends the process with \p status: at once, or where there are OutputFiles as soon as there is
/// none, so that no temporary file stays behind. For signal handlers; returns in the second case.
void exitBetweenFiles(int status) noexcept;

} // namespace dirt
