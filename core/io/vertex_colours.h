#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

/// Gathers the colours that an OBJ file gives its vertices, as they are written: sRGB-encoded, from
/// 0 to 1, or whole numbers from 0 to 255 as some scanners' programs have them.
class VertexColours {
public:
    /// Of a vertex by its place; places ascend. False, and the vertex stays white, where a
    /// component is negative or not finite.
    bool set(size_t vertex, const glm::dvec3& colour);

    /// The largest component of all.
    double largest() const { return largest_; }
    /// Whether all are whole numbers, of which one is above 1: then they are of 255.
    bool areOf255() const { return whole_ && largest_ > 1.0 && largest_ <= 255.0; }

    /// Linear, one for each of \p vertices: white where a vertex has no colour, and where its own
    /// exceeds white in that component. Empty where all are white.
    std::vector<glm::vec3> decoded(size_t vertices) const;

private:
    std::vector<glm::vec3> colours_; ///< negative where a vertex has none
    bool whole_ = true;
    double largest_ = 0.0;
};

} // namespace dirt
