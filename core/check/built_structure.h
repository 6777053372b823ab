#pragma once

#include "core/frame/backend.h"

#include <optional>

namespace dirt {

/// A structure on the host, to be handed to any backend.
struct BuiltStructure {
    FrameGeometry geometry;
    std::optional<Grid> grid; ///< none: the backend that made it has another structure
};

/// The structure as \p backend makes it of its own triangle buffer.
BuiltStructure buildOn(Backend& backend, const Mesh& mesh, const Camera& camera,
                       const GridSettings& settings);

/// The structure as core defines it, of the triangle buffer that core makes; with a grid.
BuiltStructure defined(const Mesh& mesh, const Camera& camera, const GridSettings& settings);

/// Makes \p built the structure of \p backend, without its passes where it has the same kind; else
/// it builds its own over the same geometry. \p built must stay alive while it is in use.
void hand(const BuiltStructure& built, const Camera& camera, const GridSettings& settings,
          Backend& backend);

} // namespace dirt
