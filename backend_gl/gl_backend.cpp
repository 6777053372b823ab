#include "backend_gl/gl_backend.h"

#include "backend_gl/self_test.h"
#include "core/grid/denormals.h"
#include "core/io/error.h"
#include "shaders/shared/grid_parameters.h"

namespace dirt {
namespace {

/// Rays of one dispatch.
constexpr size_t kRaysPerCast = 1 << 20;

/// As trace.comp reads it.
struct RayRecord {
    glm::vec3 origin;
    uint32_t skip;
    glm::vec3 direction;
    float maxT;
};
static_assert(sizeof(RayRecord) == 32);

/// Of trace.comp's State.
constexpr size_t kStateBytes = 56;

[[noreturn]] void refuse(const char* pass) {
    throw CapabilityError(std::string("--backend gl: ") + pass + " is not built yet");
}

GridParameters parametersOf(const Grid& grid) {
    GridParameters parameters{};
    for (size_t v = 0; v < grid.views.size(); ++v) {
        const View& view = grid.views[v];
        parameters.viewAxes[v] = {view.axisX, view.axisY, view.axisW, (int) view.signW};
    }
    parameters.columns = grid.views[0].columns;
    parameters.rows = grid.views[0].rows;
    parameters.bins = grid.settings.bins;
    parameters.views = (int) grid.views.size();
    const View& view = grid.views[0];
    const glm::vec2 size = glm::vec2(view.width, view.height) * (0.5f / (float) grid.settings.tile);
    parameters.tilesOfSlope = {size / glm::vec2(view.s.back(), view.t.back()), size};
    return parameters;
}

/// (lo, hi) of each column, then of each row. All views of a frame have the same borders.
std::vector<float> bordersOf(const View& view) {
    std::vector<float> borders;
    const auto add = [&borders](const std::vector<float>& lo, const std::vector<float>& hi) {
        for (size_t i = 0; i < lo.size(); ++i) {
            borders.push_back(flushed(lo[i]));
            borders.push_back(flushed(hi[i]));
        }
    };
    add(view.sLo, view.sHi);
    add(view.tLo, view.tHi);
    return borders;
}

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
      proposal_(options.proposal.value_or(enableConservativeRaster() ? Proposal::triangles
                                                                     : Proposal::rectangles)),
      arithmeticFaults_(dirt::arithmeticFaults(programs_)), triangles_(programs_),
      bounds_(programs_), ids_(programs_, options.poolNodes, options.segmentBits) {
    context_.check();
}

GlBackend::~GlBackend() {
    context_.makeCurrent(); // for what the members delete
}

std::string GlBackend::device() const {
    if (arithmeticFaults_.empty()) return context_.name();
    return context_.name() + ", not IEEE in the " + arithmeticFaults_ + " stage";
}

void GlBackend::reloadShaders() {
    context_.makeCurrent();
    programs_.reload();
}

/// Sets up the views of \p grid, with all buffers empty.
void GlBackend::useGrid(Grid grid) {
    grid_ = std::move(grid);
    for (DepthPyramid& pyramid : grid_.pyramids) pyramid.levels.clear();
    const GridParameters parameters = parametersOf(grid_);
    const std::vector<float> borders = bordersOf(grid_.views[0]);
    parameters_ = GlBuffer(sizeof parameters, &parameters);
    borders_ = GlBuffer(borders.size() * sizeof(float), borders.data());
    borderView_ = makeTexture(GL_TEXTURE_BUFFER);
    glTextureBuffer(borderView_.id(), GL_RG32F, borders_.id());
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, parameters_.id());
    glBindTextureUnit(0, borderView_.id());
    std::vector<float> slopes = grid_.views[0].s;
    slopes.insert(slopes.end(), grid_.views[0].t.begin(), grid_.views[0].t.end());
    slopes_ = GlBuffer(slopes.size() * sizeof(float), slopes.data());
    slopeView_ = makeTexture(GL_TEXTURE_BUFFER);
    glTextureBuffer(slopeView_.id(), GL_R32F, slopes_.id());
    bounds_.clear(grid_);
    ids_.clear(grid_);
    atEye_.clear();
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
    context_.check();
}

void GlBackend::setGeometry(const FrameGeometry& geometry) {
    context_.makeCurrent();
    triangles_.write(geometry);
    context_.check();
}

void GlBackend::fillDepth() {
    context_.makeCurrent();
    bounds_.fill(triangles_, grid_.settings.mode, proposal_);
    glFinish(); // the time of a pass is its own
    context_.check();
}

void GlBackend::fillDepthMipmap() {
    context_.makeCurrent();
    bounds_.buildPyramid();
    glFinish();
    context_.check();
}

void GlBackend::fillPrimitives() {
    context_.makeCurrent();
    atEye_ = triangles_.findAtEye();
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
    grid.atEye = atEye_;
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
    atEye_ = grid.atEye;
    context_.check();
}

std::vector<BufferSize> GlBackend::memory() const {
    return {{"triangle buffer", triangles_.bytes()},
            {"depth bounds", bounds_.bytesOfLevels(0, 1)},
            {"depth pyramid", bounds_.bytesOfLevels(1, bounds_.levels())},
            {"id buffer heads", ids_.headBytes()},
            {"id buffer", ids_.nodeBytes()}};
}

/// Any hits before \p maxT, or nearest hits where that is empty.
void GlBackend::cast(std::span<const Ray> rays, std::span<const float> maxT, std::span<Hit> hits) {
    context_.makeCurrent();
    const GlTexture triangleView = makeTexture(GL_TEXTURE_BUFFER);
    if (triangles_.count() > 0) glTextureBuffer(triangleView.id(), GL_RGB32F, triangles_.buffer());
    const GlBuffer atEye(atEye_.size() * sizeof(uint32_t), atEye_.data());
    const GlTexture atEyeView = makeTexture(GL_TEXTURE_BUFFER);
    glTextureBuffer(atEyeView.id(), GL_R32UI, atEye.id());
    const GLuint textures[] = {borderView_.id(),  slopeView_.id(), bounds_.texture(),
                               triangleView.id(), ids_.heads(),    atEyeView.id()};
    glBindTextures(0, 6, textures);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, parameters_.id());
    ids_.bindNodes();
    programs_.use(traceSource(!maxT.empty(), ids_.segments(), ids_.segmentBits()));
    const GridSettings& settings = grid_.settings;
    const int levels = bounds_.levels() - 1;
    glUniform1i(1, settings.traversal == Traversal::linear ? 0
                   : settings.maxMip < 0                   ? levels
                                                           : std::min(settings.maxMip, levels));
    glUniform1i(2, settings.mode == ViewMode::single);
    glUniform1i(3, (GLint) atEye_.size());

    std::vector<RayRecord> records(std::min(rays.size(), kRaysPerCast));
    for (size_t first = 0; first < rays.size(); first += kRaysPerCast) {
        const size_t count = std::min(rays.size() - first, kRaysPerCast);
        for (size_t i = 0; i < count; ++i) {
            const Ray& ray = rays[first + i];
            records[i] = {ray.origin, ray.skip, ray.direction,
                          maxT.empty() ? 0.0f : maxT[first + i]};
        }
        const GlBuffer input(count * sizeof(RayRecord), records.data());
        const GlBuffer output(count * sizeof(Hit));
        const GlBuffer states(2 * sizeof(uint32_t) + count * kStateBytes);
        glClearNamedBufferData(states.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
        const auto block = (GLuint) ids_.segments();
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, block, input.id());
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, block + 1, output.id());
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, block + 2, states.id());
        glUniform1ui(0, (GLuint) count);
        glUniform1ui(5, 3);
        uint32_t unfinished[2]; // and of these, cut short
        do {
            const uint32_t none[2] = {};
            states.write(0, sizeof none, none);
            glUniform1ui(4, turns_);
            glDispatchCompute((GLuint) (count + 63) / 64, 1, 1);
            glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
            states.read(0, sizeof unfinished, unfinished);
            if (unfinished[1] == 0) continue;
            if (turns_ == 1)
                throw CapabilityError("this OpenGL driver ends loops before they are through");
            turns_ /= 2;
        } while (unfinished[0] > 0);
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

void GlBackend::beginFrame(const Scene&, const RenderSettings&, const Requirements&) {
    refuse("DirectVisibility");
}
void GlBackend::beginSample() {
    refuse("Clear of a sample");
}
void GlBackend::directVisibility(uint32_t) {
    refuse("DirectVisibility");
}
void GlBackend::depthMask(int) {
    refuse("DepthMask");
}
void GlBackend::rays(uint32_t, int) {
    refuse("Rays");
}
void GlBackend::trace(int) {
    refuse("Trace");
}
void GlBackend::fetch(int) {
    refuse("Fetch");
}
void GlBackend::visibility(int) {
    refuse("Visibility");
}
void GlBackend::shade(int) {
    refuse("Shade");
}
void GlBackend::shift() {
    refuse("Shade");
}
void GlBackend::resolve() {
    refuse("Resolve");
}
PathBuffers GlBackend::readPaths() const {
    return {};
}
void GlBackend::writePaths(const PathBuffers&) {
    refuse("Trace");
}

} // namespace dirt
