#pragma once

#include "core/frame/path_buffers.h"
#include "core/frame/requirements.h"
#include "core/frame/settings.h"
#include "core/frame/tracer.h"
#include "core/grid/grid.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dirt {

/// What a frame asked so far.
struct FrameCounts {
    uint64_t rays = 0;       ///< that looked for their nearest hit, rasterized ones included
    uint64_t hits = 0;       ///< of these, that found one
    uint64_t shadowRays = 0; ///< that looked for any hit
    uint64_t clamped = 0;    ///< samples of pixels whose radiance reached kMostRadiance
};

/// Runs the passes of a frame, on buffers of its own that can be read and written from the host;
/// so any pass can be run on another backend's data. What
/// the passes of a sample read and write is said in passes.h, which defines them; their order is
/// that of Renderer.
class Backend : public Tracer {
public:
    /// The construction passes in their order, over a mesh or over geometry that the host has
    /// transformed.
    std::vector<PassTime> build(const Mesh& mesh, const Camera& camera,
                                const GridSettings& settings);
    std::vector<PassTime> build(const FrameGeometry& geometry, const Camera& camera,
                                const GridSettings& settings) final;

    /// Whether its arithmetic is that of IEEE 754, so that its buffers equal core's to the bit.
    virtual bool isIeee() const { return true; }

    // The passes of construction. Clear makes all buffers of the structure empty.
    virtual void clear(const Camera& camera, const GridSettings& settings) = 0;
    /// The triangle buffer, the first part of FillDepth: from the mesh, or as the host has it
    /// (alive and unchanged while it is in use).
    virtual void transform(const Mesh& mesh, const Camera& camera, ViewMode mode) = 0;
    virtual void setGeometry(const FrameGeometry& geometry) = 0;
    virtual void fillDepth() = 0;
    virtual void fillDepthMipmap() = 0;
    virtual void fillPrimitives() = 0;

    /// Whether DirectVisibility and Fetch can rasterize; else the frame traces primary rays and
    /// fetches by primitive id.
    virtual bool rasterizes() const = 0;

    /// Makes room for the paths of a frame over the structure that has been built. \p scene and
    /// \p settings must outlive the frame's passes.
    virtual void beginFrame(const Scene& scene, const RenderSettings& settings,
                            const Requirements& requirements) = 0;

    /// The depths that the light sees, where requirements ask for its shadow map; once a frame.
    virtual void shadowMap() = 0;

    /// Reads its shaders' files again, where it has some. If one of them does not compile it throws
    /// std::runtime_error, with file and line, and goes on with those that it had.
    virtual void reloadShaders() {}

    // The passes of a sample.
    virtual void beginSample() = 0;
    virtual void directVisibility(uint32_t sample) = 0;
    virtual void depthMask(int event) = 0;
    virtual void rays(uint32_t sample, int event) = 0;
    virtual void trace(int event) = 0;
    virtual void fetch(int event) = 0;
    virtual void visibility(int event) = 0;
    virtual void shade(int event) = 0;
    virtual void shift() = 0;
    virtual void resolve() = 0;

    // The buffers, from and to the host.
    virtual FrameGeometry readGeometry() const = 0;
    /// Whether the structure is a grid, which readGrid and writeGrid need.
    virtual bool hasGrid() const = 0;
    /// A copy of the structure, each list in the order of ids.
    virtual Grid readGrid() const = 0;
    virtual void writeGrid(const Grid& grid) = 0;
    /// Buffers that the frame does not need are empty.
    virtual PathBuffers readPaths() const = 0;
    virtual void writePaths(const PathBuffers& paths) = 0;
    /// What readPaths has of one pixel: buffers of one record.
    virtual PathBuffers readPath(size_t pixel) const;
    /// Parts of it, for whoever looks into every sample: G[k+1] in full, and what the sample has
    /// gathered.
    virtual std::vector<SurfacePoint> readPoints() const = 0;
    virtual std::vector<glm::vec3> readRadiance() const = 0;
    /// Depths of the shadow map, row by row; empty where there is none.
    virtual std::vector<float> readShadowMap() const = 0;
    virtual void writeShadowMap(const std::vector<float>& depths) = 0;
    /// PathBuffers::image alone.
    virtual std::vector<glm::vec3> readImage() const = 0;

    // The clock of a device that works on while the host goes on: called around each pass that is
    // timed. The host's clock tells where there is none.
    virtual void beginTimedPass() {}
    virtual void endTimedPass() {}
    /// Milliseconds of each pass timed since the last call.
    virtual std::vector<double> takePassTimes() { return {}; }

    virtual FrameCounts counts() const = 0;
    /// All buffers there are, with their sizes in bytes.
    virtual std::vector<BufferSize> memory() const = 0;
    /// Entries in all lists (0 where the structure has none).
    virtual uint64_t listEntries() const = 0;
};

} // namespace dirt
