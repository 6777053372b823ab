#include "app/viewer/error_estimate.h"

#include <cmath>

namespace dirt {

void ErrorEstimate::add(const Image& mean) {
    if (count_ == 0) {
        mean_.assign(mean.pixels.size(), 0.0f);
        squares_.assign(mean.pixels.size(), 0.0f);
    }
    ++count_;
    for (size_t i = 0; i < mean.pixels.size(); ++i) {
        const glm::vec3 p = mean.pixels[i];
        const float now = 0.2126f * p.x + 0.7152f * p.y + 0.0722f * p.z;
        // The sample is before + n (now - before): its two distances multiply to n (n - 1) step^2.
        const float step = now - mean_[i];
        squares_[i] += (float) count_ * (float) (count_ - 1) * step * step;
        mean_[i] = now;
    }
}

double ErrorEstimate::relative() const {
    if (count_ < 2) return 0.0;
    double squares = 0.0, sum = 0.0;
    for (size_t i = 0; i < mean_.size(); ++i) {
        squares += squares_[i];
        sum += mean_[i];
    }
    const auto pixels = (double) mean_.size();
    const double variance = squares / pixels / ((double) count_ * (count_ - 1));
    return sum > 0.0 ? std::sqrt(variance) / (sum / pixels) : 0.0;
}

} // namespace dirt
