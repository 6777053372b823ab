#include "backend_gl/direct_visibility.h"

#include "backend_gl/ordinary_raster.h"
#include "core/base/error.h"

#include <algorithm>
#include <string>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace dirt {
namespace {

constexpr GLuint kFound = 7; // storage block of first_points.comp

/// From the grid frame to the clip space's x, y and w, such that pixel (i, j)'s centre is the point
/// (i, j) + \p offset of the image.
glm::dmat3 toClip(const ImagePlane& plane, int width, int height, glm::vec2 offset) {
    const glm::dmat3 axes(plane.right, plane.down, plane.forward);
    // From slopes to pixels, shifted by half a pixel less the offset, to [-1, 1].
    const auto scale = [](double step, int size) { return 2.0 / (step * size); };
    const auto shift = [](double slope, double step, double at, int size) {
        return 2.0 * (-slope / step + 0.5 - at) / size - 1.0;
    };
    const glm::dmat3 project(scale(plane.stepX, width), 0.0, 0.0, 0.0, scale(plane.stepY, height),
                             0.0, shift(plane.slopeX, plane.stepX, offset.x, width),
                             shift(plane.slopeY, plane.stepY, offset.y, height), 1.0);
    return project * glm::inverse(axes);
}

} // namespace

void DirectVisibility::allocate(int width, int height) {
    if (width == width_ && height == height_) return;
    GLint size = 0, viewport[2] = {};
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    const int widest = std::min(size, viewport[0]), highest = std::min(size, viewport[1]);
    if (width > widest || height > highest)
        throw InputError("--size: this OpenGL driver draws " + std::to_string(widest) + "x" +
                         std::to_string(highest) +
                         " pixels at most (--primary traced needs no drawing)");
    width_ = width;
    height_ = height;
    framebuffer_ = makeFramebuffer();
    const auto attach = [&](GlTexture& texture, GLenum format, GLenum attachment) {
        texture = {}; // before the next one is allocated
        texture = makeTexture(GL_TEXTURE_2D);
        glTextureStorage2D(texture.id(), 1, format, width, height);
        glTextureParameteri(texture.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTextureParameteri(texture.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glNamedFramebufferTexture(framebuffer_.id(), attachment, texture.id(), 0);
    };
    attach(primitives_, GL_R32UI, GL_COLOR_ATTACHMENT0);
    attach(depths_, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
}

uint64_t DirectVisibility::run(const TriangleBuffer& triangles, const SceneBuffers& scene,
                               const ImagePlane& plane, glm::vec2 offset,
                               const GlPathBuffers& paths) {
    const OrdinaryRaster ordinary;
    const GLuint nothing[4] = {kNoPrimitive, 0, 0, 0};
    const float farthest = 1.0f;
    glClearNamedFramebufferuiv(framebuffer_.id(), GL_COLOR, 0, nothing);
    glClearNamedFramebufferfv(framebuffer_.id(), GL_DEPTH, 0, &farthest);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, width_, height_);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS); // at equal depth the first: the lowest id
    programs_.use(directVisibilitySource(scene.variant()));
    scene.bind();
    const glm::dmat3 matrix = toClip(plane, width_, height_, offset);
    glUniformMatrix3dv(2, 1, GL_FALSE, &matrix[0][0]);
    glBindTextureUnit(3, triangles.texture());
    triangles.draw();
    glDisable(GL_DEPTH_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);

    uint32_t found = 0;
    const GlBuffer counter(sizeof found, &found);
    programs_.use(firstPointsSource(paths.format(), scene.variant()));
    scene.bind();
    glBindTextureUnit(4, primitives_.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kFound, counter.id());
    paths.dispatch();
    counter.read(0, sizeof found, &found);
    return found;
}

} // namespace dirt
