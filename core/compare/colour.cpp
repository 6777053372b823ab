#include "core/compare/colour.h"

#include <cmath>

#include <glm/mat3x3.hpp>

namespace dirt {

namespace {

/// XYZ of a chromaticity at Y = 1.
glm::dvec3 xyzOf(double x, double y) {
    return {x / y, 1.0, (1.0 - x - y) / y};
}

const glm::dvec3 kWhite = xyzOf(0.31271, 0.32902);

/// Rec.709's primaries, scaled so that together they are white.
glm::dmat3 makeLinearToXyz() {
    const glm::dmat3 primaries(xyzOf(0.64, 0.33), xyzOf(0.30, 0.60), xyzOf(0.15, 0.06));
    const glm::dvec3 luminance = glm::inverse(primaries) * kWhite;
    return {primaries[0] * luminance[0], primaries[1] * luminance[1], primaries[2] * luminance[2]};
}

const glm::dmat3 kLinearToXyz = makeLinearToXyz();
const glm::dmat3 kXyzToLinear = glm::inverse(kLinearToXyz);

/// CIELab's cube root, linear near zero.
double labCurve(double t) {
    constexpr double kDelta = 6.0 / 29.0;
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
}

} // namespace

glm::dvec3 linearToOpponent(glm::dvec3 rgb) {
    const glm::dvec3 p = kLinearToXyz * rgb / kWhite;
    return {116.0 * p.y - 16.0, 500.0 * (p.x - p.y), 200.0 * (p.y - p.z)};
}

glm::dvec3 opponentToLinear(glm::dvec3 opponent) {
    const double y = (opponent.x + 16.0) / 116.0;
    const glm::dvec3 p(y + opponent.y / 500.0, y, y - opponent.z / 200.0);
    return kXyzToLinear * (p * kWhite);
}

glm::dvec3 linearToLab(glm::dvec3 rgb) {
    const glm::dvec3 p = kLinearToXyz * rgb / kWhite;
    const double x = labCurve(p.x), y = labCurve(p.y), z = labCurve(p.z);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

glm::dvec3 huntAdjusted(glm::dvec3 lab) {
    return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

double hyab(glm::dvec3 lab, glm::dvec3 other) {
    return std::abs(lab.x - other.x) + std::hypot(lab.y - other.y, lab.z - other.z);
}

} // namespace dirt
