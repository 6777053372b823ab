#include "scenes/generate/temples_sky.h"

#include <cmath>

#include <glm/common.hpp>

#include "scenes/generate/loft.h"
#include "scenes/generate/noise.h"
#include "scenes/generate/numbers.h"

namespace dirt::generate {
namespace {

constexpr double lowest = -3;    // degrees
constexpr double strength = 1.7; // radiance of a white texel

// Most of the texture goes to the sky near the horizon; its edges are left out, as it repeats.
constexpr double margin = 0.004;

double rowOf(double elevation) {
    return margin + (1 - 2 * margin) * std::pow((elevation - lowest) / (90 - lowest), 0.6);
}

double elevationOf(double row) {
    const double s = std::clamp((row - margin) / (1 - 2 * margin), 0.0, 1.0);
    return lowest + (90 - lowest) * std::pow(s, 1 / 0.6);
}

glm::dvec3 toSrgb(glm::dvec3 linear) {
    glm::dvec3 result;
    for (int k = 0; k < 3; ++k) {
        const double x = std::clamp(linear[k], 0.0, 1.0);
        result[k] = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    }
    return result;
}

/// Density of high clouds over a place of their plane, in heights of that plane.
double clouds(Vec2 p) {
    // Drawn out by the wind.
    const Vec3 q(0.55 * p.x + 0.15 * p.y, 1.3 * p.y - 0.2 * p.x, 0.3);
    const double banks = fractalSolidNoise(q * 0.35, 2, 811);
    const double wisps = fractalSolidNoise(q * 1.1 + Vec3(0, 0, 0.6 * banks), 6, 812, 0.55);
    return smoothStep(-0.05, 0.75, wisps + 0.75 * banks);
}

glm::dvec3 radiance(double azimuth, double elevation) {
    glm::dvec3 colour = skyRadiance(elevation);
    if (elevation < 1.5) return colour;
    const double distance = 1 / std::tan(elevation * pi / 180);
    const Vec2 place = distance * Vec2(std::cos(azimuth), std::sin(azimuth));
    const double density = clouds(place) * smoothStep(1.5, 7, elevation);
    // Thicker towards the light than behind it: the difference lights the edges.
    const double edge = density - clouds(place + Vec2(-0.10, 0.02));
    const glm::dvec3 lit = glm::dvec3(1.55, 1.42, 1.28) * (0.92 + 0.5 * edge);
    return glm::mix(colour, lit, 0.8 * density);
}

} // namespace

glm::dvec3 skyRadiance(double elevation) {
    static const Keys red{{-3, 1.55}, {0, 1.50}, {5, 1.22}, {12, 0.86}, {30, 0.50}, {90, 0.30}};
    static const Keys green{{-3, 1.38}, {0, 1.38}, {5, 1.30}, {12, 1.10}, {30, 0.80}, {90, 0.52}};
    static const Keys blue{{-3, 1.20}, {0, 1.24}, {5, 1.38}, {12, 1.46}, {30, 1.36}, {90, 1.05}};
    return {red(elevation), green(elevation), blue(elevation)};
}

MaterialRecipe skyMaterial() {
    MaterialRecipe sky{.name = "sky", .diffuse = glm::dvec3(0), .emission = glm::dvec3(strength)};
    sky.glow = {1024,
                [](Vec2 p) { return toSrgb(radiance(pi * p.x, elevationOf(p.y)) / strength); }};
    return sky;
}

void addSky(Mesh& mesh, int material, double radius) {
    // One half of the texture's turn ahead (-z), mirrored behind.
    for (const double side : {-1.0, 1.0}) {
        mesh.addPatch(material, 64, 40,
                      [=](double u, double v) {
                          const double azimuth = pi * (margin + (1 - 2 * margin) * u);
                          const double elevation = elevationOf(margin + (1 - 2 * margin) * v);
                          const double e = elevation * pi / 180;
                          const double a = pi * u;
                          const double r = radius * std::cos(e);
                          return SurfacePoint{
                              {r * std::cos(a), radius * std::sin(e), side * r * std::sin(a)},
                              {azimuth / pi, rowOf(elevation)}};
                      },
                      {.flip = side > 0});
    }
}

} // namespace dirt::generate
