#pragma once

#include "backend_gl/path_buffers.h"
#include "backend_gl/scene_buffers.h"
#include "backend_gl/triangle_buffer.h"
#include "core/frame/passes.h"

namespace dirt {

/// DirectVisibility by ordinary rasterization: the primitive that each pixel sees, then its point.
/// The visible surface may be another than a traced ray's only where the ray passes an edge within
/// 1/128 of a pixel.
class DirectVisibility {
public:
    explicit DirectVisibility(Programs& programs) : programs_(programs) {}

    /// Room for the image. Throws InputError where the driver cannot draw one of that size.
    void allocate(int width, int height);

    /// G[1] of all pixels, as seen through the sample's sub-pixel \p offset. Needs uniform block 1.
    /// Says how many see something.
    uint64_t run(const TriangleBuffer& triangles, const SceneBuffers& scene,
                 const ImagePlane& plane, glm::vec2 offset, const GlPathBuffers& paths);

    uint64_t bytes() const { return (uint64_t) width_ * (uint64_t) height_ * 8; }

private:
    Programs& programs_;
    int width_ = 0, height_ = 0;
    GlTexture primitives_, depths_;
    GlFramebuffer framebuffer_;
};

} // namespace dirt
