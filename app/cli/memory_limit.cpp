#include "app/cli/memory_limit.h"

#include "core/frame/path_buffers.h"
#include "core/io/error.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <string>

#include <unistd.h>

namespace dirt {

namespace {

/// What every frame has, whatever the scene requires besides: an estimate from below.
constexpr uint64_t kBytesPerPixel = PackedPoints::kLeastBytes + 2 * sizeof(glm::vec3);
/// Depth bounds, and a third more for the pyramid.
constexpr uint64_t kBytesPerTile = 11;
/// One head of a list.
constexpr uint64_t kBytesPerCell = 4;

uint64_t structureBytes(const GridSettings& s, int tile) {
    const auto tiles = [tile](int pixels) { return (uint64_t) (pixels + tile - 1) / tile; };
    const int face = s.viewSize > 0 ? s.viewSize : s.height;
    const uint64_t count =
        s.mode == ViewMode::full ? 6 * tiles(face) * tiles(face) : tiles(s.width) * tiles(s.height);
    return count * (kBytesPerTile + (uint64_t) s.bins * kBytesPerCell);
}

std::string gigabytes(uint64_t bytes) {
    const uint64_t tenths = bytes / 100'000'000;
    return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " GB";
}

} // namespace

uint64_t availableMemory() {
    uint64_t bytes = std::numeric_limits<uint64_t>::max();
    const long pages = sysconf(_SC_PHYS_PAGES), page = sysconf(_SC_PAGE_SIZE);
    if (pages > 0 && page > 0) bytes = (uint64_t) pages * (uint64_t) page;
    uint64_t limit = 0;
    if (std::ifstream("/sys/fs/cgroup/memory.max") >> limit) bytes = std::min(bytes, limit);
    return bytes;
}

void checkMemory(const GridSettings& s, uint64_t available) {
    const uint64_t image = (uint64_t) s.width * (uint64_t) s.height * kBytesPerPixel;
    if (image > available)
        throw InputError("an image of " + std::to_string(s.width) + "x" + std::to_string(s.height) +
                         " pixels needs more than " + gigabytes(image) + " of memory; there are " +
                         gigabytes(available));

    const uint64_t structure = structureBytes(s, s.tile);
    if (image + structure <= available) return;
    int fits = s.tile;
    while (fits < 64 && image + structureBytes(s, fits) > available / 2) ++fits;
    throw InputError("--tile " + std::to_string(s.tile) + " --bins " + std::to_string(s.bins) +
                     ": the structure needs more than " + gigabytes(structure) +
                     " of memory; there are " + gigabytes(available) + " (--tile " +
                     std::to_string(fits) + " would fit)");
}

} // namespace dirt
