#pragma once

#include <algorithm>
#include <cmath>

/// The norms of the bounds on determinants, of vectors of float or double.
namespace dirt {

template <class Vec>
auto maxNorm(const Vec& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

template <class Vec>
auto oneNorm(const Vec& v) {
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

} // namespace dirt
