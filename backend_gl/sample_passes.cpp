#include "backend_gl/sample_passes.h"

#include "backend_gl/groups.h"
#include "core/path/camera_rays.h"
#include "core/path/grid_spotlight.h"
#include "core/path/shadow_frustum.h"
#include "core/path/sub_pixel.h"

#include <algorithm>

namespace dirt {
namespace {

// Storage blocks of shadow_rays.comp, visibility.comp and resolve.comp.
enum Block : GLuint { kHits = 1, kShadowRays = 6, kAsked = 7, kClamped = 6 };

} // namespace

SamplePasses::SamplePasses(Programs& programs)
    : programs_(programs), parameterBuffer_(sizeof(FrameParameters)), paths_(programs),
      directVisibility_(programs), rasterFetch_(programs), shadowMap_(programs) {}

void SamplePasses::beginFrame(const Scene& scene, const RenderSettings& settings,
                              const Requirements& need, const GridFrame& frame) {
    need_ = need;
    mode_ = settings.grid.mode;
    fetch_ = settings.fetch;
    counts_ = {};
    const int width = settings.grid.width, height = settings.grid.height;
    parameters_ = {};
    parameters_.plane = CameraRays(scene.camera, width, height, mode_, frame.scale).plane();
    if (need.light) parameters_.light = makeGridSpotlight(scene.lights.front(), frame);
    if (need.shadowMap > 0) parameters_.shadowMap = makeShadowMap(scene, frame);
    parameters_.right = frame.right;
    parameters_.down = frame.down;
    parameters_.forward = frame.forward;
    parameters_.single = mode_ == ViewMode::single;
    parameters_.width = (uint32_t) width;
    parameters_.seed = settings.seed;
    parameters_.background = scene.background;
    parameters_.microfacets = (uint32_t) scene.microfacetModel;
    parameters_.rayType = (uint32_t) settings.rayType;
    parameters_.roulette = settings.roulette;
    parameters_.lens = need.lens;

    scene_.upload(scene, need);
    paths_.allocate(need, (size_t) width * (size_t) height);
    if (!need.tracedPrimary) directVisibility_.allocate(width, height);
    shadowMap_.allocate(need.shadowMap);
    const size_t slice = std::min<size_t>(paths_.pixels(), RayCaster::kMostRays);
    const auto make = [](GlBuffer& buffer, size_t bytes) {
        if (buffer.bytes() == bytes) return;
        buffer = {}; // before the next one is allocated
        buffer = GlBuffer(bytes);
    };
    make(shadowRays_, need.shadowRays ? slice * sizeof(RayRecord) : 0);
    make(shadowHits_, need.shadowRays ? slice * sizeof(Hit) : 0);
}

void SamplePasses::use(const ProgramSource& program, uint32_t sample, int event) {
    const glm::vec2 offset = subPixelOffset(sample, parameters_.seed);
    parameters_.sampleIndex = sample;
    parameters_.event = event;
    parameters_.offsetX = offset.x;
    parameters_.offsetY = offset.y;
    parameterBuffer_.write(0, sizeof parameters_, &parameters_);
    glBindBufferBase(GL_UNIFORM_BUFFER, 1, parameterBuffer_.id());
    programs_.use(program);
}

void SamplePasses::shadowMap(const TriangleBuffer& triangles) {
    use(shadowMapSource(scene_.variant()), 0, 0);
    shadowMap_.draw(triangles, scene_);
}

void SamplePasses::directVisibility(uint32_t sample, const TriangleBuffer& triangles) {
    use(directVisibilitySource(scene_.variant()), sample, 0);
    counts_.rays += paths_.pixels();
    counts_.hits += directVisibility_.run(triangles, scene_, parameters_.plane,
                                          {parameters_.offsetX, parameters_.offsetY}, paths_);
}

void SamplePasses::depthMask(int event) {
    use(depthMaskSource(paths_.format()), parameters_.sampleIndex, event);
    paths_.dispatch();
}

void SamplePasses::rays(uint32_t sample, int event, const TriangleBuffer& triangles) {
    use(raysSource(paths_.format(), event > 0, need_.gloss), sample, event);
    glBindTextureUnit(3, triangles.texture());
    paths_.dispatch();
}

void SamplePasses::trace(int event, const TracedStructure& structure, RayCaster& caster) {
    const CastCounts counts = caster.castPaths(structure, paths_, event > 0);
    counts_.rays += counts.rays;
    counts_.hits += counts.hits;
}

void SamplePasses::fetch(const TriangleBuffer& triangles, const GridViews& views,
                         const Grid& grid) {
    use(fetchSource(paths_.format(), scene_.variant(), false), parameters_.sampleIndex,
        parameters_.event);
    if (fetch_ == Fetch::raster) {
        rasterFetch_.run(triangles, views, grid, scene_, paths_);
        return;
    }
    scene_.bind();
    glBindTextureUnit(3, triangles.texture());
    paths_.dispatch();
}

void SamplePasses::visibility(int event, const TracedStructure& structure, RayCaster& caster) {
    if (!need_.shadowRays) return;
    uint32_t asked = 0;
    const GlBuffer counter(sizeof asked, &asked);
    for (size_t first = 0; first < paths_.pixels(); first += RayCaster::kMostRays) {
        const auto count =
            (uint32_t) std::min<size_t>(RayCaster::kMostRays, paths_.pixels() - first);
        structure.views.bind();
        use(shadowRaysSource(paths_.format(), mode_, need_.gloss), parameters_.sampleIndex, event);
        glBindTextureUnit(3, structure.triangles.texture());
        paths_.bind((uint32_t) first, count);
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kShadowRays, shadowRays_.id());
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kAsked, counter.id());
        glDispatchCompute(groupsOf(count), 1, 1);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                        GL_BUFFER_UPDATE_BARRIER_BIT);
        const BufferRange hits{shadowHits_.id(), 0, count * sizeof(Hit)};
        caster.cast(structure, Search::any, {shadowRays_.id(), 0, count * sizeof(RayRecord)}, hits,
                    count);
        programs_.use(visibilitySource());
        paths_.bind((uint32_t) first, count);
        hits.bind(kHits);
        glDispatchCompute(groupsOf(count), 1, 1);
        glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    }
    counter.read(0, sizeof asked, &asked);
    counts_.shadowRays += asked;
}

void SamplePasses::shade(int event, const TriangleBuffer& triangles) {
    // In single mode a secondary ray that leaves the view returns nothing.
    const bool background = need_.background && (event == 0 || mode_ == ViewMode::full);
    const LightShading light = need_.shadowMap > 0 ? LightShading::shadowMap
                               : need_.shadowRays  ? LightShading::traced
                               : need_.openLight   ? LightShading::open
                                                   : LightShading::none;
    use(shadeSource(paths_.format(), event > 0, need_.emission, background, light, need_.gloss),
        parameters_.sampleIndex, event);
    glBindTextureUnit(3, triangles.texture()); // of packed points
    if (need_.shadowMap > 0) shadowMap_.bind();
    paths_.dispatch();
}

void SamplePasses::resolve() {
    programs_.use(resolveSource());
    uint32_t clamped = 0;
    const GlBuffer counter(sizeof clamped, &clamped);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kClamped, counter.id());
    paths_.dispatch();
    counter.read(0, sizeof clamped, &clamped);
    counts_.clamped += clamped;
}

std::vector<BufferSize> SamplePasses::sizes() const {
    std::vector<BufferSize> sizes = scene_.sizes();
    for (BufferSize& size : paths_.sizes()) sizes.push_back(std::move(size));
    const auto add = [&sizes](const char* name, uint64_t bytes) {
        if (bytes > 0) sizes.emplace_back(name, bytes);
    };
    add("primitives and depths of pixels", need_.tracedPrimary ? 0 : directVisibility_.bytes());
    add("shadow map", shadowMap_.bytes());
    add("hit groups", rasterFetch_.bytes());
    add("shadow rays", shadowRays_.bytes() + shadowHits_.bytes());
    return sizes;
}

} // namespace dirt
