#pragma once

#include "core/io/image.h"

#include <cstdint>
#include <vector>

namespace dirt {

/// Plain figures over the pixels of two images, component by component, with the values as stored.
struct Differences {
    uint64_t pixels = 0;           ///< compared: finite in both images
    double rmse = 0.0;             ///< root of the mean of (a - b)²
    double relativeMse = 0.0;      ///< mean of (a - b)² / (b² + 0.01), b the reference
    double peak = 1.0;             ///< of PSNR: the largest value of either image, 1 at least
    double max = 0.0;              ///< largest |a - b|,
    int x = 0, y = 0, channel = 0; ///< and the first place where it is

    /// 20 log10(peak / rmse) in decibel: infinite for equal images.
    double psnr() const;
};

/// Pixels with a NaN or an infinity.
uint64_t countNonFinite(const Image& image);

/// Compares images of equal size. Pixels that are not finite in both are left out.
Differences differencesOf(const Image& image, const Image& reference);

} // namespace dirt
