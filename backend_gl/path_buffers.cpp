#include "backend_gl/path_buffers.h"

#include "backend_gl/groups.h"
#include "core/base/error.h"

#include <algorithm>
#include <cassert>

namespace dirt {
namespace {

// Of include/paths.glsl.
enum Block : GLuint { kRays, kHits, kCurrent, kNext, kRadiance, kImage };
enum ImageUnit : GLuint { kMask = 2, kVisibility = 3 };

/// Room for \p pixels records; a buffer of the right size stays.
void make(GlBuffer& buffer, bool wanted, size_t record, size_t pixels) {
    const size_t bytes = wanted ? record * pixels : 0;
    if (buffer.id() && buffer.bytes() == bytes) return;
    buffer = {}; // before the next one is allocated
    buffer = GlBuffer(bytes);
}

GlTexture viewOfBytes(const GlBuffer& buffer) {
    GlTexture view = makeTexture(GL_TEXTURE_BUFFER);
    glTextureBuffer(view.id(), GL_R8UI, buffer.id());
    return view;
}

template <typename T>
std::vector<T> readAll(const GlBuffer& buffer) {
    std::vector<T> values(buffer.bytes() / sizeof(T));
    buffer.read(0, buffer.bytes(), values.data());
    return values;
}

template <typename T>
void writeAll(const GlBuffer& buffer, const std::vector<T>& values) {
    assert(values.size() * sizeof(T) == buffer.bytes());
    buffer.write(0, std::min(values.size() * sizeof(T), buffer.bytes()), values.data());
}

void clearToZero(const GlBuffer& buffer) {
    glClearNamedBufferData(buffer.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

BufferRange rangeOf(const GlBuffer& buffer, size_t record, uint32_t first, uint32_t count) {
    // Something has to be bound where there is no buffer, though it is not touched.
    if (buffer.bytes() == 0) return {buffer.id(), 0, 4};
    return {buffer.id(), first * record, count * record};
}

} // namespace

GlPathBuffers::GlPathBuffers(Programs& programs) : programs_(programs) {}

void GlPathBuffers::allocate(const Requirements& need, size_t pixels) {
    GLint most = 0; // texels of a buffer texture
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
    if (pixels > (size_t) most)
        throw InputError("--size: this OpenGL driver has buffers for " + std::to_string(most) +
                         " pixels at most");
    pixels_ = pixels;
    const bool searches = need.indirect || need.tracedPrimary;
    format_ = pointFormatOf(need);
    make(previous_, need.previousPoint, format_.bytes(), pixels);
    make(current_, need.indirect || need.previousPoint, format_.bytes(), pixels);
    make(next_, true, format_.bytes(), pixels);
    make(mask_, need.indirect, sizeof(uint8_t), pixels);
    make(rays_, searches, sizeof(PathRay), pixels);
    make(hits_, searches, sizeof(Hit), pixels);
    make(visibility_, need.shadowRays, sizeof(uint8_t), pixels);
    make(radiance_, true, sizeof(glm::vec3), pixels);
    make(image_, true, sizeof(glm::vec3), pixels);
    maskView_ = viewOfBytes(mask_);
    visibilityView_ = viewOfBytes(visibility_);

    for (const GlBuffer* buffer : {&mask_, &visibility_})
        glClearNamedBufferData(buffer->id(), GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, nullptr);
    for (const GlBuffer* buffer : {&radiance_, &image_}) clearToZero(*buffer);
    programs_.use(clearPathsSource(format_, searches, current_.bytes() > 0));
    dispatch();
    if (previous_.bytes() > 0)
        glCopyNamedBufferSubData(next_.id(), previous_.id(), 0, 0, (GLsizeiptr) next_.bytes());
}

PathBuffers GlPathBuffers::read() const {
    PathBuffers paths;
    if (format_.packed()) {
        paths.packedPrevious = {format_, readAll<uint32_t>(previous_)};
        paths.packedCurrent = {format_, readAll<uint32_t>(current_)};
        paths.packedNext = {format_, readAll<uint32_t>(next_)};
    } else {
        paths.previous = readAll<SurfacePoint>(previous_);
        paths.current = readAll<SurfacePoint>(current_);
        paths.next = readAll<SurfacePoint>(next_);
    }
    paths.mask = readAll<uint8_t>(mask_);
    paths.rays = readAll<PathRay>(rays_);
    paths.hits = readAll<Hit>(hits_);
    paths.visibility = readAll<uint8_t>(visibility_);
    paths.radiance = readAll<glm::vec3>(radiance_);
    paths.image = readImage();
    return paths;
}

std::vector<SurfacePoint> GlPathBuffers::readPoints() const {
    if (format_.packed()) return {};
    return readAll<SurfacePoint>(next_);
}

PackedPoints GlPathBuffers::readPackedPoints() const {
    if (!format_.packed()) return {};
    return {format_, readAll<uint32_t>(next_)};
}

std::vector<glm::vec3> GlPathBuffers::readRadiance() const {
    return readAll<glm::vec3>(radiance_);
}

std::vector<glm::vec3> GlPathBuffers::readImage() const {
    return readAll<glm::vec3>(image_);
}

void GlPathBuffers::write(const PathBuffers& paths) {
    if (format_.packed()) {
        writeAll(previous_, paths.packedPrevious.words());
        writeAll(current_, paths.packedCurrent.words());
        writeAll(next_, paths.packedNext.words());
    } else {
        writeAll(previous_, paths.previous);
        writeAll(current_, paths.current);
        writeAll(next_, paths.next);
    }
    writeAll(mask_, paths.mask);
    writeAll(rays_, paths.rays);
    writeAll(hits_, paths.hits);
    writeAll(visibility_, paths.visibility);
    writeAll(radiance_, paths.radiance);
    writeAll(image_, paths.image);
}

void GlPathBuffers::clearRadiance() const {
    clearToZero(radiance_);
}

void GlPathBuffers::shift() {
    if (current_.bytes() == 0) return;
    if (previous_.bytes() > 0) std::swap(previous_, current_);
    std::swap(current_, next_);
}

std::vector<BufferSize> GlPathBuffers::sizes() const {
    std::vector<BufferSize> sizes;
    const auto add = [&sizes](const char* name, const GlBuffer& buffer) {
        if (buffer.bytes() > 0) sizes.emplace_back(name, buffer.bytes());
    };
    add("shading buffer G[k-1]", previous_);
    add("shading buffer G[k]", current_);
    add("shading buffer G[k+1]", next_);
    add("mask", mask_);
    add("rays", rays_);
    add("hit buffer", hits_);
    add("visibility", visibility_);
    add("radiance", radiance_);
    add("image", image_);
    return sizes;
}

BufferRange GlPathBuffers::rays(uint32_t first, uint32_t count) const {
    return rangeOf(rays_, sizeof(PathRay), first, count);
}

BufferRange GlPathBuffers::hits(uint32_t first, uint32_t count) const {
    return rangeOf(hits_, sizeof(Hit), first, count);
}

void GlPathBuffers::bind(uint32_t first, uint32_t count) const {
    rays(first, count).bind(kRays);
    hits(first, count).bind(kHits);
    rangeOf(current_, format_.bytes(), first, count).bind(kCurrent);
    rangeOf(next_, format_.bytes(), first, count).bind(kNext);
    rangeOf(radiance_, sizeof(glm::vec3), first, count).bind(kRadiance);
    rangeOf(image_, sizeof(glm::vec3), first, count).bind(kImage);
    glBindImageTexture(kMask, maskView_.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R8UI);
    glBindImageTexture(kVisibility, visibilityView_.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R8UI);
    glUniform1ui(0, first);
    glUniform1ui(1, count);
}

void GlPathBuffers::dispatch() const {
    for (size_t first = 0; first < pixels_; first += kPixelsPerPiece) {
        const auto count = (uint32_t) std::min<size_t>(kPixelsPerPiece, pixels_ - first);
        bind((uint32_t) first, count);
        glDispatchCompute(groupsOf(count), 1, 1);
    }
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                    GL_TEXTURE_FETCH_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

} // namespace dirt
