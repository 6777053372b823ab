#include "core/io/opened_file.h"

#include "core/io/load_report.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/statfs.h>
#include <unistd.h>

namespace dirt {

namespace {

/// What is there, where it is no ordinary file; null where it is one.
const char* kindOf(const struct stat& status) {
    switch (status.st_mode & S_IFMT) {
    case S_IFREG:
        return nullptr;
    case S_IFDIR:
        return "is a folder, not a file";
    case S_IFIFO:
        return "is a FIFO, not a file";
    case S_IFSOCK:
        return "is a socket, not a file";
    case S_IFBLK:
    case S_IFCHR:
        return "is a device, not a file";
    default:
        return "is not a regular file";
    }
}

/// Whether the kernel makes the file up while it is read.
bool isMadeUp(const struct statfs& system) {
    constexpr long kMadeUp[] = {PROC_SUPER_MAGIC,    SYSFS_MAGIC,        DEBUGFS_MAGIC,
                                TRACEFS_MAGIC,       SECURITYFS_MAGIC,   CGROUP_SUPER_MAGIC,
                                CGROUP2_SUPER_MAGIC, BPF_FS_MAGIC,       PSTOREFS_MAGIC,
                                EFIVARFS_MAGIC,      DEVPTS_SUPER_MAGIC, BINFMTFS_MAGIC};
    return std::find(std::begin(kMadeUp), std::end(kMadeUp), (long) system.f_type) !=
           std::end(kMadeUp);
}

constexpr const char* kMadeUpText = "is made up by the kernel, not a file";

} // namespace

void refuseSpecialFile(const std::filesystem::path& file) {
    struct stat status {};
    if (stat(file.c_str(), &status) != 0 || S_ISDIR(status.st_mode)) return;
    if (const char* kind = kindOf(status)) failAt(file, 0, kind);
    struct statfs system {};
    if (statfs(file.c_str(), &system) == 0 && isMadeUp(system)) failAt(file, 0, kMadeUpText);
}

OpenedFile::OpenedFile(const std::filesystem::path& file) : file_(file) {
    struct stat status {};
    if (stat(file.c_str(), &status) != 0) {
        if (errno == ENOENT || errno == ENOTDIR) failAt(file, 0, "no such file");
        failAt(file, 0, std::string("cannot be opened: ") + std::strerror(errno));
    }
    if (const char* kind = kindOf(status)) failAt(file, 0, kind);
    // Something else may have taken its place since.
    descriptor_ = open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (descriptor_ < 0) failAt(file, 0, std::string("cannot be opened: ") + std::strerror(errno));
    struct statfs system {};
    const char* kind = nullptr;
    if (fstat(descriptor_, &status) != 0 || fstatfs(descriptor_, &system) != 0)
        kind = "cannot be read";
    else
        kind = isMadeUp(system) ? kMadeUpText : kindOf(status);
    if (kind) {
        close(descriptor_);
        failAt(file, 0, kind);
    }
    size_ = (size_t) status.st_size;
}

OpenedFile::~OpenedFile() {
    close(descriptor_);
}

size_t OpenedFile::read(char* to, size_t count) const {
    ssize_t done = 0;
    do done = ::read(descriptor_, to, count);
    while (done < 0 && errno == EINTR);
    if (done < 0) failAt(file_, 0, std::string("cannot be read: ") + std::strerror(errno));
    return (size_t) done;
}

} // namespace dirt
