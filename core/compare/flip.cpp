#include "core/compare/flip.h"

#include "core/compare/colour.h"
#include "core/compare/filters.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>

namespace dirt {

namespace {

constexpr size_t kPixelsPerPiece = 1 << 14;

// Parameters of section 4, as chosen by the authors.
constexpr double kColourExponent = 0.7, kFeatureExponent = 0.5;
constexpr double kKnee = 0.4, kKneeValue = 0.95;

/// An image as FLIP looks at it.
struct Seen {
    std::vector<glm::dvec3> colours; ///< filtered as by the eye, in Hunt-adjusted CIELab
    Plane edgeX, edgeY, pointX, pointY;
};

Seen look(const Image& image, Executor& executor) {
    std::array<Plane, 3> opponent;
    for (Plane& plane : opponent) plane = Plane(image.width, image.height);
    executor.forRange(image.pixels.size(), kPixelsPerPiece, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            const glm::dvec3 p = linearToOpponent(
                glm::clamp(glm::dvec3(image.pixels[i]), glm::dvec3(0.0), glm::dvec3(1.0)));
            for (int c = 0; c < 3; ++c) opponent[c].values[i] = p[c];
        }
    });

    Seen seen;
    const FeatureDetectors detectors(kPixelsPerDegree);
    Plane lightness = opponent[0];
    for (double& value : lightness.values) value = (value + 16.0) / 116.0;
    seen.edgeX = filtered(lightness, detectors.edgeX, executor);
    seen.edgeY = filtered(lightness, detectors.edgeY, executor);
    seen.pointX = filtered(lightness, detectors.pointX, executor);
    seen.pointY = filtered(lightness, detectors.pointY, executor);

    const ContrastSensitivity eye(kPixelsPerDegree);
    opponent[0] = filtered(opponent[0], eye.achromatic, executor);
    opponent[1] = filtered(opponent[1], eye.redGreen, executor);
    opponent[2] = filtered(opponent[2], eye.blueYellow, executor);
    seen.colours.resize(image.pixels.size());
    executor.forRange(image.pixels.size(), kPixelsPerPiece, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            const glm::dvec3 linear = opponentToLinear(
                {opponent[0].values[i], opponent[1].values[i], opponent[2].values[i]});
            seen.colours[i] =
                huntAdjusted(linearToLab(glm::clamp(linear, glm::dvec3(0.0), glm::dvec3(1.0))));
        }
    });
    return seen;
}

double colourDistance(glm::dvec3 a, glm::dvec3 b) {
    return std::pow(hyab(a, b), kColourExponent);
}

/// Green and blue are the farthest two colours of the gamut.
double farthestDistance() {
    return colourDistance(huntAdjusted(linearToLab({0, 1, 0})),
                          huntAdjusted(linearToLab({0, 0, 1})));
}

/// Distances up to 0.4 of the farthest take 95 % of the range.
double colourDifference(double distance, double farthest) {
    const double knee = kKnee * farthest;
    if (distance < knee) return kKneeValue * distance / knee;
    return kKneeValue + (1.0 - kKneeValue) * (distance - knee) / (farthest - knee);
}

} // namespace

Plane flip(const Image& image, const Image& reference, Executor& executor) {
    const Seen a = look(image, executor), b = look(reference, executor);
    const double farthest = farthestDistance();
    Plane result(image.width, image.height);
    executor.forRange(result.values.size(), kPixelsPerPiece, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            const double colour =
                colourDifference(colourDistance(a.colours[i], b.colours[i]), farthest);
            const auto strength = [i](const Plane& x, const Plane& y) {
                return std::hypot(x.values[i], y.values[i]);
            };
            const double edges = strength(a.edgeX, a.edgeY) - strength(b.edgeX, b.edgeY);
            const double points = strength(a.pointX, a.pointY) - strength(b.pointX, b.pointY);
            const double feature = std::pow(
                std::max(std::abs(edges), std::abs(points)) / std::sqrt(2.0), kFeatureExponent);
            result.values[i] = std::pow(colour, 1.0 - feature);
        }
    });
    return result;
}

} // namespace dirt
