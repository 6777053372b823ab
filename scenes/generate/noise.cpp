#include "scenes/generate/noise.h"

#include <cmath>

namespace dirt::generate {
namespace {

int wrap(int value, int period) {
    const int rest = value % period;
    return rest < 0 ? rest + period : rest;
}

double fade(double t) {
    return t * t * t * (t * (t * 6 - 15) + 10);
}

/// Eight directions suffice and need no table of sines.
double gradientDot(std::uint32_t hash, double x, double y) {
    constexpr double diagonal = 0.70710678118654752;
    switch (hash >> 29) {
    case 0:
        return x;
    case 1:
        return -x;
    case 2:
        return y;
    case 3:
        return -y;
    case 4:
        return (x + y) * diagonal;
    case 5:
        return (x - y) * diagonal;
    case 6:
        return (y - x) * diagonal;
    default:
        return (-x - y) * diagonal;
    }
}

} // namespace

std::uint32_t hashBits(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    std::uint32_t h =
        a * 0x9E3779B1u ^ (b + 0x7F4A7C15u) * 0x85EBCA77u ^ (c + 0x165667B1u) * 0xC2B2AE3Du;
    h = (h ^ h >> 16) * 0x7FEB352Du;
    h = (h ^ h >> 15) * 0x846CA68Bu;
    return h ^ h >> 16;
}

double hashUnit(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return hashBits(a, b, c) * (1.0 / 4294967296.0);
}

double hashRange(double low, double high, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return low + (high - low) * hashUnit(a, b, c);
}

double periodicNoise(glm::dvec2 point, int period, std::uint32_t seed) {
    const double floorX = std::floor(point.x);
    const double floorY = std::floor(point.y);
    const double x = point.x - floorX;
    const double y = point.y - floorY;
    const int x0 = wrap(static_cast<int>(floorX), period);
    const int y0 = wrap(static_cast<int>(floorY), period);
    const int x1 = wrap(x0 + 1, period);
    const int y1 = wrap(y0 + 1, period);
    const auto corner = [seed](int i, int j, double dx, double dy) {
        return gradientDot(
            hashBits(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), seed), dx, dy);
    };
    const double u = fade(x);
    const double low = std::lerp(corner(x0, y0, x, y), corner(x1, y0, x - 1, y), u);
    const double high = std::lerp(corner(x0, y1, x, y - 1), corner(x1, y1, x - 1, y - 1), u);
    return 1.4 * std::lerp(low, high, fade(y));
}

double fractalNoise(glm::dvec2 unit, int period, int octaves, std::uint32_t seed,
                    double persistence) {
    double sum = 0;
    double weight = 1;
    for (int octave = 0; octave < octaves; ++octave) {
        const int cells = period << octave;
        sum += weight * periodicNoise(unit * static_cast<double>(cells), cells,
                                      seed + static_cast<std::uint32_t>(octave) * 101);
        weight *= persistence;
    }
    return sum;
}

CellSample cellNoise(glm::dvec2 unit, int period, std::uint32_t seed) {
    const double x = unit.x * period;
    const double y = unit.y * period;
    const int cellX = static_cast<int>(std::floor(x));
    const int cellY = static_cast<int>(std::floor(y));
    double first = 1e9;
    double second = 1e9;
    std::uint32_t nearest = 0;
    for (int j = cellY - 1; j <= cellY + 1; ++j) {
        for (int i = cellX - 1; i <= cellX + 1; ++i) {
            const auto hash = hashBits(static_cast<std::uint32_t>(wrap(i, period)),
                                       static_cast<std::uint32_t>(wrap(j, period)), seed);
            const double dx = i + hashUnit(hash, 1) - x;
            const double dy = j + hashUnit(hash, 2) - y;
            const double distance = std::sqrt(dx * dx + dy * dy);
            if (distance < first) {
                second = first;
                first = distance;
                nearest = hash;
            } else if (distance < second) {
                second = distance;
            }
        }
    }
    return {first, second - first, nearest};
}

} // namespace dirt::generate
