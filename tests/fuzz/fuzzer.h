#pragma once

#include "core/base/error.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <sys/mman.h>
#include <unistd.h>

namespace dirt::fuzz {

/// Gives bytes to \p read as a file (in memory). It may throw InputError, as one line that names
/// the file; anything else is a find.
template <typename Read>
int readBytes(const uint8_t* data, size_t size, Read&& read) {
    static const int memory = memfd_create("input", 0);
    if (memory < 0 || ftruncate(memory, 0) != 0 || pwrite(memory, data, size, 0) != (ssize_t) size)
        std::abort();
    const std::string file = "/proc/self/fd/" + std::to_string(memory);
    try {
        read(std::filesystem::path(file));
    } catch (const InputError& error) {
        const std::string line = error.what();
        if (line.rfind(file + ":", 0) != 0 || line.find_first_of("\r\n") != line.npos) {
            std::fprintf(stderr, "not one line that names the file: %s\n", line.c_str());
            std::abort();
        }
    }
    return 0;
}

} // namespace dirt::fuzz
