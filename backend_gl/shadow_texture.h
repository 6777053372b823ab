#pragma once

#include "backend_gl/scene_buffers.h"
#include "backend_gl/triangle_buffer.h"
#include "shaders/shared/shadow_map.h"

#include <vector>

namespace dirt {

/// The light's shadow map on the device: core/frame/shadow_raster.h, bit for bit, as rectangles are
/// drawn in which each texel is decided exactly.
class ShadowMapTexture {
public:
    explicit ShadowMapTexture(Programs& programs) : programs_(programs) {}

    /// Room for \p resolution texels along a side; 0: none. Throws InputError where the driver
    /// cannot draw that many.
    void allocate(uint32_t resolution);

    /// Needs uniform block 1, which says what the light sees.
    void draw(const TriangleBuffer& triangles, const SceneBuffers& scene) const;
    /// As texture 5, for Shade.
    void bind() const { glBindTextureUnit(5, texture_.id()); }

    std::vector<float> read() const;
    void write(const std::vector<float>& depths) const;
    uint64_t bytes() const { return (uint64_t) resolution_ * resolution_ * sizeof(float); }

private:
    Programs& programs_;
    uint32_t resolution_ = 0;
    GlTexture texture_;
    GlFramebuffer framebuffer_;
};

} // namespace dirt
