#include "bench/timing.h"

#include <algorithm>

namespace dirt {

double Timing::median() const {
    std::vector<double> sorted = ms;
    std::sort(sorted.begin(), sorted.end());
    const size_t half = sorted.size() / 2;
    return sorted.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
}

double Timing::least() const {
    return *std::min_element(ms.begin(), ms.end());
}

double Timing::most() const {
    return *std::max_element(ms.begin(), ms.end());
}

} // namespace dirt
