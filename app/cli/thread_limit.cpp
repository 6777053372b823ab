#include "app/cli/thread_limit.h"

#include "backend_cpu/thread_pool.h"

#include <algorithm>
#include <cstdlib>
#include <thread>

#include <OpenImageIO/imageio.h>

namespace dirt {

void spareThreads() {
    // OpenImageIO, OpenEXR and Mesa each make as many as there are cores, Mesa some more.
    constexpr unsigned kMore = 8;
    const unsigned wanted = 2 * std::max(1u, std::thread::hardware_concurrency()) + kMore;
    if (ThreadPool(wanted).missing() == 0) return;
    // Not "threads": to set that makes OpenImageIO's own, which the images here do not need.
    OIIO::attribute("exr_threads", -1);
    setenv("LP_NUM_THREADS", "0", 1);               // Mesa's rasterizer
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1); // which is written by a thread
}

} // namespace dirt
