#pragma once

#include <cstdint>

#include <glm/vec2.hpp>

namespace dirt {

/// Where in its pixel a sample looks, in [0, 1)^2, the same for all pixels (box filter); multiples
/// of 2^-24. A pure function of both arguments.
///
/// The first two dimensions of Sobol's sequence (USSR Comput. Math. Math. Phys. 7(4), 1967) under a
/// scrambling of Owen's kind: of the first 2^n samples each box of area 2^-n, whose sides are
/// powers of two, holds one. \p seed chooses among such sequences.
///
/// Owen's scrambling is at random throughout, so that a sample lies anywhere in its stratum of the
/// first N, and the part of a pixel before a straight edge along the axes is off by 0.41 / N, the
/// root of the mean square over all edges. It would be 0.289 / N with samples in the middles, which
/// are not those of 4 N: so ours stands near the middle, on a side at random, for the power of four
/// that it is new in, and where it stands for the next is left over: 0.295 / N for 4 samples,
/// 0.319 / N for 16, 0.34 / N from there on.
glm::vec2 subPixelOffset(uint32_t sample, uint32_t seed);

} // namespace dirt
