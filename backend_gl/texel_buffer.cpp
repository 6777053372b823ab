#include "backend_gl/texel_buffer.h"

#include "core/base/error.h"

#include <string>

namespace dirt {

void checkTexelCount(uint64_t texels, const char* what) {
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    if (texels > (uint64_t) most)
        throw InputError("--backend gl: " + std::to_string(texels) + " " + what +
                         " are more than this OpenGL driver's buffer textures hold (" +
                         std::to_string(most) + ")");
}

TexelBuffer::TexelBuffer(GLenum format, size_t texelBytes, size_t bytes, const void* data,
                         const char* what) {
    checkTexelCount(bytes / texelBytes, what);
    *this = TexelBuffer(format, GlBuffer(bytes, data));
}

TexelBuffer::TexelBuffer(GLenum format, GlBuffer buffer)
    : buffer_(std::move(buffer)), view_(makeTexture(GL_TEXTURE_BUFFER)) {
    glTextureBuffer(view_.id(), format, buffer_.id());
}

} // namespace dirt
