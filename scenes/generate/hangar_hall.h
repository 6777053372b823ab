#pragma once

#include "scenes/generate/mesh.h"

namespace dirt::generate {

// The hall, in metres: x across, z along, the open door at +z.
constexpr double hallHalfWidth = 20;
constexpr double hallFar = -34;
constexpr double hallNear = 30;
/// From one frame of steel to the next.
constexpr double steelBay = 6.4;

/// Floor with its markings, walls, windows, doors.
void addHallShell(Mesh& mesh);

/// Frames, purlins, roof, light panels, ducts, and the travelling crane.
void addHallSteel(Mesh& mesh);

} // namespace dirt::generate
