#pragma once

#include "backend_gl/programs.h"
#include "backend_gl/texel_buffer.h"
#include "core/grid/geometry.h"

#include <cstdint>
#include <vector>

namespace dirt {

/// The triangle buffer on the device: nine floats a triangle, in the grid frame.
class TriangleBuffer {
public:
    explicit TriangleBuffer(Programs& programs);

    /// Brings \p mesh into the grid frame, on the device. Throws InputError where it does not fit
    /// into float32.
    void transform(const Mesh& mesh, const Camera& camera, ViewMode mode);
    void write(const FrameGeometry& geometry);
    FrameGeometry read() const;

    /// Draws all triangles; a primitive's number is its id, its corners are attribute 0.
    void draw() const;

    /// The ids of the triangles that hold the eye, in increasing order.
    std::vector<uint32_t> findAtEye();

    /// A buffer texture: three texels a triangle.
    GLuint texture() const { return corners_.texture(); }
    const GridFrame& frame() const { return frame_; }

    uint64_t bytes() const { return corners_.bytes(); }
    uint32_t count() const { return (uint32_t) (corners_.bytes() / sizeof(Triangle)); }

private:
    float largestCoordinate();
    template <class Dispatch>
    void forEachPiece(const Dispatch& dispatch) const;

    Programs& programs_;
    GridFrame frame_;
    TexelBuffer corners_;
    GlFramebuffer nothing_; ///< without a display, even drawing nothing needs somewhere to draw
};

} // namespace dirt
