#pragma once

#include "core/frame/surface_views.h"

#include <vector>

namespace dirt {

/// Whether a model is looked at from outside, as an object, or from inside, as a room.
///
/// Each share of its surface is seen from outside as far as directions are open before its front,
/// and from within as far as they are not. A room is what is better seen from within:
/// - of the surface as a whole more is seen from within than from outside, and
/// - from one place inside more of it is seen than from any one place outside; backs are counted
///   off.
/// The second tells a hall from an engine, whose inner surface no place overlooks, and from a tree,
/// where half of what is seen are backs. What shows nothing of its inside is an object, a case,
/// whatever is in it; and so is what is seen whole along an axis: a bowl.
///
/// Of a model that turns nothing but backs outwards, the sides say nothing: it is a closed room, or
/// an object that is wound the wrong way. It is a room if there is something in it, that is, if
/// more of its surface is seen from within than from outside.
struct ModelKind {
    bool room = false;
    bool insideOut = false;         ///< an object whose backs are its outside
    std::vector<double> within;     ///< of each sample, how far it is seen from within: 0 to 1
    std::vector<glm::dvec3> places; ///< of a room: free places inside; grid frame
    std::vector<SurfaceView> views; ///< from each of them
};

ModelKind kindOf(const FrameGeometry& geometry, std::span<const SurfaceSample> samples,
                 Tracer& tracer);

} // namespace dirt
