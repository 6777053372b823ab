#pragma once

#include "core/grid/geometry.h"

#include <cstddef>
#include <cstring>

namespace dirt {

/// Whether a triangle has, corner for corner, the very bits of the one before it, which has no
/// holes. No ray tells the two apart: t, u and v are the same numbers, so the lower id wins (T3),
/// and a ray that starts on either skips both (T5). Such triangles come by the thousand in broken
/// files, all in the same lists.
inline bool isRepeated(const FrameGeometry& geometry, size_t triangle) {
    static_assert(sizeof(Triangle) == 9 * sizeof(float));
    const Triangle* const triangles = geometry.triangles.data();
    return triangle > 0 &&
           std::memcmp(triangles + triangle, triangles + triangle - 1, sizeof(Triangle)) == 0 &&
           !geometry.mayHaveHoles((uint32_t) triangle - 1);
}

} // namespace dirt
