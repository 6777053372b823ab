#pragma once

#include "tests/path/chi_square.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/vec3.hpp>

namespace dirt::test {

/// The level at which each of \p tests has to pass for all to pass with 99 %: Šidák's.
inline double sidak(int tests) {
    return -std::expm1(std::log1p(-0.01) / tests);
}

/// Directions above the plane z = 0, counted in bins that are finer towards z = 1 where \p width is
/// below 1: even in q = 1 - (1 + tan^2 / width^2)^(-1/2), which for a width of 1 is 1 - cos, and in
/// the azimuth. What is not there goes into a bin of its own.
class DirectionBins {
public:
    DirectionBins(int rings, int sectors, double width)
        : rings_(rings), sectors_(sectors), width_(width),
          counts_((size_t) (rings * sectors + 1), 0.0) {}

    void count(glm::dvec3 d) {
        if (!(d.z > 0.0)) {
            counts_.back() += 1.0;
            return;
        }
        const double t = (d.x * d.x + d.y * d.y) / (d.z * d.z);
        const int ring = std::min(
            (int) ((1.0 - 1.0 / std::sqrt(1.0 + t / (width_ * width_))) * rings_), rings_ - 1);
        const double turn = std::atan2(d.y, d.x) / (2.0 * std::numbers::pi) + 0.5;
        const int sector = std::min((int) (turn * sectors_), sectors_ - 1);
        counts_[(size_t) (ring * sectors_ + sector)] += 1.0;
    }

    /// p of \p total directions having been drawn with the density \p pdf over solid angle, which
    /// is integrated over each bin by \p steps squared midpoints.
    template <typename Pdf>
    double p(double total, int steps, const Pdf& pdf) const {
        std::vector<double> counts, expected;
        double inBins = 0.0, sparse = 0.0, sparseExpected = 0.0;
        for (int ring = 0; ring < rings_; ++ring)
            for (int sector = 0; sector < sectors_; ++sector) {
                double sum = 0.0;
                for (int i = 0; i < steps * steps; ++i)
                    sum += term(ring + (i / steps + 0.5) / steps,
                                sector + (i % steps + 0.5) / steps, pdf);
                const double mean = total * sum / (steps * steps);
                inBins += mean;
                const double seen = counts_[(size_t) (ring * sectors_ + sector)];
                if (mean < 10.0) {
                    sparse += seen;
                    sparseExpected += mean;
                } else {
                    counts.push_back(seen);
                    expected.push_back(mean);
                }
            }
        // Bins of few are one, with what is missing.
        const double missing = std::max(sparseExpected + total - inBins, 0.0);
        if (missing > 10.0 || counts.empty()) {
            counts.push_back(sparse + counts_.back());
            expected.push_back(missing);
        } else {
            // Hardly anything is expected there: it counts with the fullest bin.
            const auto fullest = std::max_element(expected.begin(), expected.end());
            counts[(size_t) (fullest - expected.begin())] += sparse + counts_.back();
            *fullest += missing;
        }
        return chiSquareP(counts, expected);
    }

private:
    /// pdf times a bin's solid angle at a place in the numbering of rings and sectors.
    template <typename Pdf>
    double term(double ring, double sector, const Pdf& pdf) const {
        const double rest = 1.0 - ring / rings_, w2 = width_ * width_;
        const double t = w2 * (1.0 / (rest * rest) - 1.0), cosine = 1.0 / std::sqrt(1.0 + t);
        // d(cos) = cos^3 / 2 dt, dt = 2 w^2 / rest^3 dq
        const double solid = cosine * cosine * cosine * w2 / (rest * rest * rest) * 2.0 *
                             std::numbers::pi / (rings_ * sectors_);
        const double phi = (sector / sectors_ - 0.5) * 2.0 * std::numbers::pi;
        const double sine = std::sqrt(t) * cosine;
        return solid * pdf(glm::dvec3(sine * std::cos(phi), sine * std::sin(phi), cosine));
    }

    int rings_, sectors_;
    double width_;
    std::vector<double> counts_; ///< the last: those that are not there
};

} // namespace dirt::test
