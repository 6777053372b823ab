#pragma once

#include "backend_gl/programs.h"
#include "core/frame/path_buffers.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace dirt {

/// A part of a buffer, as a storage block sees it.
struct BufferRange {
    GLuint buffer = 0;
    size_t offset = 0, bytes = 0;

    void bind(GLuint block) const {
        glBindBufferRange(GL_SHADER_STORAGE_BUFFER, block, buffer, (GLintptr) offset,
                          (GLsizeiptr) bytes);
    }
};

/// PathBuffers on the device, in the same layouts. Shaders see them as include/paths.glsl
/// declares: records as storage blocks, in pieces, as no driver need allow a block above 128 MiB;
/// the bytes of mask and visibility as images of buffers, whole.
class GlPathBuffers {
public:
    /// Pixels of the longest piece, such that any piece begins where any driver allows a block to.
    static constexpr uint32_t kPixelsPerPiece = 1u << 20;

    explicit GlPathBuffers(Programs& programs);

    /// Room for what \p requirements ask for; everything empty. Throws InputError where the driver
    /// has no buffers of that size.
    void allocate(const Requirements& requirements, size_t pixels);

    /// As they are kept: the points in full or packed.
    PathBuffers read() const;
    const PointFormat& format() const { return format_; }
    /// \p paths: the buffers that there are, all of them, as they are kept.
    void write(const PathBuffers& paths);
    /// The newest points, G[k+1]: one of the two has them, the other is empty.
    std::vector<SurfacePoint> readPoints() const;
    PackedPoints readPackedPoints() const;
    std::vector<glm::vec3> readRadiance() const;
    std::vector<glm::vec3> readImage() const;

    /// Clears what the sample has gathered.
    void clearRadiance() const;
    /// Shifts the three points left.
    void shift();

    size_t pixels() const { return pixels_; }
    std::vector<BufferSize> sizes() const;

    /// Binds what \p first … \p first + \p count is of each buffer.
    void bind(uint32_t first, uint32_t count) const;
    /// The same of rays and hits alone, for the search.
    BufferRange rays(uint32_t first, uint32_t count) const;
    BufferRange hits(uint32_t first, uint32_t count) const;
    /// A buffer texture of the mask; 0 where there is none.
    GLuint mask() const { return mask_.bytes() > 0 ? maskView_.id() : 0; }

    /// Dispatches the current program over all pixels, piece by piece: uniforms 0 and 1 are the
    /// first pixel and the number of a piece's pixels.
    void dispatch() const;

private:
    Programs& programs_;
    size_t pixels_ = 0;
    PointFormat format_;
    GlBuffer previous_, current_, next_, mask_, rays_, hits_, visibility_, radiance_, image_;
    GlTexture maskView_, visibilityView_;
};

} // namespace dirt
