#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scenes/generate/detail.h"

namespace dirt::generate {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Transform = glm::dmat4;

/// A corner as it goes into the file.
struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec2 texcoord; ///< in metres; the writer divides by the material's repeat
};

/// A point of a parametric surface.
struct SurfacePoint {
    Vec3 position;
    Vec2 texcoord;
};

/// Maps (u, v) in the unit square to a surface; outward is du × dv.
using Surface = std::function<SurfacePoint(double u, double v)>;

/// How the edges of a patch are to be treated.
struct PatchOptions {
    bool wrapU = false; ///< u = 0 and u = 1 are one seam, shaded smoothly across
    bool wrapV = false;
    bool flip = false; ///< outward is dv × du
};

/// Triangles by material, with shared vertices.
class Mesh {
public:
    explicit Mesh(Detail detail) : detail_(detail) {}

    const Detail& detail() const { return detail_; }

    /// Tessellates a surface into `columns` by `rows` quads, with smooth normals.
    void addPatch(int material, int columns, int rows, const Surface& surface,
                  PatchOptions options = {});

    /// A planar quad a, b, c, d (counter-clockwise from outside), textured by its plane.
    void addQuad(int material, Vec3 a, Vec3 b, Vec3 c, Vec3 d, Vec2 texcoordShift = Vec2(0));

    /// Adds single vertices and triangles, for what is not a patch.
    std::uint32_t addVertex(Vec3 position, Vec3 normal, Vec2 texcoord);
    void addTriangle(int material, std::uint32_t a, std::uint32_t b, std::uint32_t c);

    /// Copies another mesh in. The transform may turn, move, scale and mirror; `texcoordShift`
    /// keeps copies of one stone from looking alike.
    void append(const Mesh& part, const Transform& transform, Vec2 texcoordShift = Vec2(0));

    std::size_t triangleCount() const { return count_; }
    const std::vector<Vertex>& vertices() const { return vertices_; }

    /// Per material, three vertex indices for each triangle.
    const std::vector<std::vector<std::uint32_t>>& triangles() const { return triangles_; }

private:
    std::vector<std::uint32_t>& trianglesOf(int material);

    Detail detail_;
    std::size_t count_ = 0;
    std::vector<Vertex> vertices_;
    std::vector<std::vector<std::uint32_t>> triangles_;
};

/// Moves, then turns about Y by `degrees` (seen from above, counter-clockwise): translate · rotate.
Transform place(Vec3 position, double degrees = 0);

/// Scales along the axes, before other transforms: place(…) * scaled(…).
Transform scaled(Vec3 factors);

} // namespace dirt::generate
