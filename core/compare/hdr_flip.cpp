#include "core/compare/flip.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace dirt {

namespace {

/// The ACES curve of Narkowicz, (a x² + b x) / (c x² + d x + e), without its exposure of 0.6.
constexpr double kA = 0.6 * 0.6 * 2.51, kB = 0.6 * 0.03;
constexpr double kC = 0.6 * 0.6 * 2.43, kD = 0.6 * 0.59, kE = 0.14;

/// Written so that no finite radiance overflows.
double toneMapped(double x) {
    if (x <= 0.0) return 0.0;
    const double value = x < 1.0 ? (kA * x + kB) * x / ((kC * x + kD) * x + kE)
                                 : (kA + kB / x) / (kC + (kD + kE / x) / x);
    return std::min(value, 1.0);
}

/// The radiance that the curve shows at \p shown: the positive root of a quadratic.
double inverseToneMapped(double shown) {
    const double p = 0.5 * (kB - kD * shown) / (kA - kC * shown);
    const double q = -kE * shown / (kA - kC * shown);
    return -p + std::sqrt(p * p - q);
}

Image shownAt(const Image& image, double exposure) {
    const double factor = std::exp2(exposure);
    Image shown = image;
    for (glm::vec3& pixel : shown.pixels)
        for (int c = 0; c < 3; ++c) pixel[c] = (float) toneMapped(factor * (double) pixel[c]);
    return shown;
}

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + (std::ptrdiff_t)(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2) return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

} // namespace

std::vector<double> hdrExposures(const Image& reference) {
    std::vector<double> luminances;
    for (const glm::vec3& pixel : reference.pixels) {
        const glm::dvec3 p = glm::max(glm::dvec3(pixel), glm::dvec3(0.0));
        luminances.push_back(0.2126 * p.r + 0.7152 * p.g + 0.0722 * p.b);
    }
    const double largest = *std::max_element(luminances.begin(), luminances.end());
    if (largest == 0.0) return {0.0};
    double median = medianOf(luminances);
    if (median == 0.0) {
        std::erase(luminances, 0.0);
        median = medianOf(luminances);
    }

    const double shown = inverseToneMapped(0.85);
    const double first = std::log2(shown / largest), last = std::log2(shown / median);
    if (first == last) return {first};
    const int count = std::max(2, (int) std::ceil(last - first));
    std::vector<double> exposures;
    for (int i = 0; i < count; ++i) exposures.push_back(first + (last - first) * i / (count - 1));
    return exposures;
}

Plane hdrFlip(const Image& image, const Image& reference, Executor& executor) {
    Plane result(image.width, image.height);
    for (const double exposure : hdrExposures(reference)) {
        const Plane map = flip(shownAt(image, exposure), shownAt(reference, exposure), executor);
        for (size_t i = 0; i < result.values.size(); ++i)
            result.values[i] = std::max(result.values[i], map.values[i]);
    }
    return result;
}

} // namespace dirt
