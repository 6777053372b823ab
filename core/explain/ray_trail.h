#pragma once

#include "core/trace/traverse.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace dirt {

/// Why the exact decision refuses a triangle.
struct Refusal {
    enum class Reason {
        none,     ///< it does not
        filter,   ///< the float filter is certain; the signs below say why
        beside,   ///< the line passes beside it: edges of both signs
        inPlane,  ///< the line lies in its plane, or it has no area: no edge has a sign
        behind,   ///< the line meets it behind the ray's origin
        floatTest ///< by the plain test of Precision::fast
    };
    Reason reason = Reason::none;
    /// The sides on which the edges opposite to a, b and c pass the ray: -1, 0, 1, exact.
    int a = 0, b = 0, c = 0;
};

Refusal refusalOf(const Ray& ray, const Triangle& triangle, Precision precision);

/// A triangle that a ray tested.
struct TriangleTrail {
    uint32_t id;
    Tested result;
    TriangleHit hit; ///< unless it was missed
    Refusal refusal; ///< where it was missed
};

struct BinTrail {
    int bin;
    size_t listed; ///< ids; those that were tested are fewer where a search for any hit ended
    std::vector<TriangleTrail> triangles;
};

struct TileTrail {
    TileVisit visit;
    int column, row;
    DepthBounds bounds;
    int firstBin, lastBin; ///< that the ray may pass, in its order; a hit ends it earlier
    std::vector<BinTrail> bins;
};

struct ViewTrail {
    ViewSpan span;
    std::vector<CellLook> cells;
    std::vector<TileTrail> tiles;
};

/// All that a ray does on its way through a grid, by core's definition.
struct RayTrail {
    Ray ray;
    std::optional<float> maxT; ///< of a search for any hit
    std::vector<TriangleTrail> atEye;
    std::vector<ViewTrail> views;
    TraversalCounts counts;
    Hit hit;              ///< of a search for the nearest
    bool blocked = false; ///< of a search for any: by the last triangle that was tested
};

RayTrail closestTrail(const Grid& grid, const FrameGeometry& geometry, const Ray& ray);
RayTrail anyTrail(const Grid& grid, const FrameGeometry& geometry, const Ray& ray, float maxT);

} // namespace dirt
