#pragma once

#include "core/trace/ray.h"

#include <bit>

namespace dirt::test {

/// Whether two hits are of the same triangle at the same bits of t, u and v.
inline bool sameHit(const Hit& a, const Hit& b) {
    return a.primitive == b.primitive &&
           std::bit_cast<uint32_t>(a.t) == std::bit_cast<uint32_t>(b.t) &&
           std::bit_cast<uint32_t>(a.u) == std::bit_cast<uint32_t>(b.u) &&
           std::bit_cast<uint32_t>(a.v) == std::bit_cast<uint32_t>(b.v);
}

} // namespace dirt::test
