#pragma once

#include "core/grid/geometry.h"
#include "core/trace/ray.h"

namespace dirt {

/// A ray's intersection with one triangle.
struct TriangleHit {
    float t = 0.0f;
    float u = 0.0f, v = 0.0f; ///< barycentric weights of b and c, absolute error below 2^-23
};

/// Whether the exact ray (t >= 0) meets the closed triangle, decided by exact signs (T4): a ray in
/// the triangle's plane and a triangle without area are no hit; nor is, of a ray that starts in the
/// eye, a triangle that holds the eye. Does not look at ray.skip.
bool intersect(const Ray& ray, const Triangle& triangle, TriangleHit& out);

/// Where rays from one origin meet the plane of a triangle: intersect()'s t, for many directions.
/// \p triangle must outlive it.
class PlaneDistance {
public:
    PlaneDistance(glm::vec3 origin, const Triangle& triangle);

    /// 1 or -1: the side of the plane that the origin is not on; 0 if the plane holds it.
    int side() const { return (numerator_ > 0.0) - (numerator_ < 0.0); }
    /// t of a ray that meets the triangle or its mirror image behind the origin, which is false.
    bool at(glm::vec3 direction, float& t) const;

private:
    const Triangle& triangle_;
    glm::dvec3 normal_;
    double numerator_; ///< of t, with a relative error below 2^-29 and the exact sign
    double norms_;
};

/// The planes through an origin and a triangle's edges, for many directions.
class EdgePlanes {
public:
    /// Weights of a, b and c along a direction: the edge determinants, with exact signs.
    struct Weights {
        double a, b, c;
        double bound; ///< of each one's absolute error
    };

    EdgePlanes(glm::vec3 origin, const Triangle& triangle);
    Weights along(glm::vec3 direction) const;

private:
    glm::vec3 origin_;
    const Triangle& triangle_;
    glm::dvec3 a_, b_, c_;         ///< normals of the planes opposite to the vertices
    double normA_, normB_, normC_; ///< largest |component| of the vertices, from the origin
    double largest_;               ///< product of two of these
};

/// A triangle as rays from one origin meet it: intersect()'s answers, bit for bit, for many
/// directions. \p triangle must outlive it.
class TriangleFrom {
public:
    TriangleFrom(glm::vec3 origin, const Triangle& triangle);
    bool intersect(glm::vec3 direction, TriangleHit& out) const;

private:
    const Triangle& triangle_;
    glm::vec3 origin_;
    EdgePlanes edges_;
    PlaneDistance plane_;
};

/// Whether two triangles have exactly the same three vertices, in any order (T5).
bool sameVertices(const Triangle& a, const Triangle& b);

/// Whether all six numbers of the ray are finite and its direction is not zero (T6).
bool isTraceable(const Ray& ray);

/// The ray without denormals, which backends may or may not flush.
Ray flushedRay(const Ray& ray);

} // namespace dirt
