#include "app/cli/clamped_radiance.h"

#include "shaders/shared/radiance.h"

#include <cstdio>

namespace dirt {

void noteClamped(const RenderResult& result, bool quiet) {
    if (quiet || result.counts.clamped == 0) return;
    const uint64_t all = (uint64_t) result.image.pixels.size() * (uint64_t) result.samples;
    std::fprintf(stderr,
                 "dirt: warning: the radiance of %llu of %llu samples of pixels is beyond what is "
                 "kept, and was clamped to %g\n",
                 (unsigned long long) result.counts.clamped, (unsigned long long) all,
                 (double) kMostRadiance);
}

} // namespace dirt
