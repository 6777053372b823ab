#pragma once

#include "core/base/executor.h"
#include "core/compare/plane.h"
#include "core/io/image.h"

#include <numbers>
#include <vector>

namespace dirt {

/// What the observer of FLIP sees by default: a screen of 3840 pixels on 0.7 m from 0.7 m away.
inline constexpr double kPixelsPerDegree = 3840.0 * std::numbers::pi / 180.0;

/// FLIP of two images in linear Rec.709, clamped to [0, 1], of equal size: for each pixel the
/// difference seen when flipping between them, 0 to 1. (Andersson, Nilsson, Akenine-Möller,
/// Oskarsson, Åström, Fairchild, "FLIP: A Difference Evaluator for Alternating Images", 2020, with
/// the published erratum.) Symmetric, and 0 where the images are equal as far as the filters reach.
Plane flip(const Image& image, const Image& reference, Executor& executor);

/// Exposures in powers of two, from the darkest in which the brightest pixel of \p reference is
/// shown at 0.85 to the one in which the median is, at most one stop apart, two at least. Where the
/// median is 0 that of the positive pixels takes its place; a black reference is shown as it is.
std::vector<double> hdrExposures(const Image& reference);

/// HDR-FLIP of two images in linear Rec.709 of any range; what is negative counts as 0: the largest
/// FLIP over the exposures of the reference, each shown through the ACES curve (Andersson, Nilsson,
/// Shirley, Akenine-Möller, "Visualizing Errors in Rendered High Dynamic Range Images", 2021).
Plane hdrFlip(const Image& image, const Image& reference, Executor& executor);

} // namespace dirt
