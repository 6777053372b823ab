#pragma once

#include "core/base/executor.h"
#include "core/compare/plane.h"

#include <vector>

namespace dirt {

/// The part of a two-dimensional kernel that is a product: weights along x and along y, an odd
/// number of each, the middle one at the pixel itself.
struct KernelTerm {
    std::vector<double> x, y;
};

/// A two-dimensional kernel as a sum of products.
using Kernel = std::vector<KernelTerm>;

/// The contrast sensitivity of the eye for the channels of the opponent space, as a spatial filter
/// of unit sum for an observer who sees \p pixelsPerDegree (FLIP, section 4.1.1, table 1).
struct ContrastSensitivity {
    Kernel achromatic, redGreen, blueYellow;
    explicit ContrastSensitivity(double pixelsPerDegree);
};

/// Detectors of edges and points: the first and second derivative of a Gaussian whose standard
/// deviation is half of 0.082 degrees. Their positive weights sum to 1, the negative ones to -1
/// (FLIP, section 4.2).
struct FeatureDetectors {
    Kernel edgeX, edgeY, pointX, pointY;
    explicit FeatureDetectors(double pixelsPerDegree);
};

/// The sum over the kernel's weights times the pixels around each pixel; beyond the rim the nearest
/// pixel is repeated.
Plane filtered(const Plane& plane, const Kernel& kernel, Executor& executor);

} // namespace dirt
