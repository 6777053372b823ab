#include "backend_gl/triangle_buffer.h"

#include <algorithm>
#include <bit>

namespace dirt {
namespace {

/// Compute shaders see the buffer in pieces, as no driver need allow a storage block above 128 MiB,
/// nor more than 65535 work groups. A piece is 36 MiB: aligned as any driver may ask.
constexpr uint32_t kTrianglesPerPiece = 1u << 20;
constexpr uint32_t kFloats = 9; // of a triangle

uint32_t groups(uint32_t count, uint32_t perGroup) {
    return (count + perGroup - 1) / perGroup;
}

/// A vertex array whose attribute 0 is a vec3 of \p buffer.
GlVertexArray vertexArray(GLuint buffer) {
    GlVertexArray array = makeVertexArray();
    glEnableVertexArrayAttrib(array.id(), 0);
    glVertexArrayAttribFormat(array.id(), 0, 3, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(array.id(), 0, 0);
    glVertexArrayVertexBuffer(array.id(), 0, buffer, 0, 3 * sizeof(float));
    return array;
}

TexelBuffer cornerBuffer(size_t triangles, const void* data) {
    return {GL_RGB32F, sizeof(glm::vec3), triangles * sizeof(Triangle), data,
            "corners of triangles"};
}

void setVector(GLint location, glm::vec3 v) {
    glUniform3f(location, v.x, v.y, v.z);
}

} // namespace

TriangleBuffer::TriangleBuffer(Programs& programs)
    : programs_(programs), nothing_(makeFramebuffer()) {
    glNamedFramebufferParameteri(nothing_.id(), GL_FRAMEBUFFER_DEFAULT_WIDTH, 1);
    glNamedFramebufferParameteri(nothing_.id(), GL_FRAMEBUFFER_DEFAULT_HEIGHT, 1);
}

void TriangleBuffer::transform(const Mesh& mesh, const Camera& camera, ViewMode mode) {
    frame_ = makeUnscaledFrame(camera, mode);
    corners_ = {}; // before the next ones are allocated
    corners_ = cornerBuffer(mesh.triangles.size(), nullptr);
    if (mesh.triangles.empty()) return;

    const GlBuffer positions(mesh.positions.size() * sizeof(glm::vec3), mesh.positions.data());
    const GlBuffer indices(mesh.triangles.size() * sizeof(Corners), mesh.triangles.data());
    const GlVertexArray array = vertexArray(positions.id());
    glVertexArrayElementBuffer(array.id(), indices.id());
    programs_.use(transformSource());
    setVector(0, frame_.eye);
    glUniform1i(1, mode == ViewMode::single);
    setVector(2, frame_.right);
    setVector(3, frame_.down);
    setVector(4, frame_.forward);
    glBindFramebuffer(GL_FRAMEBUFFER, nothing_.id());
    glBindVertexArray(array.id());
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, corners_.buffer());
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(GL_TRIANGLES);
    glDrawElements(GL_TRIANGLES, (GLsizei) mesh.triangles.size() * 3, GL_UNSIGNED_INT, nullptr);
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);

    frame_.scale = scaleFor(largestCoordinate());
    programs_.use(scaleTrianglesSource());
    glUniform1f(1, frame_.scale);
    forEachPiece([](uint32_t, uint32_t count) {
        glUniform1ui(0, count * kFloats);
        glDispatchCompute(groups(count * kFloats, 256), 1, 1);
    });
    glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT |
                    GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

void TriangleBuffer::write(const FrameGeometry& geometry) {
    frame_ = geometry.frame;
    corners_ = {};
    corners_ = cornerBuffer(geometry.triangles.size(), geometry.triangles.data());
}

FrameGeometry TriangleBuffer::read() const {
    FrameGeometry geometry{frame_, std::vector<Triangle>(count())};
    corners_.read(0, corners_.bytes(), geometry.triangles.data());
    return geometry;
}

void TriangleBuffer::draw() const {
    if (count() == 0) return;
    const GlVertexArray array = vertexArray(corners_.buffer());
    glBindVertexArray(array.id());
    glDrawArrays(GL_TRIANGLES, 0, (GLsizei) count() * 3);
}

/// Calls \p dispatch(first triangle, count) with each piece as storage block 0.
template <class Dispatch>
void TriangleBuffer::forEachPiece(const Dispatch& dispatch) const {
    for (uint32_t first = 0; first < count(); first += kTrianglesPerPiece) {
        const uint32_t pieceCount = std::min(kTrianglesPerPiece, count() - first);
        glBindBufferRange(GL_SHADER_STORAGE_BUFFER, 0, corners_.buffer(),
                          (GLintptr) first * (GLintptr) sizeof(Triangle),
                          (GLsizeiptr) pieceCount * (GLsizeiptr) sizeof(Triangle));
        dispatch(first, pieceCount);
    }
}

float TriangleBuffer::largestCoordinate() {
    uint32_t largest = 0;
    const GlBuffer result(sizeof largest, &largest);
    programs_.use(largestCoordinateSource());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, result.id());
    forEachPiece([](uint32_t, uint32_t count) {
        glUniform1ui(0, count * kFloats);
        glDispatchCompute(groups(count * kFloats, 256 * 16), 1, 1);
    });
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    result.read(0, sizeof largest, &largest);
    return std::bit_cast<float>(largest);
}

std::vector<uint32_t> TriangleBuffer::findAtEye() {
    std::vector<uint32_t> ids;
    for (uint32_t room = 1024;;) {
        const uint32_t none = 0;
        const GlBuffer list(sizeof(uint32_t) * (room + 1));
        list.write(0, sizeof none, &none);
        programs_.use(trianglesAtEyeSource());
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, list.id());
        forEachPiece([](uint32_t first, uint32_t count) {
            glUniform1ui(0, count);
            glUniform1ui(1, first);
            glDispatchCompute(groups(count, 64), 1, 1);
        });
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        uint32_t found = 0;
        list.read(0, sizeof found, &found);
        if (found <= room) {
            ids.resize(found);
            list.read(sizeof found, found * sizeof(uint32_t), ids.data());
            std::sort(ids.begin(), ids.end());
            return ids;
        }
        room = found;
    }
}

} // namespace dirt
