#include "scenes/generate/fountain.h"

#include <cmath>
#include <numbers>

#include "scenes/generate/atrium_materials.h"
#include "scenes/generate/numbers.h"
#include "scenes/generate/sweep.h"

namespace dirt::generate {
namespace {

/// Still water with rings around the middle, where drops fall in.
void addWater(Mesh& mesh, double radius, double y, int rings) {
    const auto surface = [=](double u, double v) -> SurfacePoint {
        const double r = radius * v;
        const double angle = -turn * (u < 1 ? u : 0);
        const double ripple =
            0.006 * std::sin(r * 38) * std::exp(-1.4 * r) + 0.002 * std::sin(9 * r + 5 * angle);
        const Vec3 p(r * std::cos(angle), y + (v < 1 ? ripple : 0), r * std::sin(angle));
        return {p, {p.x, p.z}};
    };
    mesh.addPatch(Water, mesh.detail().steps(100, 8), mesh.detail().steps(rings, 2), surface,
                  {.wrapU = true, .flip = true});
}

/// A bowl with gadroons (ribs like petals) on its underside.
void addBowl(Mesh& mesh, double foot, double rim, double low, double high) {
    Profile under({foot, low});
    under.spline({{0.55 * rim, low + 0.18 * (high - low)},
                  {0.86 * rim, low + 0.55 * (high - low)},
                  {0.97 * rim, low + 0.86 * (high - low)}});
    const auto& piece = under.pieces().front();
    const int petals = 20;
    const auto surface = [&](double u, double v) -> SurfacePoint {
        const Vec2 p = piece.at(v);
        const double angle = -turn * (u < 1 ? u : 0);
        const double lobe = std::abs(std::cos(0.5 * petals * angle));
        const double r = p.x * (1 + 0.05 * lobe * std::sin(std::numbers::pi * v));
        return {{r * std::cos(angle), p.y, r * std::sin(angle)}, {u * turn * rim, v * rim}};
    };
    const int sides = mesh.detail().shows(0.24) ? petals * mesh.detail().steps(4, 3) : 12;
    mesh.addPatch(WhiteMarble, sides, mesh.detail().steps(8, 3), surface, {.wrapU = true});
    Profile lip({0.97 * rim, low + 0.86 * (high - low)});
    lip.bow({rim, high}, 0.35)
        .line({0.93 * rim, high})
        .spline({{0.88 * rim, high - 0.05}, {0.6 * rim, high - 0.12}, {0.05, high - 0.15}});
    addLathe(mesh, WhiteMarble, lip, mesh.detail().steps(100, 8));
    addWater(mesh, 0.9 * rim, high - 0.035, 6);
}

} // namespace

Mesh makeFountain(const Detail& detail) {
    Mesh mesh(detail);
    Profile steps({2.35, 0});
    steps.line({2.35, 0.13})
        .line({2.32, 0.15})
        .line({2.0, 0.15})
        .line({2.0, 0.28})
        .line({1.97, 0.30})
        .line({1.5, 0.30});
    addPrism(mesh, Limestone, steps, 8);

    Profile wall({1.62, 0.30});
    wall.line({1.62, 0.40})
        .cyma({1.50, 0.48}, -0.4)
        .line({1.46, 0.50})
        .line({1.46, 0.86})
        .line({1.49, 0.88})
        .cyma({1.62, 0.97}, 0.4)
        .line({1.64, 0.99})
        .bow({1.64, 1.08}, 0.3)
        .line({1.30, 1.08})
        .line({1.28, 1.05})
        .line({1.28, 0.45});
    addPrism(mesh, WhiteMarble, wall, 8);
    // Panels of red marble on the eight sides.
    Profile panel({1.462, 0.56});
    panel.line({1.478, 0.575}).line({1.478, 0.80}).line({1.462, 0.815});
    for (int side = 0; side < 8; ++side) {
        Mesh slab(detail);
        const auto surface = [&](double u, double v) -> SurfacePoint {
            const double y = 0.57 + 0.24 * v;
            const double z = 0.44 * (1 - 2 * u);
            return {{1.475, y, z}, {z + side, y}};
        };
        slab.addPatch(RedMarble, 1, 1, surface);
        mesh.append(slab, place({0, 0, 0}, 45.0 * side));
    }
    addWater(mesh, 1.40, 0.92, 14);

    Profile stem({0.44, 0.45});
    stem.line({0.44, 0.98})
        .cyma({0.30, 1.08}, -0.4)
        .spline(
            {{0.17, 1.16}, {0.15, 1.26}, {0.24, 1.42}, {0.25, 1.52}, {0.15, 1.70}, {0.16, 1.78}})
        .bow({0.2, 1.84}, 0.5);
    addLathe(mesh, WhiteMarble, stem, detail.steps(72, 6));
    addBowl(mesh, 0.2, 0.92, 1.84, 2.12);
    Profile upper({0.17, 1.98});
    upper.spline(
        {{0.10, 2.12}, {0.08, 2.2}, {0.13, 2.34}, {0.13, 2.42}, {0.07, 2.52}, {0.08, 2.6}});
    addLathe(mesh, WhiteMarble, upper, detail.steps(48, 5));
    addBowl(mesh, 0.08, 0.46, 2.6, 2.77);
    Profile finial({0.09, 2.66});
    finial.spline(
        {{0.06, 2.78}, {0.045, 2.83}, {0.09, 2.91}, {0.10, 2.98}, {0.06, 3.07}, {0.0, 3.13}});
    addLathe(mesh, Bronze, finial, detail.steps(48, 5));
    return mesh;
}

} // namespace dirt::generate
