#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace dirt {

/// Cuts polygons into triangles that keep their shape, concave or not (Meisters 1975), in the
/// polygon's projection along the dominant axis of its Newell normal. Holds scratch memory, so
/// that many polygons can be cut without allocating.
class EarClipper {
public:
    /// A triangle by its corners' places in the polygon.
    using Ear = std::array<uint32_t, 3>;

    /// Exactly n - 2 triangles for n >= 3 corners, none for fewer, wound as the polygon is; always
    /// the same for the same corners. Convex polygons become a fan around corner 0. Corners that
    /// coincide or lie in line, and polygons that cross themselves, give triangles too, if need be
    /// without area. Valid until the next call.
    std::span<const Ear> operator()(std::span<const glm::vec3> polygon);

private:
    struct Vertex {
        glm::dvec2 position;
        uint32_t previous, next;
        bool convex; ///< strictly
    };
    /// What an ear must satisfy; the next one is tried when no corner satisfies the one before.
    enum class Rule {
        proper,     ///< what a polygon that does not cross itself always has (two ears theorem)
        noneInside, ///< strictly convex, no other vertex strictly inside
        convex,     ///< not reflex
        any
    };

    void project(std::span<const glm::vec3> polygon);
    void updateConvexity(uint32_t vertex);
    bool isEar(uint32_t vertex, Rule rule) const;
    bool containsVertex(uint32_t ear, Rule rule) const;

    std::vector<Vertex> vertices_;
    std::vector<Ear> ears_;
};

} // namespace dirt
