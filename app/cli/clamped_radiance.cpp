#include "app/cli/clamped_radiance.h"

#include "app/cli/log.h"
#include "shaders/shared/radiance.h"

#include <cstdio>

namespace dirt {

void noteClamped(const RenderResult& result, bool quiet) {
    if (result.counts.clamped == 0) return;
    const uint64_t all = (uint64_t) result.image.pixels.size() * (uint64_t) result.samples;
    char text[256];
    std::snprintf(text, sizeof text,
                  "the radiance of %llu of %llu samples of pixels is beyond what is kept, and was "
                  "clamped to %g",
                  (unsigned long long) result.counts.clamped, (unsigned long long) all,
                  (double) kMostRadiance);
    sayWarning(text, quiet);
}

} // namespace dirt
