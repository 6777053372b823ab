#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

/// Deterministic noise: integer hashes only, so every machine makes the same scene.
namespace dirt::generate {

/// Mixes up to three integers into 32 well-scattered bits.
std::uint32_t hashBits(std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0);

/// A hash as a number in [0, 1).
double hashUnit(std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0);

/// A hash as a number in [low, high).
double hashRange(double low, double high, std::uint32_t a, std::uint32_t b = 0,
                 std::uint32_t c = 0);

/// A hash as a direction of length 1, all alike likely.
glm::dvec3 hashDirection(std::uint32_t a, std::uint32_t b);

/// Gradient noise in about [-1, 1] that repeats every `period` cells in both directions.
double periodicNoise(glm::dvec2 point, int period, std::uint32_t seed);

/// Gradient noise in about [-1, 1] through space, with cells of size 1.
double solidNoise(glm::dvec3 point, std::uint32_t seed);

/// Octaves of `solidNoise`.
double fractalSolidNoise(glm::dvec3 point, int octaves, std::uint32_t seed,
                         double persistence = 0.5);

/// Octaves of `periodicNoise` over the unit square: seamless, the first with `period` cells.
double fractalNoise(glm::dvec2 unit, int period, int octaves, std::uint32_t seed,
                    double persistence = 0.5);

} // namespace dirt::generate
