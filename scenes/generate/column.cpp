#include "scenes/generate/column.h"

#include <cmath>

#include "scenes/generate/block.h"
#include "scenes/generate/numbers.h"
#include "scenes/generate/sweep.h"

namespace dirt::generate {
namespace {

constexpr double topShrink = 0.15; // the shaft's top is this much thinner than its foot

/// A shaft swells: it thins slowly at first, then faster.
double entasis(double s) {
    return 1 - topShrink * std::pow(s, 1.8);
}

/// Plinth, torus, scotia, torus: the Attic base, as high as the shaft's radius.
void addBase(Mesh& mesh, const ColumnShape& shape) {
    const double r = shape.radius;
    const double half = 1.4 * r;
    addBlock(mesh, shape.stoneMaterial, {-half, 0, -half}, {half, 0.34 * r, half}, 0.012);
    if (!mesh.detail().shows(0.12)) {
        return;
    }
    Profile profile({1.22 * r, 0.34 * r});
    profile.bow({1.22 * r, 0.58 * r}, 0.5);
    if (mesh.detail().shows(0.18)) {
        profile.line({1.16 * r, 0.60 * r})
            .spline({{1.06 * r, 0.67 * r}, {1.05 * r, 0.73 * r}, {1.12 * r, 0.78 * r}})
            .line({1.12 * r, 0.80 * r})
            .bow({1.10 * r, 0.94 * r}, 0.5)
            .line({1.06 * r, 0.96 * r})
            .spline({{1.01 * r, 1.02 * r}, {r, 1.10 * r}});
    } else {
        profile.line({r, 1.1 * r});
    }
    addLathe(mesh, shape.stoneMaterial, profile, mesh.detail().steps(24, 5));
}

void addShaft(Mesh& mesh, const ColumnShape& shape, double low, double high) {
    const int perFlute = mesh.detail().steps(6, 4);
    const bool fluted = shape.flutes > 0 && mesh.detail().shows(0.30);
    const int sides = fluted ? shape.flutes * perFlute : mesh.detail().steps(28, 5);
    const int rows = mesh.detail().steps(shape.twist != 0 ? 30 : 8);
    const double length = high - low;
    const auto surface = [&](double u, double v) -> SurfacePoint {
        // Rows crowd at both ends, where the flutes run out.
        const double s = fluted ? v + 0.11 * std::sin(turn * v) * -1 : v;
        double radius = shape.radius * entasis(s);
        const double angle = -turn * (u < 1 ? u : 0);
        if (fluted) {
            const double phase = 0.5 * shape.flutes * (angle + turn * shape.twist * s);
            const double flute = std::pow(std::abs(std::sin(phase)), 0.75);
            const double end = 0.12 * shape.radius / length + 0.02;
            const double depth = smoothStep(0.01, 0.01 + end, s) * smoothStep(0.99, 0.99 - end, s);
            radius *= 1 - 0.085 * flute * depth;
        }
        return {{radius * std::cos(angle), low + s * length, radius * std::sin(angle)},
                {u * turn * shape.radius, s * length}};
    };
    mesh.addPatch(shape.shaftMaterial, sides, rows, surface, {.wrapU = true});
}

} // namespace

Mesh makeColumn(const Detail& detail, const ColumnShape& shape) {
    Mesh mesh(detail);
    addBase(mesh, shape);
    const double neck = shape.height - shape.capital;
    addShaft(mesh, shape, (detail.shows(0.12) ? 1.1 : 0.34) * shape.radius, neck);
    mesh.append(
        makeCapital(detail, shape.stoneMaterial, shape.radius * (1 - topShrink), shape.capital),
        place({0, neck, 0}));
    return mesh;
}

} // namespace dirt::generate
