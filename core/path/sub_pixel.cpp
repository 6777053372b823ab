#include "core/path/sub_pixel.h"

#include "shaders/shared/random.h"

#include <cmath>

namespace dirt {

namespace {

constexpr int kBits = 24;

/// Sobol's first dimension, as kBits binary digits from the first behind the point: those of
/// \p index in reverse.
uint32_t reversed(uint32_t index) {
    uint32_t digits = 0;
    for (int k = 0; k < kBits; ++k) digits |= (index >> k & 1) << (kBits - 1 - k);
    return digits;
}

/// His second: Pascal's triangle modulo 2 times the digits of \p index.
uint32_t pascal(uint32_t index) {
    uint32_t digits = 0, column = 1u << (kBits - 1);
    for (int k = 0; k < kBits; ++k, column ^= column >> 1)
        if ((index >> k & 1) != 0) digits ^= column;
    return digits;
}

/// A random binary digit of a box: \p path are the \p depth digits that lead to it along \p axis.
uint32_t randomDigit(uint32_t path, uint32_t depth, uint32_t axis, uint32_t seed) {
    return pcg4d(uvec4(kAllPixels, path, 4 * depth + axis, seed)).x >> 31;
}

/// Exchanges the halves of the pixel, the halves of each half and so on. Of the samples in a box
/// the first one has only zeros among the digits to come, so that what is exchanged is where it
/// goes; with a 1 another leaves it for the other half, and is the first one there.
float scrambled(uint32_t digits, uint32_t axis, uint32_t seed) {
    uint32_t path = 0, side = 0;
    // The depth at which the strata are those of the power of four in which the box's first sample
    // is new. Its digits from there on are 0111 or 1000: 7/16 or 9/16 of its stratum. The very
    // first sample has a whole pixel to itself, but it is the first four that are laid out.
    uint32_t stratum = 2;
    for (uint32_t depth = 0; depth < kBits; ++depth) {
        uint32_t exchanged = side;
        if (depth <= stratum)
            exchanged = side = randomDigit(path, depth, axis, seed);
        else if (depth - stratum < 4)
            exchanged = side ^ 1;
        const uint32_t digit = digits >> (kBits - 1 - depth) & 1;
        if (digit == 1) stratum = (depth + 2) & ~1u;
        path = path << 1 | (exchanged ^ digit);
    }
    return std::ldexp((float) path, -kBits);
}

} // namespace

glm::vec2 subPixelOffset(uint32_t sample, uint32_t seed) {
    return {scrambled(reversed(sample), 0, seed), scrambled(pascal(sample), 1, seed)};
}

} // namespace dirt
