#pragma once

#include "backend_gl/programs.h"
#include "backend_gl/triangle_buffer.h"
#include "core/grid/grid.h"

namespace dirt {

/// The depth pyramids of all views: one texture of (-near, far), a layer for each view. Its size is
/// rounded up to powers of two, so that halving a level, which OpenGL rounds down, loses no tile;
/// what is beyond the tiles stays empty.
class DepthBoundsTexture {
public:
    explicit DepthBoundsTexture(Programs& programs) : programs_(programs) {}

    /// Whether the driver has a texture for views of that many tiles.
    static bool fits(int columns, int rows, int views);

    /// Room for \p grid, all empty.
    void clear(const Grid& grid);

    /// FillDepth, for the views that are set up.
    void fill(const TriangleBuffer& triangles, ViewMode mode, Proposal proposal);
    /// FillDepthMipmap: the levels above the tiles'.
    void buildPyramid();

    void read(Grid& grid) const;
    void write(const Grid& grid);

    GLuint texture() const { return texture_.id(); }
    uint64_t bytesOfLevels(int first, int end) const;
    int levels() const { return levels_; }

private:
    Programs& programs_;
    GlTexture texture_;
    GlFramebuffer framebuffer_; ///< level 0, all layers
    int columns_ = 0, rows_ = 0, views_ = 0;
    int width_ = 0, height_ = 0, levels_ = 0;
};

} // namespace dirt
