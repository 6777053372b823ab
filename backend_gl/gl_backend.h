#pragma once

#include "backend_gl/depth_bounds.h"
#include "backend_gl/gl_context.h"
#include "backend_gl/grid_views.h"
#include "backend_gl/id_buffer.h"
#include "backend_gl/pass_timer.h"
#include "backend_gl/programs.h"
#include "backend_gl/proposal_test.h"
#include "backend_gl/ray_caster.h"
#include "backend_gl/sample_passes.h"
#include "backend_gl/triangle_buffer.h"
#include "core/frame/backend.h"

#include <optional>

namespace dirt {

/// What a GlBackend starts with.
struct GlOptions {
    int device = -1;          ///< a number of listGlDevices(); -1: the first that works
    ShaderFiles shaders = {}; ///< built in, unless DIRT_SHADERS names a folder
    /// Default: rays go on in further dispatches where the driver leaves loops.
    std::optional<bool> resumes = {};
    uint32_t poolNodes = 1 << 20; ///< of the id buffer; it grows where that is too few
    /// Default: triangles where the driver has GL_NV_conservative_raster and _dilate, and they miss
    /// no tile of a test.
    std::optional<Proposal> proposal = {};
    int segmentBits = 0; ///< nodes of one segment of the pool; 0: the driver's limit
};

/// The structure built in GLSL through the rasterization pipeline, and traced and shaded there. To
/// be used by one thread at a
/// time.
class GlBackend final : public Backend {
public:
    /// Throws CapabilityError where there is no OpenGL 4.5.
    explicit GlBackend(const GlOptions& options = {});
    ~GlBackend() override;

    std::string name() const override { return "gl"; }
    /// Renderer and version; with what is wrong with it: the stages whose arithmetic is not IEEE,
    /// conservative rasterization with faults.
    std::string device() const override;
    bool isIeee() const override { return arithmeticFaults_.empty(); }
    void reloadShaders() override;

    void clear(const Camera& camera, const GridSettings& settings) override;
    void transform(const Mesh& mesh, const Camera& camera, ViewMode mode) override;
    void setGeometry(const FrameGeometry& geometry) override;
    void fillDepth() override;
    void fillDepthMipmap() override;
    void fillPrimitives() override;

    void intersect(std::span<const Ray> rays, std::span<Hit> hits) override;
    void occluded(std::span<const Ray> rays, std::span<const float> maxT,
                  std::span<uint8_t> result) override;

    bool rasterizes() const override { return true; }
    void beginFrame(const Scene& scene, const RenderSettings& settings,
                    const Requirements& requirements) override;
    void shadowMap() override;
    void beginSample() override;
    void directVisibility(uint32_t sample) override;
    void depthMask(int event) override;
    void rays(uint32_t sample, int event) override;
    void trace(int event) override;
    void fetch(int event) override;
    void visibility(int event) override;
    void shade(int event) override;
    void shift() override;
    void resolve() override;

    FrameGeometry readGeometry() const override;
    bool hasGrid() const override { return true; }
    Grid readGrid() const override;
    void writeGrid(const Grid& grid) override;
    PathBuffers readPaths() const override;
    void writePaths(const PathBuffers& paths) override;
    std::vector<SurfacePoint> readPoints() const override;
    std::vector<glm::vec3> readRadiance() const override;
    std::vector<float> readShadowMap() const override;
    void writeShadowMap(const std::vector<float>& depths) override;
    std::vector<glm::vec3> readImage() const override;

    void beginTimedPass() override;
    void endTimedPass() override;
    std::vector<double> takePassTimes() override;

    FrameCounts counts() const override { return passes_.counts(); }
    std::vector<BufferSize> memory() const override;
    uint64_t listEntries() const override { return ids_.counts().entries; }

private:
    void useGrid(Grid grid);
    [[noreturn]] void refuseLists();
    void cast(std::span<const Ray> rays, std::span<const float> maxT, std::span<Hit> hits);
    TracedStructure structure() const;
    /// After a pass: what the driver complains of is thrown. Without a clock of the device the host
    /// waits, so that the pass's time is its own.
    void endPass() const;

    GlContext context_;
    PassTimer timer_;
    Programs programs_;
    ProposalFaults proposalFaults_; ///< of the driver's conservative rasterization
    Proposal proposal_;
    std::string arithmeticFaults_;
    TriangleBuffer triangles_;
    DepthBoundsTexture bounds_;
    IdBuffer ids_;
    Grid grid_; ///< views and settings alone
    Camera camera_;
    GridViews views_;
    RayCaster caster_;
    SamplePasses passes_;
    bool frameBegun_ = false; ///< over the geometry at hand: holes are looked up
};

} // namespace dirt
