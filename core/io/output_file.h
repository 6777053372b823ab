#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace dirt {

/// A file that appears whole or not at all: it is written under a temporary name in the same
/// folder, flushed to the disk, then renamed. Whatever fails throws InputError "path: why not", and
/// leaves what was at the path before untouched. Refuses to replace what is not a regular file.
class OutputFile {
public:
    explicit OutputFile(const std::string& path);
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

    ExitDelay delay_; // the first, and so the last to go
    std::string path_;
    std::filesystem::path temporary_;
    int descriptor_ = -1;
    bool renamed_ = false;
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
