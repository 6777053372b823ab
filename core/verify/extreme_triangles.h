#pragma once

#include "core/scene/scene.h"

namespace dirt {

// Triangles that are hard on coverage, clip and intersection, made of those of a scene. Appended
// after them, but where said otherwise; of at most 4,096 triangles each.

/// Two corners, and a millionth of the third's distance from the edge between them.
void addSlivers(Scene& scene);
/// Two corners, and the second again, one unit in the last place aside.
void addNeedles(Scene& scene);

/// Without area: one corner three times; two corners, one of them twice; three different points of
/// a line along an axis, so that they stay on it when the eye is taken off.
void addPoints(Scene& scene);
void addRepeated(Scene& scene);
void addCollinear(Scene& scene);

/// Each triangle six times more, its corners in every order.
void addCoincident(Scene& scene);

/// Cuts triangles in two at the middle of an edge, which their neighbours keep.
void cutEdges(Scene& scene);

/// 10,000 triangles within a thousandth of the scene's size, before the camera.
void crowdOneBin(Scene& scene);

/// One triangle that fills the whole view, 10,000 times as large as the scene, behind all of it.
void coverAll(Scene& scene);

} // namespace dirt
