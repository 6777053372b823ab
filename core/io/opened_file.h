#pragma once

#include <cstddef>
#include <filesystem>

namespace dirt {

/// Throws InputError ("file: is a FIFO, not a file") where something is there that is neither an
/// ordinary file nor a folder: a FIFO, a socket, a device, or a file that the kernel makes up, as
/// in /proc. To read one may take forever, and tells of the machine, not of a scene.
void refuseSpecialFile(const std::filesystem::path& file);

/// An ordinary file, opened for reading. No special file is opened, nor waited for.
class OpenedFile {
public:
    /// Throws InputError where there is none, or it cannot be opened.
    explicit OpenedFile(const std::filesystem::path& file);
    ~OpenedFile();
    OpenedFile(const OpenedFile&) = delete;
    OpenedFile& operator=(const OpenedFile&) = delete;

    /// Bytes, when it was opened.
    size_t size() const { return size_; }
    /// Reads up to \p count of the next bytes; 0 at the end. Throws InputError.
    size_t read(char* to, size_t count) const;

private:
    const std::filesystem::path& file_;
    int descriptor_ = -1;
    size_t size_ = 0;
};

} // namespace dirt
