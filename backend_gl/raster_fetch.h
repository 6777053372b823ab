#pragma once

#include "backend_gl/grid_views.h"
#include "backend_gl/path_buffers.h"
#include "backend_gl/scene_buffers.h"
#include "backend_gl/triangle_buffer.h"

namespace dirt {

/// Fetch as the paper has it: the triangles are rasterized with the coverage of FillPrimitives
/// against the hit records of each tile, and leave their attributes with those that name them.
class RasterFetch {
public:
    explicit RasterFetch(Programs& programs) : programs_(programs) {}

    /// G[k+1] of all hits, over the views of \p grid. Needs uniform block 1.
    void run(const TriangleBuffer& triangles, const GridViews& views, const Grid& grid,
             const SceneBuffers& scene, const GlPathBuffers& paths);

    uint64_t bytes() const {
        return slots_.bytes() + groupOf_.bytes() + fetches_.bytes() + deposits_.bytes();
    }

private:
    void allocate(size_t records, const SurfaceVariant& surfaces);
    void setViews(const View& view, size_t views);

    Programs& programs_;
    GlBuffer slots_, groupOf_, fetches_, deposits_;
    GlFramebuffer framebuffer_; ///< without pictures, as large as the views
};

} // namespace dirt
