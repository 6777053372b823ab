#include "app/cli/log_file.h"

#include "core/base/error.h"
#include "core/io/output_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <span>

#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

namespace dirt {

namespace {

constexpr std::string_view kTimeForm = "0000-00-00T00:00:00.000Z";
constexpr std::string_view kFirstLine = " note: dirt ";

/// "TIME LEVEL: ".
struct LinePrefix {
    explicit LinePrefix(LogLevel level) {
        constexpr const char* kLevels[] = {"error", "warning", "note"};
        timespec now{};
        clock_gettime(CLOCK_REALTIME, &now);
        tm utc{};
        gmtime_r(&now.tv_sec, &utc);
        char seconds[32] = "";
        std::strftime(seconds, sizeof seconds, "%Y-%m-%dT%H:%M:%S", &utc);
        length = (size_t) std::snprintf(text, sizeof text, "%s.%03dZ %s: ", seconds,
                                        (int) (now.tv_nsec / 1'000'000), kLevels[(size_t) level]);
    }

    char text[64];
    size_t length;
};

/// Whether what is there begins as a log does, or is empty.
bool isOurs(const std::string& path) {
    const int descriptor = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (descriptor < 0) return false;
    char bytes[kTimeForm.size() + kFirstLine.size()];
    const ssize_t count = read(descriptor, bytes, sizeof bytes);
    close(descriptor);
    if (count <= 0) return count == 0;
    const std::string_view begin(bytes, (size_t) count);
    const auto fits = [](char form, char c) {
        return form == '0' ? c >= '0' && c <= '9' : c == form;
    };
    return std::equal(kTimeForm.begin(), kTimeForm.end(), begin.begin(),
                      begin.begin() + (ptrdiff_t) std::min(begin.size(), kTimeForm.size()), fits) &&
           begin.substr(kTimeForm.size()) == kFirstLine;
}

/// In one call as a rule, so that lines of several processes do not mix.
bool writeParts(int descriptor, std::span<iovec> parts) noexcept {
    while (!parts.empty()) {
        const ssize_t count = writev(descriptor, parts.data(), (int) parts.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return false;
        auto left = (size_t) count;
        while (!parts.empty() && left >= parts.front().iov_len) {
            left -= parts.front().iov_len;
            parts = parts.subspan(1);
        }
        if (parts.empty()) break;
        parts.front().iov_base = static_cast<char*>(parts.front().iov_base) + left;
        parts.front().iov_len -= left;
    }
    return true;
}

} // namespace

LogFile::LogFile(const std::string& path, std::string_view first) : path_(path) {
    const auto fail = [&](const std::string& reason) {
        throw InputError(path + ": cannot write: " + reason);
    };
    checkWritable(path);
    const int how = O_WRONLY | O_APPEND | O_NONBLOCK | O_NOCTTY | O_CLOEXEC;
    descriptor_ = open(path.c_str(), how | O_CREAT | O_EXCL, 0666);
    isNew_ = descriptor_ >= 0;
    if (!isNew_) {
        if (errno != EEXIST) fail(std::strerror(errno));
        // The file that a link of the name leads to may be missing.
        isNew_ = access(path.c_str(), F_OK) != 0;
        if (!isNew_ && !isOurs(path)) fail("it is no log of dirt, and would be lost");
        descriptor_ = open(path.c_str(), how | O_CREAT | O_TRUNC, 0666);
    }
    if (descriptor_ < 0) fail(std::strerror(errno));
    if (write(LogLevel::note, first)) return;
    const std::string reason = std::strerror(errno);
    discard();
    close(descriptor_);
    fail(reason);
}

LogFile::~LogFile() {
    close(descriptor_);
}

bool LogFile::write(LogLevel level, std::string_view text) noexcept {
    LinePrefix prefix(level);
    for (;;) {
        const size_t length = std::min(text.find('\n'), text.size());
        char end = '\n';
        iovec parts[] = {{prefix.text, prefix.length},
                         {const_cast<char*>(text.data()), length}, // which writev does not change
                         {&end, 1}};
        if (!writeParts(descriptor_, parts)) return false;
        if (length + 1 >= text.size()) return true;
        text.remove_prefix(length + 1);
    }
}

void LogFile::discard() {
    if (isNew_) unlink(path_.c_str());
}

} // namespace dirt
