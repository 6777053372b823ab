#pragma once

#include "core/explain/explained_ray.h"
#include "core/preview/view_image.h"

namespace dirt {

// The two drawings of a ray in a view that it enters: what it does in the image plane, and in
// depth.

/// What is drawn of a ray: its way and where it ends.
struct DrawnRay {
    const Grid& grid;
    const FrameGeometry& geometry;
    const RayTrail& trail;

    /// Where the ray is said to end: at its hit, at the light; infinite where it goes on.
    double end() const;
    /// Whether a triangle is met there, and which. The one that blocks a shadow ray may be met in
    /// another tile than that in which it was found.
    bool hits() const;
    uint32_t primitive() const;
};

/// The tiles of a view that are worth showing of a ray: all if they are few, else those that the
/// ray looks at and some around them.
ViewWindow windowOf(const View& view, const ViewTrail& trail);

/// The tiles of \p window: cells looked into, passed over, visited; over them the ray's image.
/// Tiles that are visited are numbered in their order, where there is room.
void drawTilesPanel(Canvas canvas, const DrawnRay& ray, const ViewTrail& trail,
                    const ViewWindow& window);

/// Pixels that the drawing of depths wants; 0 where no tile is visited.
int depthPanelWidth(const ViewTrail& trail);

/// The ray in depth, in \p box: for each tile in the order of visits a column with the tile's depth
/// bounds, bins, triangles tested and the ray between entering and leaving it.
void drawDepthPanel(Canvas canvas, const DrawnRay& ray, const ViewTrail& trail, Box box);

} // namespace dirt
