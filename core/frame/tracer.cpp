#include "core/frame/tracer.h"

namespace dirt {

double totalMs(std::span<const PassTime> passes) {
    double sum = 0.0;
    for (const PassTime& pass : passes) sum += pass.ms;
    return sum;
}

uint64_t totalBytes(std::span<const BufferSize> buffers) {
    uint64_t sum = 0;
    for (const auto& [name, bytes] : buffers) sum += bytes;
    return sum;
}

} // namespace dirt
