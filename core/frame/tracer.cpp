#include "core/frame/tracer.h"

namespace dirt {

double totalMs(std::span<const PassTime> passes) {
    double sum = 0.0;
    for (const PassTime& pass : passes) sum += pass.ms;
    return sum;
}

} // namespace dirt
