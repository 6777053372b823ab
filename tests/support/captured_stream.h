#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace dirt::test {

/// While it lives, what is written to one of the process's streams goes to memory instead.
class CapturedStream {
public:
    explicit CapturedStream(std::FILE* stream)
        : stream_(stream), memory_(memfd_create("captured", MFD_CLOEXEC)) {
        std::fflush(stream_);
        saved_ = fcntl(fileno(stream_), F_DUPFD_CLOEXEC, 3);
        if (memory_ < 0 || saved_ < 0 || dup2(memory_, fileno(stream_)) < 0) std::abort();
    }
    ~CapturedStream() {
        std::fflush(stream_);
        dup2(saved_, fileno(stream_));
        close(saved_);
        close(memory_);
    }
    CapturedStream(const CapturedStream&) = delete;
    CapturedStream& operator=(const CapturedStream&) = delete;

    /// All that was written so far.
    std::string text() {
        std::fflush(stream_);
        std::string bytes((size_t) lseek(memory_, 0, SEEK_END), '\0');
        if (pread(memory_, bytes.data(), bytes.size(), 0) != (ssize_t) bytes.size()) std::abort();
        return bytes;
    }

private:
    std::FILE* stream_;
    int memory_, saved_ = -1;
};

} // namespace dirt::test
