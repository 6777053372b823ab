#include "core/preview/ray_panels.h"

#include <limits>

namespace dirt {

namespace {

/// The triangle that blocks a shadow ray: the last that was tested.
const TriangleTrail& blockerOf(const RayTrail& trail) {
    const TriangleTrail* last = trail.atEye.empty() ? nullptr : &trail.atEye.back();
    for (const ViewTrail& view : trail.views)
        for (const TileTrail& tile : view.tiles)
            for (const BinTrail& bin : tile.bins)
                if (!bin.triangles.empty()) last = &bin.triangles.back();
    return *last;
}

} // namespace

bool DrawnRay::hits() const {
    return trail.maxT ? trail.blocked : trail.hit.found();
}

uint32_t DrawnRay::primitive() const {
    return trail.maxT && trail.blocked ? blockerOf(trail).id : trail.hit.primitive;
}

double DrawnRay::end() const {
    if (trail.maxT && trail.blocked) return (double) blockerOf(trail).hit.t;
    if (trail.maxT) return (double) *trail.maxT;
    return trail.hit.found() ? (double) trail.hit.t : std::numeric_limits<double>::infinity();
}

} // namespace dirt
