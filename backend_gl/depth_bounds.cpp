#include "backend_gl/depth_bounds.h"

#include <algorithm>
#include <bit>

namespace dirt {
namespace {

constexpr uint32_t kGroup = 8; // of fill_depth_mipmap.comp, along x and y

int atLevel(int size, int level) {
    return std::max(size >> level, 1);
}

int paddedSize(int tiles) {
    return (int) std::bit_ceil((unsigned) tiles);
}

int levelCount(int width, int height) {
    return std::bit_width((unsigned) std::max(width, height));
}

} // namespace

bool DepthBoundsTexture::fits(int columns, int rows, int views) {
    const int width = paddedSize(columns), height = paddedSize(rows);
    return textureFits(levelCount(width, height), GL_RG32F, width, height, views);
}

void DepthBoundsTexture::clear(const Grid& grid) {
    const int columns = grid.views[0].columns, rows = grid.views[0].rows;
    const int views = (int) grid.views.size();
    if (columns != columns_ || rows != rows_ || views != views_) {
        columns_ = columns;
        rows_ = rows;
        views_ = views;
        width_ = paddedSize(columns);
        height_ = paddedSize(rows);
        levels_ = levelCount(width_, height_);
        framebuffer_ = {};
        texture_ = {}; // before the next one is allocated
        texture_ = makeTexture(GL_TEXTURE_2D_ARRAY);
        glTextureStorage3D(texture(), levels_, GL_RG32F, width_, height_, views_);
        glTextureParameteri(texture(), GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
        glTextureParameteri(texture(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        framebuffer_ = makeFramebuffer();
        glNamedFramebufferTexture(framebuffer_.id(), GL_COLOR_ATTACHMENT0, texture(), 0);
    }
    const float empty[2] = {-FLT_MAX, -FLT_MAX};
    for (int level = 0; level < levels_; ++level)
        glClearTexImage(texture(), level, GL_RG, GL_FLOAT, empty);
}

void DepthBoundsTexture::fill(const TriangleBuffer& triangles, ViewMode mode, Proposal proposal) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, columns_, rows_);
    glEnable(GL_BLEND);
    glBlendEquation(GL_MAX);
    programs_.use(fillDepthSource(mode, proposal));
    triangles.draw();
    glDisable(GL_BLEND);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void DepthBoundsTexture::buildPyramid() {
    programs_.use(fillDepthMipmapSource());
    const auto groups = [](int size) { return ((uint32_t) size + kGroup - 1) / kGroup; };
    for (int level = 1; level < levels_; ++level) {
        glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        glBindImageTexture(0, texture(), level - 1, GL_TRUE, 0, GL_READ_ONLY, GL_RG32F);
        glBindImageTexture(1, texture(), level, GL_TRUE, 0, GL_WRITE_ONLY, GL_RG32F);
        glDispatchCompute(groups(atLevel(width_, level)), groups(atLevel(height_, level)),
                          (GLuint) views_);
    }
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT |
                    GL_FRAMEBUFFER_BARRIER_BIT);
}

void DepthBoundsTexture::read(Grid& grid) const {
    for (int view = 0; view < views_; ++view) {
        DepthPyramid& pyramid = grid.pyramids[(size_t) view];
        pyramid.levels.clear();
        for (int level = 0; level < levels_; ++level) {
            DepthPyramid::Level out;
            out.columns = (columns_ + (1 << level) - 1) >> level;
            out.rows = (rows_ + (1 << level) - 1) >> level;
            out.bounds.resize((size_t) out.columns * (size_t) out.rows);
            glGetTextureSubImage(texture(), level, 0, 0, view, out.columns, out.rows, 1, GL_RG,
                                 GL_FLOAT, (GLsizei) (out.bounds.size() * sizeof(DepthBounds)),
                                 out.bounds.data());
            for (DepthBounds& bounds : out.bounds) bounds.near = -bounds.near;
            pyramid.levels.push_back(std::move(out));
        }
    }
}

void DepthBoundsTexture::write(const Grid& grid) {
    for (int view = 0; view < views_; ++view) {
        const auto& levels = grid.pyramids[(size_t) view].levels;
        for (size_t level = 0; level < levels.size(); ++level) {
            std::vector<DepthBounds> bounds = levels[level].bounds;
            for (DepthBounds& b : bounds) b.near = -b.near;
            glTextureSubImage3D(texture(), (GLint) level, 0, 0, view, levels[level].columns,
                                levels[level].rows, 1, GL_RG, GL_FLOAT, bounds.data());
        }
    }
}

uint64_t DepthBoundsTexture::bytesOfLevels(int first, int end) const {
    uint64_t bytes = 0;
    for (int level = first; level < std::min(end, levels_); ++level)
        bytes += (uint64_t) atLevel(width_, level) * (uint64_t) atLevel(height_, level) *
                 (uint64_t) views_ * sizeof(DepthBounds);
    return bytes;
}

} // namespace dirt
