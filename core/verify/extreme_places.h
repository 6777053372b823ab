#pragma once

#include "core/grid/settings.h"
#include "core/scene/scene.h"

namespace dirt {

// Where a scene lies and where its camera stands, at the edge of what float32 holds.

/// All lengths times \p factor, rounded once; the light's flux times its square, so that the
/// picture stays.
void scaleAll(Scene& scene, double factor);

/// Everything moved by \p sizes of its own size, rounded once. Camera and light keep their
/// directions.
void moveAway(Scene& scene, double sizes);

/// The eye on a vertex, in the middle of an edge, inside a triangle, or beside one in its plane:
/// exactly, in the frame's geometry too. What is needed of one triangle's coordinates is rounded to
/// a lattice.
void standOnVertex(Scene& scene);
void standOnEdge(Scene& scene);
void standOnTriangle(Scene& scene);
void standInPlane(Scene& scene);

/// Full view: a triangle in the plane x = \p slope z through the eye, exactly; at 64 pixels a face
/// and tiles of 16, slopes of 0 and 1/2 are tiles' borders, 1 is the border of two faces.
void standOnBorder(Scene& scene, GridSettings& grid, double slope);
/// The same with a vertex on the line x = y = z through the eye: where three faces meet.
void standOnFaceDiagonal(Scene& scene, GridSettings& grid);

/// Small triangles before the eye, at 1e-8 to 1e-2 of the scene's size. The eye is at 0.
void addNear(Scene& scene);
/// Large triangles at 1e4 to 1e8 of the scene's size, around the eye.
void addFar(Scene& scene);

} // namespace dirt
