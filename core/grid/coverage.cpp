#include "core/grid/coverage.h"

#include "core/base/exact_sum.h"
#include "shaders/shared/margins.h"
#include "shaders/shared/tile_coverage.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

// Rounding against the guard band. u = 2^-24; a view spans slopes [-S, S] with n tiles of nominal
// width h = 2 S / n, n <= 8192.
//
// Side planes. A vertex is outside a border of slope s if fl(x - fl(s w)) says so. Its error is at
// most u |s w| plus u of the result, and s itself was rounded: in all the border moves by less than
// 3 u S = 3 u n h / 2 <= h / 1365, and the guard band of h / 128 stays between h / 512 and h / 64.
// Where w is small against x the error is small against x and decides nothing.
//
// Edge planes. The normal a x b is formed in double: products of floats are exact there, so each
// component has one rounding; rounded to float its relative error is u. Where the sign of
// fl(n_x s + n_y t + n_z) is in doubt, |n_z| is about |n_x s + n_y t|, and the last sum is exact.
// So with p = |n_x s| + |n_y t| the normal is good for 2 u p, the products for u p, their sum for u
// p, and the rounding of s and t for u p: 5 u p in all, and with higher orders less than 6 u S
// (|n_x| + |n_y|), as if the corner were 6 u S away. From 1/128 to 1/512 of a tile it is 3/512 h =
// 6/512 S / n: 6 u <= 6/512 / n holds for n <= 32,768; towards 1/64 there is more room.
//
// Vertices behind the eye's plane are replaced by the crossings of the edges with w = 0, as
// directions: a |w_b| + b |w_a|, one rounding a component, so signs are exact.

namespace dirt {
namespace {

/// \p v times a power of two that brings its largest |component| into [0.5, 1), without denormals.
glm::vec3 scaledToUnit(glm::dvec3 v) {
    const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    if (largest == 0.0) return glm::vec3(0.0f);
    int exponent = 0;
    std::frexp(largest, &exponent);
    const double scale = std::ldexp(1.0, -exponent);
    return flushed(glm::vec3(v * scale));
}

/// a x b; each component is the exact difference of two products, rounded once.
glm::dvec3 edgeNormal(glm::vec3 a, glm::vec3 b) {
    return glm::cross(glm::dvec3(a), glm::dvec3(b));
}

/// a . (b × c) with a relative error of at most 2.5 * 2^-27 and the exact sign. With v = 2^-53,
/// n = a × b has a relative error of v in each component, and each product one more. Where the
/// value cancels the last sum is exact, and the first, of what the third term outweighs, is off by
/// v of half of the terms' magnitudes: 2.5 v of them, which kSignDoubt makes 2.5 * 2^-27 of the
/// value.
double orientation(const ViewTriangle& triangle) {
    const auto& v = triangle.vertices;
    for (const glm::dvec3& n : triangle.normals)
        if (n == glm::dvec3(0.0)) return 0.0; // an edge without length, or through the eye
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 terms = triangle.normals[i] * glm::dvec3(v[(i + 2) % 3]);
        const double value = terms.x + terms.y + terms.z;
        if (std::fabs(value) >
            kSignDoubt * (std::fabs(terms.x) + std::fabs(terms.y) + std::fabs(terms.z)))
            return value;
    }
    return tripleProductExact(v[0], v[1], v[2]);
}

void addDirection(ViewTriangle& triangle, glm::dvec3 direction) {
    // An edge through the eye crosses w = 0 there; the eye itself is no direction.
    if (direction == glm::dvec3(0.0)) return;
    triangle.directions[triangle.directionCount++] = scaledToUnit(direction);
}

/// The triangle's directions with w >= 0. False if none has w > 0.
bool clipDirections(ViewTriangle& triangle) {
    const auto& v = triangle.vertices;
    bool inFront = false;
    for (int i = 0; i < 3; ++i) {
        const glm::vec3 a = v[i], b = v[(i + 1) % 3];
        inFront |= a.z > 0.0f;
        if (a.z >= 0.0f) addDirection(triangle, a);
        if ((a.z < 0.0f && b.z > 0.0f) || (a.z > 0.0f && b.z < 0.0f)) {
            const double wa = std::fabs(a.z), wb = std::fabs(b.z);
            addDirection(triangle, {a.x * wb + b.x * wa, a.y * wb + b.y * wa, 0.0});
        }
    }
    return inFront;
}

/// Whether all directions lie strictly beyond a border: before = on the small side of slope.
bool allBefore(const ViewTriangle& triangle, int axis, float slope) {
    for (int i = 0; i < triangle.directionCount; ++i) {
        if (borderDistance(triangle.directions[i], axis, slope) >= 0.0f) return false;
    }
    return true;
}
bool allBehind(const ViewTriangle& triangle, int axis, float slope) {
    for (int i = 0; i < triangle.directionCount; ++i) {
        if (borderDistance(triangle.directions[i], axis, slope) <= 0.0f) return false;
    }
    return true;
}

/// First and last cell of one axis that is not separated by its side planes. Rounding is monotone,
/// so the predicates are monotone in the index, and bisection decides as a loop over all would.
std::pair<int, int> cellRange(const ViewTriangle& triangle, int axis, const std::vector<float>& lo,
                              const std::vector<float>& hi) {
    const auto first = std::partition_point(
        hi.begin(), hi.end(), [&](float slope) { return allBehind(triangle, axis, slope); });
    const auto last = std::partition_point(
        lo.begin(), lo.end(), [&](float slope) { return !allBefore(triangle, axis, slope); });
    return {(int) (first - hi.begin()), (int) (last - lo.begin()) - 1};
}

} // namespace

bool setUpTriangle(const Triangle& triangle, const View& view, ViewTriangle& out) {
    out.vertices = {view.toView(triangle.a), view.toView(triangle.b), view.toView(triangle.c)};
    out.directionCount = 0;
    if (!clipDirections(out)) return false;

    const auto& v = out.vertices;
    for (int i = 0; i < 3; ++i) out.normals[i] = edgeNormal(v[i], v[(i + 1) % 3]);
    out.determinant = orientation(out);
    for (int i = 0; i < 3; ++i)
        out.edges[i] = scaledToUnit(out.determinant < 0.0 ? -out.normals[i] : out.normals[i]);
    return true;
}

TileRange tileRange(const ViewTriangle& triangle, const View& view) {
    const auto [column0, column1] = cellRange(triangle, 0, view.sLo, view.sHi);
    const auto [row0, row1] = cellRange(triangle, 1, view.tLo, view.tHi);
    return {column0, column1, row0, row1};
}

bool edgesSeparate(const ViewTriangle& triangle, const View& view, int column, int row) {
    const glm::vec2 s(view.sLo[column], view.sHi[column]), t(view.tLo[row], view.tHi[row]);
    return std::any_of(triangle.edges.begin(), triangle.edges.end(), [&](const glm::vec3& n) {
        return edgeSeparates(n, triangle.edgeOn(), s, t);
    });
}

bool overlaps(const ViewTriangle& triangle, const View& view, int column, int row) {
    return !allBefore(triangle, 0, view.sLo[column]) && !allBehind(triangle, 0, view.sHi[column]) &&
           !allBefore(triangle, 1, view.tLo[row]) && !allBehind(triangle, 1, view.tHi[row]) &&
           !edgesSeparate(triangle, view, column, row);
}

} // namespace dirt
