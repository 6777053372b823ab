#pragma once

#include <vector>

#include <boost/math/distributions/chi_squared.hpp>

namespace dirt::test {

/// Probability that counts drawn with the expected means lie as far off as \p counts do.
/// Means should be 5 and more.
inline double chiSquareP(const std::vector<double>& counts, const std::vector<double>& expected) {
    double statistic = 0.0;
    for (size_t i = 0; i < counts.size(); ++i) {
        const double off = counts[i] - expected[i];
        statistic += off * off / expected[i];
    }
    const boost::math::chi_squared distribution((double) counts.size() - 1.0);
    return boost::math::cdf(boost::math::complement(distribution, statistic));
}

/// Tests draw fixed numbers, so this is no chance of failing now and then: it says how improbable a
/// good generator's result may be before we call it a bad one. Too good is as suspicious.
inline constexpr double kLeastP = 1e-4;
inline constexpr double kGreatestP = 1.0 - 1e-4;

} // namespace dirt::test
