#pragma once

#include "backend_gl/gl_objects.h"

#include <cstdint>

namespace dirt {

/// A buffer that shaders read as a texture, one texel after the other.
class TexelBuffer {
public:
    TexelBuffer() = default;
    /// \p what: names the buffer where the driver's textures are too short for it, which throws
    /// InputError.
    TexelBuffer(GLenum format, size_t texelBytes, size_t bytes, const void* data, const char* what);
    /// Over a buffer that is known to be short enough.
    TexelBuffer(GLenum format, GlBuffer buffer);

    GLuint texture() const { return view_.id(); }
    GLuint buffer() const { return buffer_.id(); }
    size_t bytes() const { return buffer_.bytes(); }
    void read(size_t offset, size_t bytes, void* data) const { buffer_.read(offset, bytes, data); }

private:
    GlBuffer buffer_;
    GlTexture view_;
};

/// Throws InputError where a buffer texture cannot have \p texels.
void checkTexelCount(uint64_t texels, const char* what);

} // namespace dirt
