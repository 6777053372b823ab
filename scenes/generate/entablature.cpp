#include "scenes/generate/entablature.h"

#include <cmath>
#include <numbers>

#include "scenes/generate/atrium_materials.h"
#include "scenes/generate/block.h"
#include "scenes/generate/sweep.h"

namespace dirt::generate {
namespace {

/// Repeats a small part along the four sides, `spacing` apart, mirror symmetric on each side.
void repeatAround(Mesh& mesh, const Mesh& part, Vec2 halfExtent, double spacing) {
    for (int side = 0; side < 4; ++side) {
        const bool endWall = side % 2 == 1;
        const double half = endWall ? halfExtent.x : halfExtent.y;
        const double depth = endWall ? halfExtent.y : halfExtent.x;
        const Transform turn = place({0, 0, 0}, 90.0 * side);
        const int count = static_cast<int>(2 * half / spacing);
        for (int k = 0; k < count; ++k) {
            const double along = (k - 0.5 * (count - 1)) * spacing;
            mesh.append(part, turn * place({depth, 0, along}, -90), {0.13 * k, 0.07 * k});
        }
    }
}

/// A bracket under the cornice: an S-shaped scroll, its back at z = 0, its top at y = 0.
Mesh makeBracket(const Detail& detail, double length, double height) {
    Mesh mesh(detail);
    Profile outline({0, -height});
    outline.spline({{0.25 * length, -0.98 * height},
                    {0.34 * length, -0.7 * height},
                    {0.55 * length, -0.45 * height},
                    {0.9 * length, -0.42 * height},
                    {1.0 * length, -0.22 * height},
                    {0.94 * length, 0}});
    const auto& piece = outline.pieces().front();
    const double half = 0.06;
    const int rows = detail.steps(8, 2);
    mesh.addPatch(Limestone, 1, rows, [&](double u, double v) {
        const Vec2 p = piece.at(v);
        return SurfacePoint{{half * (2 * u - 1), p.y, p.x}, {half * 2 * u, p.y + p.x}};
    });
    for (int side = -1; side <= 1; side += 2) {
        mesh.addPatch(Limestone, 1, rows,
                      [&](double u, double v) {
                          const Vec2 p = piece.at(v);
                          return SurfacePoint{{side * half, p.y, p.x * u}, {p.x * u, p.y}};
                      },
                      {.flip = side > 0});
    }
    return mesh;
}

} // namespace

void addEntablature(Mesh& mesh, const EntablatureShape& shape) {
    const double h = shape.high - shape.low;
    const double p = shape.projection;
    const auto y = [&](double s) { return shape.low + s * h; };
    Profile architrave({-0.1, y(0)});
    architrave.line({0.03, y(0)}).line({0.03, y(0.14)});
    if (mesh.detail().shows(0.26)) {
        architrave.line({0.05, y(0.145)}).line({0.05, y(0.27)}).cyma({0.09, y(0.33)}, 0.4);
    }
    architrave.line({0.09, y(0.36)}).line({0.03, y(0.37)});
    addInnerRing(mesh, Limestone, architrave, shape.halfExtent);
    Profile frieze({0.03, y(0.37)});
    frieze.line({0.03, y(0.60)});
    addInnerRing(mesh, RedMarble, frieze, shape.halfExtent);
    Profile cornice({0.03, y(0.60)});
    cornice.bow({0.09, y(0.66)}, 0.3)
        .line({0.09, y(0.78)})
        .line({0.86 * p, y(0.79)})
        .line({0.86 * p, y(0.88)})
        .line({0.89 * p, y(0.885)});
    if (mesh.detail().shows(0.15)) {
        cornice.cyma({p, y(0.98)}, 0.4);
    }
    cornice.line({p, y(1.0)}).line({-0.6, y(1.0)});
    addInnerRing(mesh, Limestone, cornice, shape.halfExtent);
    if (!mesh.detail().shows(0.22)) {
        return;
    }
    if (shape.brackets) {
        Mesh bracket = makeBracket(mesh.detail(), 0.72 * p, 0.26 * h);
        Mesh lifted(mesh.detail());
        lifted.append(bracket, place({0, y(0.785), 0.05}));
        repeatAround(mesh, lifted, shape.halfExtent, 0.4);
    } else {
        Mesh dentil(mesh.detail());
        addBlock(dentil, Limestone, {-0.045, y(0.67), 0.02}, {0.045, y(0.775), 0.16}, 0);
        repeatAround(mesh, dentil, shape.halfExtent, mesh.detail().shows(0.31) ? 0.16 : 0.32);
    }
}

void addRoof(Mesh& mesh, Vec2 eaves, double width, double low, double rise) {
    Profile soffit({0, low - 0.05});
    soffit.line({0, low});
    addInnerRing(mesh, Wood, soffit, eaves);
    constexpr double pitch = 0.24;
    for (int side = 0; side < 4; ++side) {
        const bool endWall = side % 2 == 1;
        const double half = endWall ? eaves.x : eaves.y;
        const double depth = endWall ? eaves.y : eaves.x;
        const int rolls = static_cast<int>(std::lround(2 * (half + width) / pitch));
        const int perRoll = mesh.detail().steps(6, 1);
        const int courses = mesh.detail().steps(6, 1);
        Mesh tiles(mesh.detail());
        const auto height = [&](double along, double up) {
            const double phase = along / pitch * std::numbers::pi;
            const double roll = perRoll >= 3 ? 0.055 * std::abs(std::sin(phase)) : 0.03;
            return low + rise * up + roll;
        };
        // Hips: the strip widens outwards. Rolls stay parallel, those at the ends are cut.
        const int columns = perRoll >= 3 ? rolls * perRoll : rolls / 6 + 1;
        tiles.addPatch(RoofTile, columns, courses, [&](double u, double v) {
            const double out = width * v;
            const double along = (half + out) * (2 * u - 1);
            return SurfacePoint{{along, height(along, v), -(depth + out)}, {along, out * 1.1}};
        });
        tiles.addPatch(RoofTile, columns, 1, [&](double u, double v) {
            const double along = half * (2 * u - 1);
            return SurfacePoint{{along, low - 0.02 + (height(along, 0) - low + 0.02) * v, -depth},
                                {along, v * 0.1}};
        });
        mesh.append(tiles, place({0, 0, 0}, 90.0 * side + 90));
    }
}

} // namespace dirt::generate
