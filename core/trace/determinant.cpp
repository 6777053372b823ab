#include "core/trace/determinant.h"

#include "core/base/exact_sum.h"
#include "core/trace/norms.h"
#include "shaders/shared/margins.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace dirt {
// Differences of floats are not exact, so each determinant is expanded into determinants of the
// inputs themselves.

double edgeDeterminantExact(glm::vec3 o, glm::vec3 d, glm::vec3 b, glm::vec3 c) {
    ExactSum sum;
    addTripleProduct(sum, d, b, c);
    addTripleProduct(sum, d, o, b);
    addTripleProduct(sum, d, c, o);
    return sum.value();
}

double planeDeterminantExact(glm::vec3 p, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    ExactSum sum;
    addTripleProduct(sum, p, a, b);
    addTripleProduct(sum, p, b, c);
    addTripleProduct(sum, p, c, a);
    addTripleProduct(sum, -a, b, c);
    return sum.value();
}

double directionDeterminantExact(glm::vec3 d, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    ExactSum sum;
    addTripleProduct(sum, d, a, b);
    addTripleProduct(sum, d, b, c);
    addTripleProduct(sum, d, c, a);
    return sum.value();
}

namespace {

/// Sign of v . (x × y) in double, or 0 where that is in doubt. The bound is derived in
/// intersect.cpp.
int certainSign(const glm::dvec3& v, const glm::dvec3& x, const glm::dvec3& y) {
    const double value = glm::dot(v, glm::cross(x, y));
    const double bound = kEdgeError * oneNorm(v) * maxNorm(x) * maxNorm(y);
    return std::abs(value) > bound ? signOf(value) : 0;
}

} // namespace

int planeSide(glm::vec3 p, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const glm::dvec3 from(a);
    const int side = certainSign(glm::dvec3(p) - from, glm::dvec3(b) - from, glm::dvec3(c) - from);
    return side != 0 ? side : signOf(planeDeterminantExact(p, a, b, c));
}

int directionSide(glm::vec3 d, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    const glm::dvec3 from(a);
    const int side = certainSign(glm::dvec3(d), glm::dvec3(b) - from, glm::dvec3(c) - from);
    return side != 0 ? side : signOf(directionDeterminantExact(d, a, b, c));
}

} // namespace dirt
