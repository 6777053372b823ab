#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace dirt {

/// A named buffer of a backend, for the memory table.
struct BufferSize {
    std::string name;
    uint64_t bytes; ///< allocated
    uint64_t used;  ///< of them, by the frame at hand; all, where a buffer is made to measure

    BufferSize(std::string buffer, uint64_t allocated)
        : BufferSize(std::move(buffer), allocated, allocated) {}
    BufferSize(std::string buffer, uint64_t allocated, uint64_t usedOfIt)
        : name(std::move(buffer)), bytes(allocated), used(usedOfIt) {}
};

/// Allocated.
uint64_t totalBytes(std::span<const BufferSize> buffers);

} // namespace dirt
