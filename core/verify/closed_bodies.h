#pragma once

#include "core/frame/tracer.h"
#include "core/grid/geometry.h"
#include "core/scene/scene.h"

#include <cstdint>
#include <optional>

namespace dirt {

// Bodies of which it is known, without a judge, what rays do. The counts are of answers, to
// intersect() and to occluded(); none where rounding has left nothing of the body.

/// Of rays from inside the box of encloseInBox(), aimed exactly at points of its edges and corners,
/// and of rays to the light outside, past them: how many are not stopped.
std::optional<uint64_t> countLeaks(Tracer& tracer, const FrameGeometry& geometry,
                                   const Scene& scene, uint32_t rays, uint32_t seed);

/// Of rays that leave the ball of replaceByBall() outwards (offsetOrigin), from faces, edges and
/// corners, at all angles and towards the light: how many it stops. Where exact arithmetic does not
/// find it convex, none are cast.
std::optional<uint64_t> countSelfShadows(Tracer& tracer, const FrameGeometry& geometry,
                                         const Scene& scene, uint32_t rays, uint32_t seed);

} // namespace dirt
