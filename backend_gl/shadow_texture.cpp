#include "backend_gl/shadow_texture.h"

#include "backend_gl/ordinary_raster.h"
#include "core/base/error.h"

#include <algorithm>
#include <string>

namespace dirt {

void ShadowMapTexture::allocate(uint32_t resolution) {
    if (resolution == resolution_) return;
    GLint size = 0, viewport[2] = {};
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    const int most = std::min({size, viewport[0], viewport[1]});
    if (resolution > (uint32_t) most)
        throw InputError("the light's resolution is " + std::to_string(resolution) +
                         ": this OpenGL driver draws shadow maps of " + std::to_string(most) +
                         " texels at most (--visibility traced needs none)");
    resolution_ = resolution;
    framebuffer_ = {};
    texture_ = {}; // before the next one is allocated
    if (resolution == 0) return;
    texture_ = makeTexture(GL_TEXTURE_2D);
    glTextureStorage2D(texture_.id(), 1, GL_R32F, (GLsizei) resolution, (GLsizei) resolution);
    glTextureParameteri(texture_.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(texture_.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    framebuffer_ = makeFramebuffer();
    glNamedFramebufferTexture(framebuffer_.id(), GL_COLOR_ATTACHMENT0, texture_.id(), 0);
}

void ShadowMapTexture::draw(const TriangleBuffer& triangles, const SceneBuffers& scene) const {
    const OrdinaryRaster ordinary;
    const float nothing[4] = {kNothingCasts, 0.0f, 0.0f, 0.0f};
    glClearNamedFramebufferfv(framebuffer_.id(), GL_COLOR, 0, nothing);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, (GLsizei) resolution_, (GLsizei) resolution_);
    glEnable(GL_BLEND);
    glBlendEquation(GL_MIN);
    programs_.use(shadowMapSource(scene.variant()));
    scene.bind();
    glBindTextureUnit(3, triangles.texture());
    triangles.draw();
    glDisable(GL_BLEND);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

std::vector<float> ShadowMapTexture::read() const {
    std::vector<float> depths(bytes() / sizeof(float));
    if (!depths.empty())
        glGetTextureImage(texture_.id(), 0, GL_RED, GL_FLOAT, (GLsizei) bytes(), depths.data());
    return depths;
}

void ShadowMapTexture::write(const std::vector<float>& depths) const {
    if (depths.empty()) return;
    glTextureSubImage2D(texture_.id(), 0, 0, 0, (GLsizei) resolution_, (GLsizei) resolution_,
                        GL_RED, GL_FLOAT, depths.data());
}

} // namespace dirt
