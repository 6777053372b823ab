#pragma once

#include "core/frame/buffer_size.h"
#include "core/frame/point_buffer.h"
#include "core/frame/requirements.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

/// The state of all paths of one sample, and the image: one record per image pixel, row-major.
/// A buffer that the frame does not require is empty. Between Shade and the shift of path event k
/// the three points are G[k-1], G[k] and G[k+1].
struct PathBuffers {
    std::vector<SurfacePoint> previous, current, next; ///< shading buffer, in full or
    /// packed, where the frame asks for that and a backend on the host keeps it; what is read from
    /// a backend, or written to it, is in full.
    PackedPoints packedPrevious, packedCurrent, packedNext;
    std::vector<uint8_t> mask; ///< 1: the pixel's path is alive
    std::vector<PathRay> rays;
    std::vector<Hit> hits;
    std::vector<uint8_t> visibility; ///< 1: the light reaches the newest point, and it matters
    std::vector<glm::vec3> radiance; ///< what the sample has gathered
    std::vector<glm::vec3> image;    ///< sum of the finished samples

    /// The records of one pixel alone.
    PathBuffers only(size_t pixel) const;

    /// Room for what \p requirements ask for; everything empty.
    void allocate(const Requirements& requirements, size_t pixels);

    /// The same with the three points in full, or packed.
    PathBuffers unpacked(const FrameGeometry& geometry) const;
    PathBuffers packed(const PointFormat& format, const FrameGeometry& geometry) const;

    /// Whether \p pixel has G[k], G[k+1].
    bool foundCurrent(size_t pixel) const {
        return packedCurrent.empty() ? current[pixel].found() : packedCurrent.found(pixel);
    }
    bool foundNext(size_t pixel) const {
        return packedNext.empty() ? next[pixel].found() : packedNext.found(pixel);
    }
    /// Makes \p point G[k+1] of \p pixel; \p geometry has its triangle.
    void setNext(size_t pixel, const SurfacePoint& point, const FrameGeometry& geometry) {
        if (packedNext.empty())
            next[pixel] = point;
        else
            packedNext.set(pixel, packPoint(point, geometry));
    }
    void clearNext(size_t pixel) {
        if (packedNext.empty())
            next[pixel] = {};
        else
            packedNext.set(pixel, {});
    }

    size_t pixels() const { return radiance.size(); }

    /// Bytes of each buffer that is not empty.
    std::vector<BufferSize> sizes() const;

    /// Whether the path of \p pixel takes part in path event \p event.
    bool alive(int event, size_t pixel) const { return event == 0 || mask[pixel] != 0; }
};

} // namespace dirt
