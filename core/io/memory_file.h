#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace dirt {

/// A file that lies in memory alone, for libraries that insist on a file's name. Linux only.
class MemoryFile {
public:
    /// Throws InputError where the system refuses.
    MemoryFile();
    ~MemoryFile();
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    /// To be opened by.
    const std::string& name() const { return name_; }

    /// Whether a limit on the size of files, which holds here too, may have cut it short: not every
    /// library looks whether its last writes succeed.
    bool cutShort() const;

    /// What has been written. Throws InputError.
    std::vector<std::byte> contents() const;

private:
    size_t size() const;

    int descriptor_;
    std::string name_;
};

} // namespace dirt
