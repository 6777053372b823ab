#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace dirt {

/// Twice the signed area of abc. Coordinates are float32 values, so the differences, and nearly
/// always the products, are exact in double.
inline double turn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Places of a polygon's corners in the plane, in a k-d tree, some of them in use. Answers which of
/// those in use lies in a triangle without looking at all.
class PolygonPoints {
public:
    static constexpr uint32_t kNone = 0xffffffffu;

    /// None of \p points is in use yet. Keeps its memory.
    void set(std::span<const glm::dvec2> points);

    /// Corners that share a place are counted.
    void use(uint32_t corner) { count(place_[corner], +1); }
    void release(uint32_t corner) { count(place_[corner], -1); }
    bool isUsed(uint32_t place) const { return used_[place] > 0; }

    /// The place of a corner, which others may have too.
    uint32_t placeOf(uint32_t corner) const { return place_[corner]; }
    /// How many places there are at most.
    size_t size() const { return place_.size(); }

    /// A place in use that is in triangle abc, which runs counter-clockwise, or where \p closed on
    /// its border, but for its corners; kNone where there is none. By turn() alone, as if each
    /// place were asked.
    uint32_t inside(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, bool closed) const;

private:
    /// A run of places and the box around them; its halves are the nodes 2 i + 1 and 2 i + 2.
    struct Node {
        glm::dvec2 low, high;
        uint32_t begin, end;
        uint32_t used; ///< places in use
    };
    static constexpr uint32_t kLeaf = 8;

    void split(size_t node, uint32_t begin, uint32_t end);
    void count(uint32_t place, int change);

    std::vector<glm::dvec2> points_; ///< of the places
    std::vector<uint32_t> place_;    ///< of each corner
    std::vector<uint32_t> used_;     ///< of each place, how many corners use it
    std::vector<uint32_t> order_;    ///< places, as the nodes have them
    std::vector<uint32_t> leaf_;     ///< of each place
    std::vector<Node> nodes_;
};

} // namespace dirt
