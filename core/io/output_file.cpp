#include "core/io/output_file.h"

#include "core/base/error.h"
#include "core/io/content_hash.h"
#include "core/io/input_files.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace dirt {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
    throw InputError(path + ": cannot write: " + reason);
}

/// A file's name through its descriptor.
std::string openFile(int descriptor) {
    return "/proc/self/fd/" + std::to_string(descriptor);
}

/// A temporary name for \p target: beside it, and never too long. Several processes may write it.
fs::path hiddenName(const fs::path& target, int place) {
    const std::string name = target.filename().string();
    char text[48];
    std::snprintf(text, sizeof text, ".dirt-%016llx-%d",
                  (unsigned long long) contentHash(std::as_bytes(std::span(name))), place);
    return (target.has_parent_path() ? target.parent_path() : fs::path(".")) / text;
}

/// Whether \p file was left behind by a process that is no more, and is removed now: what is being
/// written is locked.
bool removeStale(const fs::path& file) {
    const int descriptor = open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) return errno == ENOENT;
    // Meanwhile it may be whole and renamed, and the name another's.
    struct stat locked {
    }, named{};
    const bool stale = flock(descriptor, LOCK_EX | LOCK_NB) == 0 &&
                       fstat(descriptor, &locked) == 0 && stat(file.c_str(), &named) == 0 &&
                       locked.st_dev == named.st_dev && locked.st_ino == named.st_ino;
    if (stale) unlink(file.c_str());
    close(descriptor);
    return stale;
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

OutputFile::OutputFile(const std::string& path, Temporary temporary)
    : path_(path), target_(linkTarget(path)) {
    checkPlace();
    removeStale(hiddenName(target_, 0));
    if (temporary == Temporary::named || !openUnnamed()) openNamed();
}

OutputFile::~OutputFile() {
    if (descriptor_ >= 0) close(descriptor_);
    if (!temporary_.empty()) unlink(temporary_.c_str());
}

void OutputFile::checkPlace() const {
    std::error_code error;
    const fs::file_status status = fs::status(path_, error);
    if (fs::is_directory(status)) fail(path_, "is a folder");
    if (fs::exists(status) && !fs::is_regular_file(status)) fail(path_, "not a regular file");
    if (fs::is_symlink(target_, error)) fail(path_, std::strerror(ELOOP));
    switch (inputUseOf(path_)) {
    case InputFiles::Use::read:
        fail(path_, "the input is read from this file");
    case InputFiles::Use::wanted:
        fail(path_, "the input names this file, which is missing, and would be given it");
    case InputFiles::Use::log:
        fail(path_, "the log is written to this file");
    case InputFiles::Use::none:
        break;
    }
    if (fs::exists(status) && access(path_.c_str(), W_OK) != 0) fail(path_, std::strerror(errno));
}

bool OutputFile::openUnnamed() {
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : ".";
    descriptor_ = open(folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
    if (descriptor_ < 0) return false;
    // Its name is given through /proc, which a chroot may lack.
    if (access(openFile(descriptor_).c_str(), F_OK) == 0 && flock(descriptor_, LOCK_EX) == 0)
        return true;
    close(descriptor_);
    descriptor_ = -1;
    return false;
}

void OutputFile::openNamed() {
    for (int place = 0; descriptor_ < 0;) {
        temporary_ = hiddenName(target_, place);
        descriptor_ = open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor_ >= 0) {
            struct stat status {};
            const bool locked = flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno == ENOTSUP;
            if (locked && fstat(descriptor_, &status) == 0 && status.st_nlink > 0) return;
            close(descriptor_); // another process took it for a stale one just then
            descriptor_ = -1;
        } else if (errno != EEXIST) {
            temporary_.clear();
            fail(path_, std::strerror(errno));
        } else if (!removeStale(temporary_)) {
            ++place;
        }
    }
}

void OutputFile::write(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(path_, std::strerror(errno));
        bytes = bytes.subspan((size_t) count);
    }
}

/// Those of the file that is replaced, as far as that is allowed.
void OutputFile::keepMode() const {
    struct stat status {};
    if (stat(target_.c_str(), &status) != 0) return;
    [[maybe_unused]] const int owned = fchown(descriptor_, status.st_uid, status.st_gid);
    [[maybe_unused]] const int moded = fchmod(descriptor_, status.st_mode & 07777);
}

/// A link takes no other file's place: where there is one, it is made beside it, to be renamed.
void OutputFile::nameUnnamed() {
    const std::string unnamed = openFile(descriptor_);
    const auto link = [&](const fs::path& name) {
        return linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
    };
    if (link(target_)) return;
    for (int place = 0; errno == EEXIST;) {
        const fs::path name = hiddenName(target_, place);
        if (link(name)) {
            temporary_ = name;
            return;
        }
        if (errno != EEXIST) break;
        if (!removeStale(name)) ++place;
        errno = EEXIST;
    }
    fail(path_, std::strerror(errno));
}

void OutputFile::takePlace() {
    checkPlace();
    keepMode();
    // Some file systems report a full disk or quota only here. EINVAL: nothing to flush there.
    if (fsync(descriptor_) != 0 && errno != EINVAL) fail(path_, std::strerror(errno));
    if (temporary_.empty()) nameUnnamed();
    if (!temporary_.empty() && std::rename(temporary_.c_str(), target_.c_str()) != 0)
        fail(path_, std::strerror(errno));
    temporary_.clear();
    close(descriptor_); // and the lock goes
    descriptor_ = -1;
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
