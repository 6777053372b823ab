#pragma once

#include "core/base/image.h"

#include <vector>

namespace dirt {

/// How far an image that samples add up to may be from what it converges to: the standard deviation
/// of the mean of a pixel's luminance, in the root mean square over all pixels, relative to the
/// image's mean. Welford's sums, over the samples that the means tell.
class ErrorEstimate {
public:
    /// The mean image after one more sample.
    void add(const Image& mean);
    /// 0 where there are fewer than two samples, or no light.
    double relative() const;

private:
    int count_ = 0;
    std::vector<float> mean_, squares_;
};

} // namespace dirt
