#pragma once

#include "core/trace/intersect.h"

#include <embree3/rtcore.h>

namespace dirt {

/// How far behind the best hit Embree goes on looking, relative to t: Embree's own t errs, and a
/// triangle that it puts a little too far may be the nearest. Its t = T / D is a quotient of dot
/// products in float with an error of some 2^-21 / |cos| at incidence cos, so this covers all but
/// hits within 2^-11 rad of a triangle's plane, and lengthens traversal by a thousandth.
inline constexpr float kLookBehind = 1.0f + 0x1p-10f;

/// A ray query: Embree hands the context to the filter functions. Embree's part comes first.
struct QueryContext {
    RTCIntersectContext embree;
    const FrameGeometry* geometry;
    const Ray* ray;
    Hit best;   ///< of the candidates that core's test accepts
    float maxT; ///< occlusion: hits count below this
    float unit; ///< Embree's t is t times this, as it gets the ray's direction divided by it

    QueryContext(const FrameGeometry& frame, const Ray& query, float limit, float unitOfT)
        : geometry(&frame), ray(&query), maxT(limit), unit(unitOfT) {
        rtcInitIntersectContext(&embree);
    }
};

/// Keeps in QueryContext::best the smallest (core's t, id) of all candidates.
void filterNearest(const RTCFilterFunctionNArguments* args);
/// Ends the query at the first candidate that core's test accepts at t < maxT.
void filterOccluded(const RTCFilterFunctionNArguments* args);
/// Rejects the origin's triangle and those with the same vertices, and nothing else.
void filterSkipped(const RTCFilterFunctionNArguments* args);

} // namespace dirt
