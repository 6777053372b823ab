#include "core/trace/determinant.h"

#include "core/trace/exact_sum.h"

namespace dirt {
namespace {

/// Adds x . (y × z).
void addDeterminant(ExactSum& sum, glm::vec3 x, glm::vec3 y, glm::vec3 z) {
    sum.addProduct(x.x, y.y, z.z);
    sum.addProduct(-x.x, y.z, z.y);
    sum.addProduct(x.y, y.z, z.x);
    sum.addProduct(-x.y, y.x, z.z);
    sum.addProduct(x.z, y.x, z.y);
    sum.addProduct(-x.z, y.y, z.x);
}

} // namespace

// Differences of floats are not exact, so each determinant is expanded into determinants of the
// inputs themselves.

double edgeDeterminantExact(glm::vec3 o, glm::vec3 d, glm::vec3 b, glm::vec3 c) {
    ExactSum sum;
    addDeterminant(sum, d, b, c);
    addDeterminant(sum, d, o, b);
    addDeterminant(sum, d, c, o);
    return sum.value();
}

double planeDeterminantExact(glm::vec3 p, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    ExactSum sum;
    addDeterminant(sum, p, a, b);
    addDeterminant(sum, p, b, c);
    addDeterminant(sum, p, c, a);
    addDeterminant(sum, -a, b, c);
    return sum.value();
}

double directionDeterminantExact(glm::vec3 d, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
    ExactSum sum;
    addDeterminant(sum, d, a, b);
    addDeterminant(sum, d, b, c);
    addDeterminant(sum, d, c, a);
    return sum.value();
}

} // namespace dirt
