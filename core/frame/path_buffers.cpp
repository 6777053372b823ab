#include "core/frame/path_buffers.h"

namespace dirt {

namespace {

template <typename... Vectors>
size_t capacityBytes(const Vectors&... vectors) {
    return ((vectors.capacity() * sizeof(typename Vectors::value_type)) + ...);
}

} // namespace

void PathBuffers::resize(size_t pixelCount) {
    radiance.resize(pixelCount);
    throughput.resize(pixelCount);
    pixels.resize(pixelCount);
    rays.resize(pixelCount);
    hits.resize(pixelCount);
    points.resize(pixelCount);
    directions.resize(pixelCount);
    direct.resize(pixelCount);
}

size_t PathBuffers::bytes() const {
    return capacityBytes(radiance, throughput, pixels, rays, hits, points, directions, shadowPaths,
                         shadowRays, shadowMaxT, occluded, direct);
}

} // namespace dirt
