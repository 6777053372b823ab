#pragma once

#include "backend_gl/direct_visibility.h"
#include "backend_gl/path_buffers.h"
#include "backend_gl/raster_fetch.h"
#include "backend_gl/ray_caster.h"
#include "backend_gl/scene_buffers.h"
#include "backend_gl/shadow_texture.h"
#include "core/frame/backend.h"
#include "core/grid/grid.h"
#include "shaders/shared/frame_parameters.h"

#include <vector>

namespace dirt {

/// The passes of a sample, with all that they keep on the device: what core/frame/passes.h defines.
class SamplePasses {
public:
    explicit SamplePasses(Programs& programs);

    /// \p frame: that of the triangle buffer.
    void beginFrame(const Scene& scene, const RenderSettings& settings, const Requirements& need,
                    const GridFrame& frame);
    void shadowMap(const TriangleBuffer& triangles);
    void beginSample() { paths_.clearRadiance(); }
    void directVisibility(uint32_t sample, const TriangleBuffer& triangles);
    void depthMask(int event);
    void rays(uint32_t sample, int event, const TriangleBuffer& triangles);
    void trace(int event, const TracedStructure& structure, RayCaster& caster);
    /// \p grid: its views.
    void fetch(const TriangleBuffer& triangles, const GridViews& views, const Grid& grid);
    void visibility(int event, const TracedStructure& structure, RayCaster& caster);
    void shade(int event, const TriangleBuffer& triangles);
    void shift() { paths_.shift(); }
    void resolve();

    /// Surfaces with holes; null where the frame has none.
    const SceneBuffers* cutOuts() const { return scene_.variant().cutOuts ? &scene_ : nullptr; }
    GlPathBuffers& paths() { return paths_; }
    const GlPathBuffers& paths() const { return paths_; }
    const ShadowMapTexture& shadowMap() const { return shadowMap_; }
    const FrameCounts& counts() const { return counts_; }
    std::vector<BufferSize> sizes() const;

private:
    /// Binds the frame's parameters, and \p program.
    void use(const ProgramSource& program, uint32_t sample, int event);

    Programs& programs_;
    Requirements need_;
    ViewMode mode_ = ViewMode::full;
    Fetch fetch_ = Fetch::raster;
    FrameParameters parameters_;
    GlBuffer parameterBuffer_, shadowRays_, shadowHits_;
    SceneBuffers scene_;
    GlPathBuffers paths_;
    DirectVisibility directVisibility_;
    RasterFetch rasterFetch_;
    ShadowMapTexture shadowMap_;
    FrameCounts counts_;
};

} // namespace dirt
