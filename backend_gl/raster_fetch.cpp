#include "backend_gl/raster_fetch.h"

#include "backend_gl/groups.h"
#include "backend_gl/ordinary_raster.h"

#include <algorithm>
#include <bit>

namespace dirt {
namespace {

// Of include/hit_groups.glsl and include/deposits.glsl.
enum Block : GLuint { kSlots = 6, kGroupOf, kFetches, kDeposits };

void dispatchOver(size_t count) {
    glDispatchCompute(groupsOf(count), 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

} // namespace

void RasterFetch::allocate(size_t records, const SurfaceVariant& surfaces) {
    const auto make = [](GlBuffer& buffer, size_t words) {
        if (buffer.bytes() == words * sizeof(uint32_t)) return;
        buffer = {}; // before the next one is allocated
        buffer = GlBuffer(words * sizeof(uint32_t));
    };
    make(slots_, std::bit_ceil(2 * records)); // at most half full
    make(groupOf_, records);
    make(fetches_, records);
    make(deposits_, records * (size_t) surfaces.depositWords());
}

void RasterFetch::setViews(const View& view, size_t views) {
    if (!framebuffer_.id()) framebuffer_ = makeFramebuffer();
    const auto set = [&](GLenum name, int value) {
        glNamedFramebufferParameteri(framebuffer_.id(), name, value);
    };
    set(GL_FRAMEBUFFER_DEFAULT_WIDTH, view.columns);
    set(GL_FRAMEBUFFER_DEFAULT_HEIGHT, view.rows);
    set(GL_FRAMEBUFFER_DEFAULT_LAYERS, (int) views);
}

void RasterFetch::run(const TriangleBuffer& triangles, const GridViews& views, const Grid& grid,
                      const SceneBuffers& scene, const GlPathBuffers& paths) {
    const ViewMode mode = grid.settings.mode;
    const SurfaceVariant& surfaces = scene.variant();
    allocate(std::min<size_t>(paths.pixels(), GlPathBuffers::kPixelsPerPiece), surfaces);
    setViews(grid.views[0], grid.views.size());
    const OrdinaryRaster ordinary; // a tile's centre decides: one fragment for each tile
    views.bind();
    scene.bind();
    const GLuint textures[] = {triangles.texture(), 0, views.atEyeTexture()};
    glBindTextures(3, 3, textures);
    const GlBuffer* blocks[] = {&slots_, &groupOf_, &fetches_, &deposits_};
    for (GLuint i = 0; i < 4; ++i)
        glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kSlots + i, blocks[i]->id());

    for (size_t first = 0; first < paths.pixels(); first += GlPathBuffers::kPixelsPerPiece) {
        const auto count =
            (uint32_t) std::min<size_t>(GlPathBuffers::kPixelsPerPiece, paths.pixels() - first);
        const auto use = [&](const ProgramSource& source) {
            programs_.use(source);
            paths.bind((uint32_t) first, count);
            glUniform1ui(3, (GLuint) (slots_.bytes() / sizeof(uint32_t)) - 1);
        };
        const uint32_t noRecord = kNoPrimitive;
        glClearNamedBufferData(slots_.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &noRecord);
        use(groupHitsSource());
        dispatchOver(count);

        use(rasterFetchSource(mode, surfaces));
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
        glViewport(0, 0, grid.views[0].columns, grid.views[0].rows);
        triangles.draw();
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        if (!views.atEye().empty()) {
            use(fetchAtEyeSource(surfaces));
            glUniform1ui(2, (GLuint) views.atEye().size());
            dispatchOver(views.atEye().size());
        }
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);

        use(fetchSource(paths.format(), surfaces, true));
        dispatchOver(count);
    }
}

} // namespace dirt
