#include "backend_gl/loop_probe.h"

#include "backend_gl/gl_objects.h"

#include <cstdint>

namespace dirt {

bool leavesLoops(Programs& programs) {
    constexpr uint32_t kRounds = 1u << 20, kSeed = 1;
    const GlBuffer probe(sizeof kSeed, &kSeed);
    programs.use(loopProbeSource());
    glUniform1ui(0, kRounds);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, probe.id());
    glDispatchCompute(1, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    uint32_t found = 0;
    probe.read(0, sizeof found, &found);
    uint32_t x = kSeed;
    for (uint32_t i = 0; i < kRounds; ++i) x = (x ^ x >> 15) * 0x2c1b3c6du + i;
    return found != x;
}

} // namespace dirt
