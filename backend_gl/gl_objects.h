#pragma once

#include <cstddef>
#include <utility>

#include <epoxy/gl.h>

namespace dirt {

/// Owns one OpenGL object. Its context must be current where it is made and where it dies.
template <class Kind>
class GlObject {
public:
    GlObject() = default;
    explicit GlObject(GLuint id) : id_(id) {}
    ~GlObject() {
        if (id_) Kind::destroy(id_);
    }
    GlObject(GlObject&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(id_, other.id_);
        return *this;
    }
    GLuint id() const { return id_; }

private:
    GLuint id_ = 0;
};

struct BufferKind {
    static void destroy(GLuint id) { glDeleteBuffers(1, &id); }
};
struct TextureKind {
    static void destroy(GLuint id) { glDeleteTextures(1, &id); }
};
struct FramebufferKind {
    static void destroy(GLuint id) { glDeleteFramebuffers(1, &id); }
};
struct VertexArrayKind {
    static void destroy(GLuint id) { glDeleteVertexArrays(1, &id); }
};

/// A buffer that remembers its size.
class GlBuffer {
public:
    GlBuffer() = default;
    explicit GlBuffer(size_t bytes, const void* data = nullptr) : bytes_(bytes) {
        GLuint id = 0;
        glCreateBuffers(1, &id);
        buffer_ = GlObject<BufferKind>(id);
        // A buffer without bytes cannot be bound.
        glNamedBufferStorage(id, (GLsizeiptr) (bytes ? bytes : 4), bytes ? data : nullptr,
                             GL_DYNAMIC_STORAGE_BIT);
    }
    GLuint id() const { return buffer_.id(); }
    size_t bytes() const { return bytes_; }
    void write(size_t offset, size_t bytes, const void* data) const {
        if (bytes) glNamedBufferSubData(id(), (GLintptr) offset, (GLsizeiptr) bytes, data);
    }
    void read(size_t offset, size_t bytes, void* data) const {
        if (bytes) glGetNamedBufferSubData(id(), (GLintptr) offset, (GLsizeiptr) bytes, data);
    }

private:
    GlObject<BufferKind> buffer_;
    size_t bytes_ = 0;
};

inline GlObject<TextureKind> makeTexture(GLenum target) {
    GLuint id = 0;
    glCreateTextures(target, 1, &id);
    return GlObject<TextureKind>(id);
}
/// Whether the driver has an array texture of that format and size.
inline bool textureFits(int levels, GLenum format, int width, int height, int layers) {
    GLint size = 0, most = 0, found = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
    if (width > size || height > size || layers > most) return false;
    glTexStorage3D(GL_PROXY_TEXTURE_2D_ARRAY, levels, format, width, height, layers);
    glGetTexLevelParameteriv(GL_PROXY_TEXTURE_2D_ARRAY, 0, GL_TEXTURE_WIDTH, &found);
    return found == width;
}

inline GlObject<FramebufferKind> makeFramebuffer() {
    GLuint id = 0;
    glCreateFramebuffers(1, &id);
    return GlObject<FramebufferKind>(id);
}
inline GlObject<VertexArrayKind> makeVertexArray() {
    GLuint id = 0;
    glCreateVertexArrays(1, &id);
    return GlObject<VertexArrayKind>(id);
}

using GlTexture = GlObject<TextureKind>;
using GlFramebuffer = GlObject<FramebufferKind>;
using GlVertexArray = GlObject<VertexArrayKind>;

} // namespace dirt
