#include "backend_gl/ray_caster.h"

#include "backend_gl/groups.h"
#include "core/base/error.h"

#include <algorithm>
#include <cstddef>

namespace dirt {
namespace {

/// What trace.comp has before the rays' states.
struct StatesHeader {
    uint32_t traced, found;
    uint32_t unfinished, cut; ///< where rays go on in further dispatches
};

/// Of a ray in one dispatch; fewer where loops are left before that.
constexpr uint32_t kTurns = 1 << 10;

/// Of trace.comp's State.
constexpr size_t kStateBytes = 56;

} // namespace

/// Makes the program current with all that does not depend on the rays.
void RayCaster::begin(const TracedStructure& structure, Search search) {
    structure.views.bind();
    const GLuint textures[] = {structure.bounds.texture(), structure.triangles.texture(),
                               structure.ids.heads(), structure.views.atEyeTexture()};
    glBindTextures(2, 4, textures);
    structure.ids.bindNodes();
    const GridSettings& settings = structure.settings;
    programs_.use(traceSource(search, settings.precision, resumes_, structure.ids.segments(),
                              structure.ids.segmentBits(),
                              structure.cutOuts ? &structure.cutOuts->variant() : nullptr));
    if (structure.cutOuts) structure.cutOuts->bind();
    const int levels = structure.bounds.levels() - 1;
    glUniform1i(1, settings.traversal == Traversal::linear ? 0
                   : settings.maxMip < 0                   ? levels
                                                           : std::min(settings.maxMip, levels));
    glUniform1i(2, settings.mode == ViewMode::single);
    glUniform1i(3, (GLint) structure.views.atEye().size());
}

/// Dispatches until all rays are through. What a ray did in a dispatch that was cut short does not
/// count, and fewer turns follow: until nothing is cut, as hard rays are few.
void RayCaster::resume(uint32_t count) {
    glUniform1ui(5, 3);
    uint32_t turns = kTurns;
    StatesHeader header;
    do {
        header = {}; // what is not read, as the driver has given up, ends the search
        const uint32_t none[2] = {};
        states_.write(offsetof(StatesHeader, unfinished), sizeof none, none);
        glUniform1ui(4, turns);
        glDispatchCompute(groupsOf(count), 1, 1);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
        states_.read(0, sizeof header, &header);
        if (header.cut == 0) {
            turns = std::min(2 * turns, kTurns);
            continue;
        }
        if (turns == 1)
            throw CapabilityError("this OpenGL driver ends loops before they are through");
        turns /= 2;
    } while (header.unfinished > 0);
}

CastCounts RayCaster::run(const BufferRange& rays, const BufferRange& hits, uint32_t count,
                          GLuint block) {
    const size_t bytes = sizeof(StatesHeader) + (resumes_ ? count * kStateBytes : 0);
    if (states_.bytes() < bytes) {
        states_ = {};
        states_ = GlBuffer(bytes);
    }
    glClearNamedBufferSubData(states_.id(), GL_R32UI, 0, (GLsizeiptr) bytes, GL_RED_INTEGER,
                              GL_UNSIGNED_INT, nullptr);
    rays.bind(block);
    hits.bind(block + 1);
    BufferRange{states_.id(), 0, bytes}.bind(block + 2);
    glUniform1ui(0, count);
    if (resumes_) {
        resume(count);
    } else {
        glDispatchCompute(groupsOf(count), 1, 1);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
    }
    StatesHeader header{};
    states_.read(0, sizeof header, &header);
    return {header.traced, header.found};
}

CastCounts RayCaster::cast(const TracedStructure& structure, Search search, const BufferRange& rays,
                           const BufferRange& hits, uint32_t count) {
    begin(structure, search);
    return run(rays, hits, count, (GLuint) structure.ids.segments());
}

CastCounts RayCaster::castPaths(const TracedStructure& structure, const GlPathBuffers& paths,
                                bool masked) {
    begin(structure, Search::paths);
    glBindTextureUnit(8, paths.mask());
    glUniform1i(6, masked);
    CastCounts sum;
    for (size_t first = 0; first < paths.pixels(); first += kMostRays) {
        const auto count = (uint32_t) std::min<size_t>(kMostRays, paths.pixels() - first);
        glUniform1ui(7, (GLuint) first);
        const CastCounts counts =
            run(paths.rays((uint32_t) first, count), paths.hits((uint32_t) first, count), count,
                (GLuint) structure.ids.segments());
        sum.rays += counts.rays;
        sum.hits += counts.hits;
    }
    return sum;
}

} // namespace dirt
