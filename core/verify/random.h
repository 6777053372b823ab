#pragma once

#include "shaders/shared/random.h"

#include <cstdint>

#include <glm/vec4.hpp>

namespace dirt {

/// Random numbers of one ray, counter-based: the same (seed, kind, index) gives the same numbers,
/// whatever was drawn before and on whichever thread.
class RayRandom {
public:
    RayRandom(uint32_t seed, uint32_t kind, uint32_t index)
        : seed_(seed), kind_(kind), index_(index) {}

    /// The next 32 bits.
    uint32_t bits() {
        if ((next_ & 3) == 0) block_ = pcg4d({index_, kind_, next_ >> 2, seed_});
        return block_[(int) (next_++ & 3)];
    }

    /// Uniform in [0, 1), a multiple of 2^-24.
    double uniform() { return (bits() >> 8) * 0x1p-24; }

    /// Uniform in [0, count); count below 2^32.
    uint32_t below(uint64_t count) { return (uint32_t) ((bits() * count) >> 32); }

private:
    uint32_t seed_, kind_, index_;
    uint32_t next_ = 0;
    glm::uvec4 block_{0};
};

} // namespace dirt
