#include "core/compare/differences.h"

#include "core/base/finite.h"

#include <algorithm>
#include <cmath>

namespace dirt {

uint64_t countNonFinite(const Image& image) {
    return (uint64_t) std::count_if(image.pixels.begin(), image.pixels.end(),
                                    [](glm::vec3 pixel) { return !isFinite(pixel); });
}

double Differences::psnr() const {
    return 20.0 * std::log10(peak / rmse);
}

Differences differencesOf(const Image& image, const Image& reference) {
    Differences result;
    double squares = 0.0, relative = 0.0;
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        const glm::vec3 a = image.pixels[i], b = reference.pixels[i];
        if (!isFinite(a) || !isFinite(b)) continue;
        ++result.pixels;
        for (int c = 0; c < 3; ++c) {
            const double difference = (double) a[c] - (double) b[c];
            const double square = difference * difference;
            squares += square;
            relative += square / ((double) b[c] * (double) b[c] + 0.01);
            result.peak = std::max({result.peak, (double) a[c], (double) b[c]});
            if (std::abs(difference) > result.max) {
                result.max = std::abs(difference);
                result.x = (int) (i % (size_t) image.width);
                result.y = (int) (i / (size_t) image.width);
                result.channel = c;
            }
        }
    }
    const double count = 3.0 * (double) std::max<uint64_t>(result.pixels, 1);
    result.rmse = std::sqrt(squares / count);
    result.relativeMse = relative / count;
    return result;
}

} // namespace dirt
