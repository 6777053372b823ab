#include "scenes/generate/noise.h"

#include "scenes/generate/numbers.h"

#include <cmath>

namespace dirt::generate {
namespace {

/// The remainder, without a division for the values that are nearly always asked for.
int wrap(int value, int period) {
    if (value >= 0 && value < period) return value;
    const int rest = value % period;
    return rest < 0 ? rest + period : rest;
}

/// std::floor is a function call where the target has no instruction for it.
int floorOf(double value) {
    const int truncated = static_cast<int>(value);
    return truncated - (value < truncated ? 1 : 0);
}

/// std::lerp promises more than noise needs, and takes branches for it.
double mix(double a, double b, double t) {
    return a + (b - a) * t;
}

double fade(double t) {
    return t * t * t * (t * (t * 6 - 15) + 10);
}

/// Eight directions suffice and need no table of sines.
double gradientDot(std::uint32_t hash, double x, double y) {
    constexpr double d = 0.70710678118654752;
    constexpr double gradients[8][2] = {{1, 0}, {-1, 0}, {0, 1},  {0, -1},
                                        {d, d}, {d, -d}, {-d, d}, {-d, -d}};
    const auto& gradient = gradients[hash >> 29];
    return gradient[0] * x + gradient[1] * y;
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

glm::dvec3 hashDirection(std::uint32_t a, std::uint32_t b) {
    const double z = hashRange(-1, 1, a, b, 1);
    const double angle = turn * hashUnit(a, b, 2);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), z, r * std::sin(angle)};
}

double periodicNoise(glm::dvec2 point, int period, std::uint32_t seed) {
    const int cellX = floorOf(point.x);
    const int cellY = floorOf(point.y);
    const double x = point.x - cellX;
    const double y = point.y - cellY;
    const int x0 = wrap(cellX, period);
    const int y0 = wrap(cellY, period);
    const int x1 = wrap(x0 + 1, period);
    const int y1 = wrap(y0 + 1, period);
    const auto corner = [seed](int i, int j, double dx, double dy) {
        return gradientDot(
            hashBits(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), seed), dx, dy);
    };
    const double u = fade(x);
    const double low = mix(corner(x0, y0, x, y), corner(x1, y0, x - 1, y), u);
    const double high = mix(corner(x0, y1, x, y - 1), corner(x1, y1, x - 1, y - 1), u);
    return 1.4 * mix(low, high, fade(y));
}

double solidNoise(glm::dvec3 point, std::uint32_t seed) {
    int cell[3];
    double rest[3];
    double weight[3];
    for (int k = 0; k < 3; ++k) {
        cell[k] = floorOf(point[k]);
        rest[k] = point[k] - cell[k];
        weight[k] = fade(rest[k]);
    }
    double value[8];
    for (int corner = 0; corner < 8; ++corner) {
        const int i = corner & 1;
        const int j = corner >> 1 & 1;
        const int k = corner >> 2 & 1;
        const std::uint32_t hash =
            hashBits(static_cast<std::uint32_t>(cell[0] + i),
                     static_cast<std::uint32_t>(cell[1] + j) * 0x9E3779B1u + seed,
                     static_cast<std::uint32_t>(cell[2] + k));
        // The twelve edges of a cube, four of them twice.
        constexpr double gradients[16][3] = {{1, 1, 0}, {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0},
                                             {1, 0, 1}, {-1, 0, 1}, {1, 0, -1}, {-1, 0, -1},
                                             {0, 1, 1}, {0, -1, 1}, {0, 1, -1}, {0, -1, -1},
                                             {1, 1, 0}, {-1, 1, 0}, {0, -1, 1}, {0, -1, -1}};
        const auto& g = gradients[hash >> 28];
        value[corner] = g[0] * (rest[0] - i) + g[1] * (rest[1] - j) + g[2] * (rest[2] - k);
    }
    for (int k = 0; k < 3; ++k) {
        for (int pair = 0; pair < 4 >> k; ++pair) {
            value[pair] = mix(value[2 * pair], value[2 * pair + 1], weight[k]);
        }
    }
    return value[0];
}

double fractalSolidNoise(glm::dvec3 point, int octaves, std::uint32_t seed, double persistence) {
    double sum = 0;
    double weight = 1;
    for (int octave = 0; octave < octaves; ++octave) {
        sum += weight * solidNoise(point, seed + static_cast<std::uint32_t>(octave) * 101);
        point *= 2.0;
        weight *= persistence;
    }
    return sum;
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

} // namespace dirt::generate
