#pragma once

#include <vector>

namespace dirt {

/// Times of the same work in all rounds, milliseconds.
struct Timing {
    std::vector<double> ms;
    double median() const;
    double least() const;
    double most() const;
};

} // namespace dirt
