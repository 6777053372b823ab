#include "backend_gl/gl_backend.h"

#include "backend_gl/loop_probe.h"
#include "backend_gl/self_test.h"
#include "core/base/error.h"

namespace dirt {
namespace {

/// Pixels that a primitive touches, enlarged by 1/4 of a pixel, where the driver can. The passes
/// that draw draw nothing else.
bool enableConservativeRaster() {
    if (!epoxy_has_gl_extension("GL_NV_conservative_raster") ||
        !epoxy_has_gl_extension("GL_NV_conservative_raster_dilate"))
        return false;
    glEnable(GL_CONSERVATIVE_RASTERIZATION_NV);
    glConservativeRasterParameterfNV(GL_CONSERVATIVE_RASTER_DILATE_NV, 0.25f);
    return true;
}

/// Triangles where the driver rasterizes them conservatively and has shown that no tile is missing
/// and none comes twice.
Proposal chooseProposal(Programs& programs, ProposalFaults& faults) {
    if (!enableConservativeRaster()) return Proposal::rectangles;
    faults = proposalFaults(programs, Proposal::triangles);
    if (!faults.any()) return Proposal::triangles;
    glDisable(GL_CONSERVATIVE_RASTERIZATION_NV);
    return Proposal::rectangles;
}

/// Throws InputError, with a tile size that fits if there is one, where the driver has no textures
/// for that many tiles and lists.
void checkTextures(const Grid& grid) {
    const View& view = grid.views[0];
    const int views = (int) grid.views.size(), bins = grid.settings.bins;
    const auto fits = [&](int tile) {
        const int columns = (view.width + tile - 1) / tile, rows = (view.height + tile - 1) / tile;
        return DepthBoundsTexture::fits(columns, rows, views) &&
               IdBuffer::fits(columns, rows, views * bins);
    };
    int tile = grid.settings.tile;
    if (fits(tile)) return;
    while (tile <= 64 && !fits(tile)) ++tile;
    throw InputError("--tile " + std::to_string(grid.settings.tile) + " --bins " +
                     std::to_string(bins) + ": this OpenGL driver has no textures for that many " +
                     "lists (" +
                     (tile <= 64 ? "--tile " + std::to_string(tile) + " would fit"
                                 : std::string("fewer bins need less")) +
                     ")");
}

} // namespace

GlBackend::GlBackend(const GlOptions& options)
    : context_(options.device), programs_(options.shaders),
      proposal_(options.proposal ? *options.proposal : chooseProposal(programs_, proposalFaults_)),
      arithmeticFaults_(dirt::arithmeticFaults(programs_)), triangles_(programs_),
      bounds_(programs_), ids_(programs_, options.poolNodes, options.segmentBits),
      caster_(programs_, options.resumes ? *options.resumes : leavesLoops(programs_)),
      passes_(programs_) {
    context_.check();
}

GlBackend::~GlBackend() {
    try {
        context_.makeCurrent();        // for what the members delete
    } catch (const CapabilityError&) { // it is lost, and all of that with it
    }
}

std::string GlBackend::device() const {
    std::string text = context_.name();
    if (!arithmeticFaults_.empty()) text += ", not IEEE in the " + arithmeticFaults_ + " stage";
    if (proposalFaults_.any())
        text += ", whose conservative rasterization misses " +
                std::to_string(proposalFaults_.missed) + " and repeats " +
                std::to_string(proposalFaults_.repeated) + " tiles of a test and is not used";
    return text;
}

void GlBackend::reloadShaders() {
    context_.makeCurrent();
    programs_.reload();
}

/// Sets up the views of \p grid, with all buffers empty.
void GlBackend::useGrid(Grid grid) {
    grid_ = std::move(grid);
    for (DepthPyramid& pyramid : grid_.pyramids) pyramid.levels.clear();
    views_.set(grid_);
    bounds_.clear(grid_);
    ids_.clear(grid_);
}

void GlBackend::clear(const Camera& camera, const GridSettings& settings) {
    context_.makeCurrent();
    Grid grid = makeEmptyGrid(camera, settings);
    checkTextures(grid);
    camera_ = camera;
    useGrid(std::move(grid));
    context_.check();
}

void GlBackend::transform(const Mesh& mesh, const Camera& camera, ViewMode mode) {
    context_.makeCurrent();
    triangles_.transform(mesh, camera, mode);
    frameBegun_ = false;
    context_.check();
}

void GlBackend::setGeometry(const FrameGeometry& geometry) {
    context_.makeCurrent();
    triangles_.write(geometry);
    frameBegun_ = false;
    context_.check();
}

void GlBackend::fillDepth() {
    context_.makeCurrent();
    bounds_.fill(triangles_, grid_.settings.mode, proposal_);
    endPass();
}

void GlBackend::fillDepthMipmap() {
    context_.makeCurrent();
    bounds_.buildPyramid();
    endPass();
}

void GlBackend::fillPrimitives() {
    context_.makeCurrent();
    views_.setAtEye(triangles_.findAtEye());
    const bool filled = ids_.fill(triangles_, bounds_, grid_.settings.mode, proposal_);
    context_.check();
    if (!filled) refuseLists();
}

/// Names settings whose lists the pool can hold.
void GlBackend::refuseLists() {
    const ListCounts counts = ids_.counts();
    const std::string problem =
        "--tile " + std::to_string(grid_.settings.tile) + " --bins " +
        std::to_string(grid_.settings.bins) + ": the lists need " + std::to_string(counts.entries) +
        " entries, and this OpenGL driver's buffers hold " + std::to_string(ids_.mostNodes());
    // A triangle is at most once in each bin of a tile.
    if (counts.pairs <= ids_.mostNodes())
        throw InputError(problem + " (--bins " + std::to_string(ids_.mostNodes() / counts.pairs) +
                         " would fit)");
    GridSettings settings = grid_.settings;
    settings.bins = 1;
    while (settings.tile < 64) {
        settings.tile = std::min(settings.tile * 2, 64);
        clear(camera_, settings);
        fillDepth();
        if (ids_.fill(triangles_, bounds_, settings.mode, proposal_))
            throw InputError(problem + " (--tile " + std::to_string(settings.tile) +
                             " --bins 1 would fit)");
    }
    throw InputError(problem);
}

FrameGeometry GlBackend::readGeometry() const {
    context_.makeCurrent();
    FrameGeometry geometry = triangles_.read();
    context_.check();
    return geometry;
}

Grid GlBackend::readGrid() const {
    context_.makeCurrent();
    Grid grid = grid_;
    bounds_.read(grid);
    ids_.read(grid);
    grid.atEye = views_.atEye();
    context_.check();
    return grid;
}

void GlBackend::writeGrid(const Grid& grid) {
    context_.makeCurrent();
    Grid empty;
    empty.settings = grid.settings;
    empty.views = grid.views;
    empty.firstTile = grid.firstTile;
    empty.pyramids.resize(grid.views.size());
    checkTextures(empty);
    useGrid(std::move(empty));
    bounds_.write(grid);
    ids_.write(grid);
    views_.setAtEye(grid.atEye);
    context_.check();
}

std::vector<BufferSize> GlBackend::memory() const {
    std::vector<BufferSize> sizes = {
        {"triangle buffer", triangles_.bytes()},
        {"depth bounds", bounds_.bytesOfLevels(0, 1)},
        {"depth pyramid", bounds_.bytesOfLevels(1, bounds_.levels())},
        {"id buffer heads", ids_.headBytes()},
        {"id buffer", ids_.nodeBytes(), ids_.usedBytes(listEntries())}};
    for (BufferSize& size : passes_.sizes()) sizes.push_back(std::move(size));
    if (caster_.stateBytes() > 0) sizes.emplace_back("states of rays", caster_.stateBytes());
    return sizes;
}

TracedStructure GlBackend::structure() const {
    return {views_, triangles_,     bounds_,
            ids_,   grid_.settings, frameBegun_ ? passes_.cutOuts() : nullptr};
}

/// Any hits before \p maxT, or nearest hits where that is empty.
void GlBackend::cast(std::span<const Ray> rays, std::span<const float> maxT, std::span<Hit> hits) {
    context_.makeCurrent();
    std::vector<RayRecord> records(std::min<size_t>(rays.size(), RayCaster::kMostRays));
    for (size_t first = 0; first < rays.size(); first += RayCaster::kMostRays) {
        const size_t count = std::min<size_t>(rays.size() - first, RayCaster::kMostRays);
        for (size_t i = 0; i < count; ++i) {
            const Ray& ray = rays[first + i];
            records[i] = {ray.origin, ray.skip, ray.direction,
                          maxT.empty() ? 0.0f : maxT[first + i]};
        }
        const GlBuffer input(count * sizeof(RayRecord), records.data());
        const GlBuffer output(count * sizeof(Hit));
        caster_.cast(structure(), maxT.empty() ? Search::nearest : Search::any,
                     {input.id(), 0, input.bytes()}, {output.id(), 0, output.bytes()},
                     (uint32_t) count);
        output.read(0, output.bytes(), hits.data() + first);
    }
    context_.check();
}

void GlBackend::intersect(std::span<const Ray> rays, std::span<Hit> hits) {
    cast(rays, {}, hits);
}

void GlBackend::occluded(std::span<const Ray> rays, std::span<const float> maxT,
                         std::span<uint8_t> result) {
    if (rays.empty()) return;
    std::vector<Hit> hits(rays.size());
    cast(rays, maxT, hits);
    for (size_t i = 0; i < hits.size(); ++i) result[i] = hits[i].found() ? 1 : 0;
}

void GlBackend::endPass() const {
    if (!timer_.works()) glFinish();
    context_.check();
}

void GlBackend::beginTimedPass() {
    context_.makeCurrent();
    timer_.begin();
}

void GlBackend::endTimedPass() {
    context_.makeCurrent();
    timer_.end();
}

std::vector<double> GlBackend::takePassTimes() {
    context_.makeCurrent();
    return timer_.take();
}

void GlBackend::beginFrame(const Scene& scene, const RenderSettings& settings,
                           const Requirements& requirements) {
    context_.makeCurrent();
    passes_.beginFrame(scene, settings, requirements, triangles_.frame());
    frameBegun_ = true;
    context_.check();
}

void GlBackend::shadowMap() {
    context_.makeCurrent();
    passes_.shadowMap(triangles_);
    endPass();
}

void GlBackend::beginSample() {
    context_.makeCurrent();
    passes_.beginSample();
}

void GlBackend::directVisibility(uint32_t sample) {
    context_.makeCurrent();
    passes_.directVisibility(sample, triangles_);
    endPass();
}

void GlBackend::depthMask(int event) {
    context_.makeCurrent();
    passes_.depthMask(event);
    endPass();
}

void GlBackend::rays(uint32_t sample, int event) {
    context_.makeCurrent();
    passes_.rays(sample, event, triangles_);
    endPass();
}

void GlBackend::trace(int event) {
    context_.makeCurrent();
    passes_.trace(event, structure(), caster_);
    endPass();
}

void GlBackend::fetch(int) {
    context_.makeCurrent();
    passes_.fetch(triangles_, views_, grid_);
    endPass();
}

void GlBackend::visibility(int event) {
    context_.makeCurrent();
    passes_.visibility(event, structure(), caster_);
    endPass();
}

void GlBackend::shade(int event) {
    context_.makeCurrent();
    passes_.shade(event, triangles_);
    endPass();
}

void GlBackend::shift() {
    passes_.shift();
}

void GlBackend::resolve() {
    context_.makeCurrent();
    passes_.resolve();
    endPass();
}

PathBuffers GlBackend::readPaths() const {
    context_.makeCurrent();
    PathBuffers paths = passes_.paths().read();
    if (passes_.paths().format().packed()) paths = paths.unpacked(triangles_.read());
    context_.check();
    return paths;
}

void GlBackend::writePaths(const PathBuffers& paths) {
    context_.makeCurrent();
    const PointFormat& format = passes_.paths().format();
    passes_.paths().write(format.packed() ? paths.packed(format, triangles_.read()) : paths);
    context_.check();
}

std::vector<float> GlBackend::readShadowMap() const {
    context_.makeCurrent();
    std::vector<float> depths = passes_.shadowMap().read();
    context_.check();
    return depths;
}

void GlBackend::writeShadowMap(const std::vector<float>& depths) {
    context_.makeCurrent();
    passes_.shadowMap().write(depths);
    context_.check();
}

std::vector<SurfacePoint> GlBackend::readPoints() const {
    context_.makeCurrent();
    const PackedPoints packed = passes_.paths().readPackedPoints();
    std::vector<SurfacePoint> points =
        packed.empty() ? passes_.paths().readPoints() : unpack(packed, triangles_.read());
    context_.check();
    return points;
}

std::vector<glm::vec3> GlBackend::readRadiance() const {
    context_.makeCurrent();
    std::vector<glm::vec3> radiance = passes_.paths().readRadiance();
    context_.check();
    return radiance;
}

std::vector<glm::vec3> GlBackend::readImage() const {
    context_.makeCurrent();
    std::vector<glm::vec3> image = passes_.paths().readImage();
    context_.check();
    return image;
}

} // namespace dirt
