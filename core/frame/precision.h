#pragma once

#include "core/base/executor.h"
#include "core/grid/geometry.h"
#include "core/scene/origin.h"

#include <cstdint>
#include <string>
#include <vector>

namespace dirt {

/// How finely float32 resolves a scene. Hits are exact for the frame's geometry; this is how far
/// that geometry may be from what the files say.
struct PrecisionReach {
    Bounds box;                ///< of the triangles, world space
    double diagonal = 0.0;     ///< of that box
    double worldSpacing = 0.0; ///< of float32 at the largest world coordinate
    double frameSpacing = 0.0; ///< of float32 at the largest distance from the eye, world units
    double eyeSpacing = 0.0;   ///< of float32 at the eye's largest world coordinate
    double distance = 0.0;     ///< from the eye to its target, world units
    uint64_t triangles = 0;
    uint64_t withoutArea = 0; ///< triangles that no ray hits, as far as double tells
    uint64_t flattened = 0;   ///< of these, that had an area before they were moved to the eye
};

/// As \p camera sees \p mesh. Costs about as much as moving the mesh to the eye, and a triangle
/// buffer meanwhile.
PrecisionReach precisionReach(const Mesh& mesh, const Camera& camera, ViewMode mode,
                              Executor& executor);

/// A cause for concern, and a line about it.
struct PrecisionWarning {
    enum class Cause { largeCoordinates, distantEye, farFromZero, flattened, withoutArea };

    Cause cause;
    std::string text;
};

std::vector<PrecisionWarning> precisionWarnings(const PrecisionReach& reach);

} // namespace dirt
