#include "core/io/output_file.h"

#include "core/io/error.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <sstream>

#include <fcntl.h>
#include <unistd.h>

namespace dirt {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
    throw InputError(path + ": cannot write: " + reason);
}

/// OutputFiles there are, and the status to exit with after them; -1: none. A signal handler uses
/// them too.
std::atomic<int> filesUnderWay{0}, exitStatus{-1};
static_assert(std::atomic<int>::is_always_lock_free);

} // namespace

// Each side first says what it does, then looks at what the other does; so one of them at least
// sees both, and ends the process.
OutputFile::ExitDelay::ExitDelay() {
    ++filesUnderWay;
    if (exitStatus < 0) return;
    if (--filesUnderWay == 0) _exit(exitStatus);
    for (;;) pause(); // another thread's file is the last
}

OutputFile::ExitDelay::~ExitDelay() {
    if (--filesUnderWay == 0 && exitStatus >= 0) _exit(exitStatus);
}

void exitBetweenFiles(int status) noexcept {
    exitStatus = status;
    if (filesUnderWay == 0) _exit(status);
}

OutputFile::OutputFile(const std::string& path) : path_(path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::is_directory(status)) fail(path, "is a folder");
    if (fs::exists(status) && !fs::is_regular_file(status)) fail(path, "not a regular file");

    const fs::path target(path);
    for (int attempt = 0; descriptor_ < 0; ++attempt) {
        std::ostringstream name;
        name << '.' << target.filename().string() << '.' << getpid() << '-' << attempt;
        temporary_ = target.parent_path() / name.str();
        descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ < 0 && errno != EEXIST) fail(path, std::strerror(errno));
    }
}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!renamed_) unlink(temporary_.c_str());
}

void OutputFile::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(path_, std::strerror(errno));
        bytes = bytes.subspan((size_t) count);
    }
}

void OutputFile::takePlace() {
    // Some file systems report a full disk or quota only here. EINVAL: nothing to flush there.
    if (fsync(descriptor_) != 0 && errno != EINVAL) fail(path_, std::strerror(errno));
    const int closed = close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) fail(path_, std::strerror(errno));
    if (std::rename(temporary_.c_str(), path_.c_str()) != 0) fail(path_, std::strerror(errno));
    renamed_ = true;
}

void writeFile(const std::string& path, std::span<const std::byte> bytes) {
    OutputFile file(path);
    file.write(bytes);
    file.takePlace();
}

void writeFile(const std::string& path, const std::string& text) {
    writeFile(path, std::as_bytes(std::span(text)));
}

void checkWritable(const std::string& path) {
    OutputFile file(path);
}

} // namespace dirt
