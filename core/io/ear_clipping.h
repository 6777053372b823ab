#pragma once

#include "core/io/index_set.h"
#include "core/io/polygon_points.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace dirt {

/// Cuts polygons into triangles that keep their shape, concave or not (Meisters 1975), in the
/// polygon's projection along the dominant axis of its Newell normal. Holds scratch memory, so
/// that many polygons can be cut without allocating. A corner that was refused is looked at again
/// only when it may have become an ear, so that a polygon of 10^5 corners takes no longer than to
/// read.
class EarClipper {
public:
    /// A triangle by its corners' places in the polygon.
    using Ear = std::array<uint32_t, 3>;

    /// Exactly n - 2 triangles for n >= 3 corners, none for fewer, wound as the polygon is; always
    /// the same for the same corners. Convex polygons of up to 1024 corners become a fan around
    /// corner 0; of more, every second corner is cut off, round after round. Corners that coincide
    /// or lie in line, and polygons that cross themselves, give triangles too, if need be without
    /// area. Valid until the next call.
    std::span<const Ear> operator()(std::span<const glm::vec3> polygon);

private:
    struct Vertex {
        glm::dvec2 position;
        uint32_t previous, next;
        bool convex = false; ///< strictly
        bool cut = false;    ///< off with its ear
    };
    /// What an ear must satisfy; the next one is tried when no corner satisfies the one before.
    enum class Rule {
        proper,     ///< what a polygon that does not cross itself always has (two ears theorem)
        noneInside, ///< strictly convex, no other vertex strictly inside
        convex,     ///< not reflex
        any
    };
    /// A corner that is no ear because of what lies in it.
    struct Watch {
        uint32_t vertex, next;
    };

    void project(std::span<const glm::vec3> polygon);
    double turnAt(uint32_t vertex) const;
    void updateConvexity(uint32_t vertex);
    void findReflex();
    bool isEar(uint32_t vertex, Rule rule);
    bool containsVertex(uint32_t ear, Rule rule);
    uint32_t takeDue(uint32_t from);
    void cut(uint32_t vertex);

    std::vector<Vertex> vertices_;
    std::vector<Ear> ears_;
    IndexSet due_;         ///< corners that may be ears: the others have been refused
    bool anyReflex_;       ///< points_ are those of the polygon
    PolygonPoints points_; ///< in use: of corners that are not convex
    std::vector<glm::dvec2> positions_;
    std::vector<uint32_t> watched_; ///< of each place, the last of its watches
    std::vector<Watch> watches_;
};

} // namespace dirt
