#pragma once

#include "core/grid/settings.h"
#include "core/scene/scene.h"
#include "core/verify/ray_kinds.h"

#include <string>
#include <string_view>
#include <vector>

namespace dirt {

/// A hard variant of any scene that has triangles.
struct Extreme {
    /// Bodies of which more is known than what the judge says.
    enum class Body {
        none,
        closedBox, ///< encloseInBox
        ball       ///< replaceByBall
    };

    std::string_view name;
    /// Changes the scene's mesh, camera, lights, materials and background, and the settings.
    void (*derive)(Scene& scene, GridSettings& grid);
    std::vector<RayKind> kinds{kRayKinds.begin(), kRayKinds.end()};
    Body body = Body::none;
};

/// All of them.
const std::vector<Extreme>& extremes();

/// Null where there is none of that name.
const Extreme* extremeByName(std::string_view name);

} // namespace dirt
