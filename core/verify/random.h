#pragma once

#include <array>
#include <cstdint>

namespace dirt {

/// Random numbers of one ray, counter-based: the same (seed, kind, index) gives the same numbers,
/// whatever was drawn before and on whichever thread. Hash: pcg4d (Jarzynski and Olano, "Hash
/// Functions for GPU Rendering", JCGT 2020).
class RayRandom {
public:
    RayRandom(uint32_t seed, uint32_t kind, uint32_t index)
        : seed_(seed), kind_(kind), index_(index) {}

    /// The next 32 bits.
    uint32_t bits() {
        if ((next_ & 3) == 0) block_ = pcg4d(index_, kind_, next_ >> 2, seed_);
        return block_[next_++ & 3];
    }

    /// Uniform in [0, 1), a multiple of 2^-24.
    double uniform() { return (bits() >> 8) * 0x1p-24; }

    /// Uniform in [0, count); count below 2^32.
    uint32_t below(uint64_t count) { return (uint32_t) ((bits() * count) >> 32); }

private:
    static std::array<uint32_t, 4> pcg4d(uint32_t x, uint32_t y, uint32_t z, uint32_t w) {
        const auto lcg = [](uint32_t v) { return v * 1664525u + 1013904223u; };
        x = lcg(x), y = lcg(y), z = lcg(z), w = lcg(w);
        const auto mix = [&] { x += y * w, y += z * x, z += x * y, w += y * z; };
        mix();
        x ^= x >> 16, y ^= y >> 16, z ^= z >> 16, w ^= w >> 16;
        mix();
        return {x, y, z, w};
    }

    uint32_t seed_, kind_, index_;
    uint32_t next_ = 0;
    std::array<uint32_t, 4> block_{};
};

} // namespace dirt
