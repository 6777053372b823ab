#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "scenes/generate/block.h"
#include "scenes/generate/column.h"
#include "scenes/generate/numbers.h"
#include "scenes/generate/sweep.h"

namespace dirt::generate {
namespace {

/// The bell under the leaves, at a height in [0, 1] of its own.
double bellRadius(double neck, double s) {
    return neck * (1.0 + 0.06 * s + 0.34 * s * s * s * s);
}

/// An acanthus leaf on the bell at angle 0 (towards +x): climbs, then its lobed tip curls over.
void addLeaf(Mesh& mesh, int material, double neck, double capital, double height, double width) {
    Profile path({0.06, 0.0});
    path.spline(
        {{0.09, 0.35}, {0.12, 0.68}, {0.22, 0.92}, {0.38, 1.0}, {0.50, 0.93}, {0.50, 0.82}});
    const auto& way = path.pieces().front();
    const auto leaf = [&](double thickness) {
        return [=, &way](double u, double v) -> SurfacePoint {
            const Vec2 p = way.at(v);
            const double side = 2 * u - 1;
            const double lobes = 1 + 0.16 * std::cos(v * 9 * std::numbers::pi);
            const double taper = v < 0.75 ? 1.0 : 1 - 0.75 * (v - 0.75) / 0.25;
            const double half = 0.5 * width * (0.72 + 0.28 * std::sin(v * 3.0)) * lobes * taper;
            // The midrib stands out, the veins beside it are cut in, and the edges lie back.
            const double carve = 0.05 * std::cos(side * 3 * std::numbers::pi) - 0.07 * side * side;
            // The back is a shell's thickness behind, square to the leaf's way.
            const Vec2 ahead = way.at(std::min(1.0, v + 1e-3)) - way.at(std::max(0.0, v - 1e-3));
            const Vec2 tangent(ahead.x * neck, ahead.y * height);
            const Vec2 back = Vec2(tangent.y, -tangent.x) * (thickness / glm::length(tangent));
            const double radius = bellRadius(neck, p.y * height / capital) +
                                  neck * (p.x + carve * (0.4 + v)) - back.x;
            const double y = p.y * height - back.y;
            const double angle = -side * half / neck;
            return {{radius * std::cos(angle), y, radius * std::sin(angle)},
                    {side * half, y + v * 0.2}};
        };
    };
    const int columns = mesh.detail().steps(5, 2);
    const int rows = mesh.detail().steps(8, 2);
    mesh.addPatch(material, columns, rows, leaf(0));
    if (mesh.detail().shows(0.32)) {
        mesh.addPatch(material, std::max(1, columns / 2), std::max(2, rows / 2), leaf(0.05 * neck),
                      {.flip = true});
    }
}

/// A stalk that rises to the abacus' corner and rolls into a scroll, in the XY plane.
Mesh makeVolute(const Detail& detail, int material, double neck, double height) {
    Mesh mesh(detail);
    const Vec2 centre(1.62 * neck, 0.70 * height);
    const double outer = 0.15 * height;
    const auto path = [=](double t) -> Vec3 {
        constexpr double stalk = 0.32;
        if (t < stalk) {
            const double s = t / stalk;
            const Vec2 start(1.02 * neck, 0.42 * height);
            const Vec2 bend(1.12 * neck, centre.y + outer);
            const Vec2 end(centre.x, centre.y + outer);
            const Vec2 p = start * ((1 - s) * (1 - s)) + bend * (2 * s * (1 - s)) + end * (s * s);
            return {p.x, p.y, 0};
        }
        const double s = (t - stalk) / (1 - stalk);
        const double angle = std::numbers::pi / 2 - s * 1.6 * turn;
        const double radius = outer * (1 - 0.82 * s);
        return {centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle), 0};
    };
    addTube(
        mesh, material, path, [=](double t) { return neck * (0.12 - 0.05 * t); },
        detail.steps(18, 5), detail.steps(5, 3));
    return mesh;
}

/// The slab on top: a square with hollowed sides and cut corners.
void addAbacus(Mesh& mesh, int material, double half, double low, double high) {
    Profile profile({0.93, low});
    profile.cyma({1.0, low + 0.6 * (high - low)}).line({1.0, high}).line({0.0, high});
    const auto outline = [=](double u) -> Vec2 {
        const double quarter = u * 4;
        const int side = std::min(3, static_cast<int>(quarter));
        const double s = 2 * (quarter - side) - 1;
        const double x = half * (1.0 - 0.13 * (1 - s * s));
        const double z = -s * half * 0.93;
        const double angle = turn * side / 4;
        return {x * std::cos(angle) + z * std::sin(angle),
                z * std::cos(angle) - x * std::sin(angle)};
    };
    const int perSide = mesh.detail().steps(5, 1);
    for (const auto& piece : profile.pieces()) {
        for (int side = 0; side < 4; ++side) {
            const auto face = [&](double u, double v) -> SurfacePoint {
                const Vec2 p = piece.at(v);
                const Vec2 rim = outline((side + std::min(u, 1 - 1e-9)) / 4) * p.x;
                return {{rim.x, p.y, rim.y}, {u * 2 * half, p.y + rim.x}};
            };
            const auto corner = [&](double u, double v) -> SurfacePoint {
                const Vec2 p = piece.at(v);
                const Vec2 a = outline((side + 1 - 1e-9) / 4) * p.x;
                const Vec2 b = outline((side + 1) % 4 / 4.0) * p.x;
                const Vec2 rim = a + (b - a) * u;
                return {{rim.x, p.y, rim.y}, {u * 0.1 * half, p.y + rim.x}};
            };
            const int rows = piece.steps <= 1 ? 1 : mesh.detail().steps(2);
            mesh.addPatch(material, perSide, rows, face);
            mesh.addPatch(material, 1, rows, corner);
        }
    }
}

} // namespace

Mesh makeCapital(const Detail& detail, int material, double neck, double height) {
    Mesh mesh(detail);
    const double abacus = 0.86 * height;
    const int sides = detail.steps(18, 5);
    if (!detail.shows(0.15)) {
        Profile bell({neck, 0});
        bell.line({1.35 * neck, abacus});
        addLathe(mesh, material, bell, sides);
        const double half = 1.55 * neck;
        addBlock(mesh, material, {-half, abacus, -half}, {half, height, half});
        return mesh;
    }
    Profile bell({neck, 0});
    bell.bow({neck, 0.07 * height}, 0.5);
    std::vector<Vec2> flare;
    for (int k = 1; k <= 4; ++k) {
        const double s = 0.07 + 0.79 * k / 4;
        flare.push_back({bellRadius(neck, s), s * height});
    }
    bell.spline(flare);
    addLathe(mesh, material, bell, sides);
    addAbacus(mesh, material, 1.72 * neck, abacus, height);
    if (detail.shows(0.20)) {
        Mesh lower(detail);
        addLeaf(lower, material, neck, height, 0.42 * height, 0.72 * neck);
        Mesh upper(detail);
        addLeaf(upper, material, neck, height, 0.70 * height, 0.68 * neck);
        for (int k = 0; k < 8; ++k) {
            mesh.append(lower, place({0, 0.06 * height, 0}, 45.0 * k), {0.31 * k, 0.17 * k});
            mesh.append(upper, place({0, 0.06 * height, 0}, 45.0 * k + 22.5), {0.23 * k, 0.29 * k});
        }
    }
    if (detail.shows(0.235)) {
        const Mesh volute = makeVolute(detail, material, neck, height);
        for (int k = 0; k < 4; ++k) {
            mesh.append(volute, place({0, 0, 0}, 45.0 + 90.0 * k) * scaled({1, 1, 1.6}));
        }
    }
    return mesh;
}

} // namespace dirt::generate
