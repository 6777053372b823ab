#include "core/io/memory_file.h"

#include "core/base/error.h"

#include <cerrno>
#include <cstring>

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

namespace dirt {

namespace {

[[noreturn]] void fail(int error) {
    throw InputError(std::string("cannot encode in memory: ") + std::strerror(error));
}

} // namespace

MemoryFile::MemoryFile() : descriptor_(memfd_create("dirt", MFD_CLOEXEC)) {
    if (descriptor_ < 0) fail(errno);
    name_ = "/proc/self/fd/" + std::to_string(descriptor_);
}

MemoryFile::~MemoryFile() {
    close(descriptor_);
}

size_t MemoryFile::size() const {
    struct stat status {};
    if (fstat(descriptor_, &status) != 0) fail(errno);
    return (size_t) status.st_size;
}

bool MemoryFile::cutShort() const {
    rlimit limit{};
    return getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY &&
           size() >= limit.rlim_cur;
}

std::vector<std::byte> MemoryFile::contents() const {
    std::vector<std::byte> bytes(size());
    for (size_t done = 0; done < bytes.size();) {
        const ssize_t count =
            pread(descriptor_, bytes.data() + done, bytes.size() - done, (off_t) done);
        if (count <= 0 && errno != EINTR) fail(count < 0 ? errno : EIO);
        if (count > 0) done += (size_t) count;
    }
    return bytes;
}

} // namespace dirt
