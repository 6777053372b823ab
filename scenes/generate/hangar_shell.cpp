#include <cmath>
#include <numbers>

#include "scenes/generate/block.h"
#include "scenes/generate/hangar_hall.h"
#include "scenes/generate/hangar_materials.h"
#include "scenes/generate/loft.h"
#include "scenes/generate/noise.h"

namespace dirt::generate {
namespace {

using namespace hangar;

constexpr double length = hallNear - hallFar;
constexpr double eaves = 11.7;

/// Corrugated sheet facing +z between two corners in the plane z = 0.
void addCorrugated(Mesh& mesh, int material, Vec2 low, Vec2 high) {
    const double period = 0.26;
    const int perWave = mesh.detail().shows(0.2) ? mesh.detail().steps(8, 4) : 1;
    const bool waves = perWave > 1;
    const int columns =
        waves ? static_cast<int>(std::lround((high.x - low.x) / period)) * perWave : 4;
    mesh.addPatch(material, columns, 1, [&](double u, double v) {
        const double x = low.x + (high.x - low.x) * u;
        const double y = low.y + (high.y - low.y) * v;
        const double wave = std::sin(2 * std::numbers::pi * x / period);
        // Flat ridges and valleys, as pressed sheet has.
        const double z = waves ? 0.032 * std::copysign(std::pow(std::abs(wave), 0.5), wave) : 0;
        return SurfacePoint{{x, y, z}, {x, y}};
    });
}

/// One bay of the window band: steel bars before bright glass.
Mesh makeWindow(const Detail& detail, double width, double height) {
    Mesh mesh(detail);
    const double w = width / 2;
    mesh.addQuad(Daylight, {-w, 0, -0.12}, {w, 0, -0.12}, {w, height, -0.12}, {-w, height, -0.12});
    addBlock(mesh, Steel, {-w - 0.08, -0.08, -0.16}, {w + 0.08, 0.02, 0.10}, 0.01);
    addBlock(mesh, Steel, {-w - 0.08, height - 0.02, -0.16}, {w + 0.08, height + 0.08, 0.10}, 0.01);
    const int columns = detail.shows(0.15) ? 8 : 4;
    for (int k = 0; k <= columns; ++k) {
        const double x = -w + width * k / columns;
        const double half = k % 4 == 0 ? 0.06 : 0.022;
        addBlock(mesh, Steel, {x - half, 0, -0.10}, {x + half, height, k % 4 == 0 ? 0.08 : 0.0}, 0);
    }
    for (int k = 1; k < (detail.shows(0.15) ? 4 : 1); ++k) {
        const double y = height * k / 4;
        addBlock(mesh, Steel, {-w, y - 0.02, -0.10}, {w, y + 0.02, 0.01}, 0);
    }
    return mesh;
}

Mesh makeSideWall(const Detail& detail) {
    Mesh mesh(detail);
    const double half = length / 2;
    for (int k = 0; k < 10; ++k) {
        const double x = -half + steelBay * k;
        addBlock(mesh, Concrete, {x + 0.01, 0, -0.3}, {x + steelBay - 0.01, 1.1, 0.10}, 0.025,
                 {2.7 * k, 0.4});
    }
    addBlock(mesh, Steel, {-half, 1.1, -0.2}, {half, 1.17, 0.13}, 0.01);
    addCorrugated(mesh, WallPaint, {-half, 1.15}, {half, 3.4});
    addBlock(mesh, Steel, {-half, 3.38, -0.2}, {half, 3.46, 0.06}, 0.01);
    addCorrugated(mesh, Wall, {-half, 3.44}, {half, 6.0});
    addCorrugated(mesh, Wall, {-half, 8.55}, {half, eaves + 0.4});
    const Mesh window = makeWindow(detail, steelBay - 0.9, 2.4);
    for (int k = 0; k < 10; ++k) {
        mesh.append(window, place({-half + steelBay * (k + 0.5), 6.1, 0}), {1.1 * k, 0});
        mesh.addQuad(Wall, {-half + steelBay * k - 0.4, 5.9, 0.0},
                     {-half + steelBay * k + 0.4, 5.9, 0.0}, {-half + steelBay * k + 0.4, 8.6, 0.0},
                     {-half + steelBay * k - 0.4, 8.6, 0.0});
    }
    return mesh;
}

/// A leaf of the sliding door, 5 m wide and 9 m high, its face at z = 0.
Mesh makeDoorLeaf(const Detail& detail, std::uint32_t seed) {
    Mesh mesh(detail);
    const Vec2 quarry(3 * hashUnit(seed, 1), 3 * hashUnit(seed, 2));
    Mesh sheet(detail);
    addCorrugated(sheet, WallPaint, {-2.45, 0.9}, {2.45, 6.6});
    addCorrugated(sheet, WallPaint, {-2.45, 8.2}, {2.45, 9.0});
    mesh.append(sheet, Transform(1), quarry);
    addBlock(mesh, Hazard, {-2.45, 0.06, -0.06}, {2.45, 0.9, 0.02}, 0.01, quarry);
    for (const double x : {-2.5, -0.06, 2.38}) {
        addBlock(mesh, Steel, {x, 0.02, -0.08}, {x + 0.12, 9.0, 0.12}, 0.012, quarry);
    }
    for (const double y : {0.88, 3.0, 5.1, 6.55, 8.15, 8.95}) {
        addBlock(mesh, Steel, {-2.45, y, -0.06}, {2.45, y + 0.10, 0.10}, 0.012, quarry);
    }
    for (const double side : {-1.0, 1.0}) {
        addBar(mesh, Steel, {side * 2.4, 0.95, 0.06}, {side * 0.05, 3.0, 0.06}, 0.06, 0.06, 0.006);
    }
    const Mesh window = makeWindow(detail, 4.7, 1.4);
    mesh.append(window, place({0, 6.7, 0.02}));
    return mesh;
}

void addEnds(Mesh& mesh) {
    Mesh far(mesh.detail());
    for (std::uint32_t k = 0; k < 6; ++k) {
        far.append(makeDoorLeaf(mesh.detail(), k),
                   place({-12.5 + 5.0 * k, 0, k % 2 == 0 ? 0.0 : 0.22}));
    }
    addBlock(far, Steel, {-20, 9.0, -0.2}, {20, 9.5, 0.5}, 0.02);
    addCorrugated(far, Wall, {-20, 9.5}, {20, 15.6});
    for (const double side : {-1.0, 1.0}) {
        addCorrugated(far, Wall, {side < 0 ? -20 : 15, 1.1}, {side < 0 ? -15 : 20, 9.1});
        addBlock(far, Concrete, {side < 0 ? -20 : 15.05, 0, -0.3},
                 {side < 0 ? -15.05 : 20, 1.1, 0.1}, 0.025);
    }
    mesh.append(far, place({0, 0, hallFar}));
    // The near end is open; its leaves stand pushed aside.
    Mesh near(mesh.detail());
    for (std::uint32_t k = 0; k < 4; ++k) {
        const double side = k % 2 == 0 ? -1 : 1;
        near.append(makeDoorLeaf(mesh.detail(), 10 + k),
                    place({side * (17.5 - 0.3 * (k / 2)), 0, 0.22 * (k / 2)}));
    }
    addBlock(near, Steel, {-20, 9.0, -0.2}, {20, 9.5, 0.5}, 0.02);
    addCorrugated(near, Wall, {-20, 9.5}, {20, 15.6});
    mesh.append(near, place({0, 0, hallNear}, 180));
}

void addFloor(Mesh& mesh) {
    mesh.addPatch(Floor, 8, 12, [](double u, double v) {
        const Vec3 p(hallHalfWidth * (2 * u - 1), 0, 44 - (44 - hallFar) * v);
        return SurfacePoint{p, {p.x + 1.3, -p.z}};
    });
    // Paint lies a millimetre or so above the concrete.
    const auto stripe = [&](int material, Vec2 low, Vec2 high) {
        mesh.addQuad(material, {low.x, 0.0015, high.y}, {high.x, 0.0015, high.y},
                     {high.x, 0.0015, low.y}, {low.x, 0.0015, low.y}, low * 0.37);
    };
    stripe(YellowLine, {-0.075, hallFar}, {0.075, 44});
    for (const double side : {-1.0, 1.0}) {
        stripe(YellowLine, {side * 15.6 - 0.06, hallFar}, {side * 15.6 + 0.06, hallNear});
        stripe(Hazard, {side < 0 ? -15.25 : 14.95, hallNear - 0.8},
               {side < 0 ? -14.95 : 15.25, hallNear});
        for (int k = 0; k < 9; ++k) {
            const double z = hallFar + 3.4 + steelBay * k;
            stripe(WhiteLine, {side < 0 ? -19.5 : 15.7, z - 0.05},
                   {side < 0 ? -15.7 : 19.5, z + 0.05});
        }
    }
    stripe(Hazard, {-15, hallFar + 1.0}, {15, hallFar + 1.4});
    for (int k = 0; k < 24; ++k) { // where wing tips pass
        stripe(WhiteLine, {-14.75, hallFar + 4 + 2.2 * k}, {-14.6, hallFar + 5.1 + 2.2 * k});
        stripe(WhiteLine, {14.6, hallFar + 4 + 2.2 * k}, {14.75, hallFar + 5.1 + 2.2 * k});
    }
}

} // namespace

void addHallShell(Mesh& mesh) {
    addFloor(mesh);
    const Mesh side = makeSideWall(mesh.detail());
    const double middle = (hallNear + hallFar) / 2;
    mesh.append(side, place({-hallHalfWidth, 0, middle}, 90));
    mesh.append(side, place({hallHalfWidth, 0, middle}, -90), {1.7, 0.6});
    addEnds(mesh);
}

} // namespace dirt::generate
