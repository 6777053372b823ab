#pragma once

#include "backend_gl/grid_views.h"
#include "backend_gl/id_buffer.h"
#include "backend_gl/path_buffers.h"
#include "backend_gl/scene_buffers.h"
#include "core/frame/settings.h"

namespace dirt {

/// What the search for hits goes through.
struct TracedStructure {
    const GridViews& views;
    const TriangleBuffer& triangles;
    const DepthBoundsTexture& bounds;
    const IdBuffer& ids;
    const GridSettings& settings;
    const SceneBuffers* cutOuts = nullptr; ///< surfaces with holes, if there are any
};

/// A ray of the search that is no path's, as include/ray_record.glsl has it.
struct RayRecord {
    glm::vec3 origin;
    uint32_t skip;
    glm::vec3 direction;
    float maxT; ///< any hit: only those before it
};
static_assert(sizeof(RayRecord) == 32);

/// Rays that were cast.
struct CastCounts {
    uint64_t rays = 0; ///< with a direction
    uint64_t hits = 0;
};

/// Casts rays that lie on the device: trace.comp, in one dispatch, or where the driver leaves loops
/// in as many as the rays need.
class RayCaster {
public:
    /// Rays of one cast, at most: their states are kept between dispatches.
    static constexpr uint32_t kMostRays = 1u << 18;

    /// \p resumes: as the driver leaves loops before they are through, rays go on in further
    /// dispatches.
    RayCaster(Programs& programs, bool resumes) : programs_(programs), resumes_(resumes) {}

    /// Nearest hits, or any hits before each ray's maxT, of \p count RayRecords.
    CastCounts cast(const TracedStructure& structure, Search search, const BufferRange& rays,
                    const BufferRange& hits, uint32_t count);

    /// Nearest hits of the paths' rays; only of those that the mask leaves alive if \p masked.
    CastCounts castPaths(const TracedStructure& structure, const GlPathBuffers& paths, bool masked);

    uint64_t stateBytes() const { return states_.bytes(); }

private:
    void begin(const TracedStructure& structure, Search search);
    CastCounts run(const BufferRange& rays, const BufferRange& hits, uint32_t count, GLuint block);

    void resume(uint32_t count);

    Programs& programs_;
    bool resumes_;
    GlBuffer states_; ///< of the rays, after the counts
};

} // namespace dirt
