#include "core/grid/edges_at_corners.h"

#include "core/base/exact_sum.h"
#include "shaders/shared/tile_clip.h"

namespace dirt {
namespace {

/// n . (s, t, 1) for n = a × b: relative error at most 2^-26, exact sign.
double exactEdgeAtCorner(const glm::dvec3& n, glm::vec3 a, glm::vec3 b, float s, float t) {
    bool sure = false;
    const double value = edgeAtCorner(n, s, t, sure);
    if (sure) return value;
    if (n == glm::dvec3(0.0)) return 0.0; // an edge without length, or through the eye
    return tripleProductExact({s, t, 1.0f}, a, b);
}

} // namespace

void edgesAtCorners(const ViewTriangle& triangle, glm::vec2 s, glm::vec2 t, double (&e)[12]) {
    const auto& v = triangle.vertices;
    for (int k = 0; k < 3; ++k)
        for (int c = 0; c < 4; ++c)
            e[4 * k + c] =
                exactEdgeAtCorner(triangle.normals[k], v[k], v[(k + 1) % 3], s[c & 1], t[c >> 1]);
}

} // namespace dirt
