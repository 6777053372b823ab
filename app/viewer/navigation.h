#pragma once

#include "core/scene/camera.h"

namespace dirt {

/// Moves eye and target, in units of the world: along the view, to its right, and along the
/// camera's up direction.
void moveCamera(Camera& camera, double ahead, double right, double up);

/// Turns the view about the eye, radians: to the right about the up direction, and upwards, short
/// of looking along it.
void turnCamera(Camera& camera, double right, double up);

} // namespace dirt
