#include "core/frame/buffer_size.h"

namespace dirt {

uint64_t totalBytes(std::span<const BufferSize> buffers) {
    uint64_t sum = 0;
    for (const BufferSize& buffer : buffers) sum += buffer.bytes;
    return sum;
}

} // namespace dirt
