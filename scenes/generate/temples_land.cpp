#include "scenes/generate/temples_land.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "scenes/generate/implicit.h"
#include "scenes/generate/noise.h"
#include "scenes/generate/numbers.h"
#include "scenes/generate/temples_materials.h"
#include "scenes/generate/temples_sky.h"

namespace dirt::generate {
namespace {

using namespace temples;

/// Ridged noise: sharp crests, in about [0, 1].
double ridged(Vec3 p, int octaves, std::uint32_t seed) {
    double sum = 0;
    double weight = 0.5;
    for (int k = 0; k < octaves; ++k) {
        const double n = 1 - std::abs(solidNoise(p, seed + static_cast<std::uint32_t>(k) * 17));
        sum += weight * n * n;
        p *= 2.03;
        weight *= 0.5;
    }
    return sum;
}

/// Islands and coasts: a crest line at a distance, with a slope towards the eye.
struct Coast {
    double distance;
    double height;
    double roughness; ///< hills per turn
    double from;      ///< noise below this lies under the sea
    std::uint32_t seed;
};

void addCoast(Mesh& mesh, int material, const Coast& coast) {
    const int columns = mesh.detail().steps(700, 60);
    const int rows = mesh.detail().steps(22, 4);
    mesh.addPatch(material, columns, rows,
                  [&](double u, double v) {
                      const double angle = turn * (u < 1 ? u : 0);
                      const Vec3 way(std::cos(angle), 0, -std::sin(angle));
                      const double mass =
                          fractalSolidNoise(way * coast.roughness + Vec3(3.7), 3, coast.seed, 0.45);
                      const double crest = smoothStep(coast.from, coast.from + 0.8, mass);
                      const double d = coast.distance * (1 + 0.30 * v);
                      const Vec3 p = way * d;
                      const double relief = ridged(p * (9.0 / coast.distance), 5, coast.seed + 3);
                      const double slope =
                          std::sin(std::min(1.0, 1.25 * v) * std::numbers::pi * 0.5);
                      const double y =
                          seaLevel - 3 + coast.height * crest * slope * (0.45 + 0.9 * relief);
                      return SurfacePoint{{p.x, y, p.z}, {u, v}};
                  },
                  {.wrapU = true, .flip = true});
}

} // namespace

double groundHeight(double x, double z) {
    const Vec3 p(x, 0, z);
    double y =
        0.35 * fractalSolidNoise(p * 0.11, 3, 201) + 0.05 * fractalSolidNoise(p * 0.9, 3, 202);
    // Where the temple stands it is level.
    const double cx = x - 8;
    const double cz = z + 36;
    const double temple = std::hypot(cx / 15.0, cz / 22.0);
    const double rough = smoothStep(0.7, 1.2, temple);
    const double outcrop = ridged(p * 0.10, 2, 203);
    y = y * (0.25 + 0.75 * rough) +
        0.8 * rough * smoothStep(0.55, 0.75, outcrop) * smoothStep(5.0, 14.0, std::hypot(x, z - 1));
    // Beyond the top the cape breaks off, in crags.
    const double reach =
        std::hypot(x - 12, 0.9 * (z + 18)) + 5 * fractalSolidNoise(p * 0.06, 3, 204);
    const double fall = smoothStep(27, 62, reach);
    const double crags = ridged(p * 0.07, 5, 205);
    y += -54 * fall + 13 * (crags - 0.55) * smoothStep(0.0, 0.35, fall);
    return y;
}

void addGround(Mesh& mesh) {
    const int columns = mesh.detail().steps(560, 48);
    const int rows = mesh.detail().steps(230, 24);
    constexpr double nearest = 0.6;
    constexpr double farthest = 130;
    const auto at = [](double x, double z) {
        return SurfacePoint{{x, groundHeight(x, z), z}, {x, -z}};
    };
    mesh.addPatch(Ground, columns, rows,
                  [&](double u, double v) {
                      // Half of all columns look ahead (-z).
                      const double s = (u < 1 ? u : 0) * 2 - 1;
                      const double angle = turn * (0.25 + 0.5 * (0.45 * s + 0.55 * s * s * s));
                      const double d = nearest * std::pow(farthest / nearest, v);
                      return at(d * std::cos(angle), -d * std::sin(angle));
                  },
                  {.wrapU = true});
    mesh.addPatch(Ground, 8, 8, [&](double u, double v) {
        const double r = 1.02 * nearest;
        return at(r * (2 * u - 1), r * (1 - 2 * v));
    });
}

void addFarView(Mesh& mesh) {
    const int around = mesh.detail().steps(120, 24);
    const double edges[seaBands + 1] = {20, 130, 210, 300, 400, 510, 630, 760, 985};
    for (int k = 0; k < seaBands; ++k) {
        mesh.addPatch(
            Sea + k, around, 1,
            [&](double u, double v) {
                const double angle = turn * (u < 1 ? u : 0);
                const double d = edges[k] + (edges[k + 1] - edges[k]) * v;
                return SurfacePoint{{d * std::cos(angle), seaLevel, d * std::sin(angle)}, {u, v}};
            },
            {.flip = true});
    }
    const Coast coasts[ridgeCount] = {{255, 34, 2.1, 0.16, 301},
                                      {390, 52, 2.6, 0.05, 311},
                                      {540, 76, 3.0, -0.02, 321},
                                      {700, 96, 3.2, -0.12, 331}};
    for (int k = 0; k < ridgeCount; ++k) addCoast(mesh, Ridge + k, coasts[k]);
    // The headland that carries the second temple.
    mesh.addPatch(Ridge, mesh.detail().steps(160, 16), mesh.detail().steps(70, 10),
                  [](double u, double v) {
                      const double angle = turn * (u < 1 ? u : 0);
                      const Vec3 way(std::cos(angle), 0, -std::sin(angle));
                      const Vec3 p = headland + way * (90 * v);
                      const double edge = 30 + 14 * fractalSolidNoise(way * 1.4, 3, 401);
                      const double fall = smoothStep(edge, edge + 48, 90 * v);
                      const double crags = ridged(p * 0.045, 5, 402) - 0.5;
                      const double relief = 16 * crags * smoothStep(0.0, 0.3, fall) + 0.8 * crags;
                      return SurfacePoint{
                          p + Vec3(0, relief - (headland.y - seaLevel + 8) * fall, 0), {u, v}};
                  },
                  {.wrapU = true});
    addSky(mesh, Sky, 1000);
}

Mesh makeRock(const Detail& detail, std::uint32_t kind) {
    Mesh mesh(detail);
    // An ellipsoid cut by planes, as joints cut limestone, and weathered.
    const Vec3 shift = 30.0 * Vec3(hashUnit(kind, 1), hashUnit(kind, 2), hashUnit(kind, 3));
    const Vec3 radii(hashRange(0.5, 0.75, kind, 4), hashRange(0.32, 0.5, kind, 5),
                     hashRange(0.4, 0.6, kind, 6));
    const auto solid = [=](Vec3 p) {
        double d = (glm::length(p / radii) - 1) * 0.45;
        for (std::uint32_t k = 0; k < 9; ++k) {
            const double y = hashRange(-0.5, 1.0, kind, k, 11);
            const double a = turn * hashUnit(kind, k, 12);
            const Vec3 n = glm::normalize(Vec3(std::cos(a), y, std::sin(a)));
            const double reach = glm::length(n * radii) * hashRange(0.62, 0.92, kind, k, 13);
            d = std::max(d, glm::dot(p, n) - reach);
        }
        return d + 0.05 * fractalSolidNoise(p * 3.2 + shift, 5, kind, 0.6);
    };
    addSolid(mesh, Rock, solid, {Vec3(-0.9, -0.62, -0.75), Vec3(0.9, 0.65, 0.75), 0.028, 2.6});
    return mesh;
}

} // namespace dirt::generate
