#include "scenes/generate/bunny_room.h"

#include <cmath>
#include <numbers>

#include "scenes/generate/block.h"
#include "scenes/generate/bunny_materials.h"
#include "scenes/generate/loft.h"
#include "scenes/generate/noise.h"
#include "scenes/generate/sweep.h"

namespace dirt::generate {
namespace {

using namespace bunny;

constexpr double front = 3.4; // where floor and left wall end, behind the viewer
constexpr double dado = 0.86;

// The window in the left wall: its opening along z and its height.
constexpr double windowFrom = -1.12;
constexpr double windowTo = -0.22;
constexpr double sill = 0.80;
constexpr double lintel = 2.20;

void addFloor(Mesh& mesh) {
    const double width = 0.145;
    std::uint32_t id = 0;
    for (double x = roomLeft - 0.02; x < roomRight; x += width) {
        double z = roomBack - hashRange(0, 1.4, ++id, 1);
        while (z < front) {
            ++id;
            const double end = z + hashRange(1.3, 2.4, id, 2);
            addBlock(mesh, FloorBoard, {x + 0.0008, -0.03, std::max(z, roomBack - 0.05) + 0.0008},
                     {x + width - 0.0008, hashRange(-0.0012, 0.0, id, 3), end - 0.0008}, 0.0022,
                     {5 * hashUnit(id, 4), 5 * hashUnit(id, 5)});
            z = end;
        }
    }
}

/// Draws a moulding along a wall, from `from` to `to` at the foot of the wall; it projects along
/// `out`.
void addMoulding(Mesh& mesh, int material, const Profile& profile, Vec3 from, Vec3 to, Vec3 out) {
    addSweep(
        mesh, material, profile,
        [=](double t) {
            return PathFrame{from + (to - from) * t,
                             out,
                             {0, 1, 0},
                             t * std::abs(to.x - from.x + to.z - from.z)};
        },
        1);
}

/// Baseboard, panels and chair rail along x from 0 to `length`, facing +z.
Mesh makeWainscot(const Detail& detail, double length) {
    Mesh mesh(detail);
    Profile base({0.022, 0});
    base.line({0.022, 0.12}).cyma({0.012, 0.15}, 0.4).line({0.006, 0.155});
    addMoulding(mesh, WhiteWood, base, {0, 0, 0}, {length, 0, 0}, {0, 0, 1});
    Profile rail({0.006, dado - 0.055});
    rail.bow({0.016, dado - 0.04}, 0.3)
        .line({0.020, dado - 0.032})
        .bow({0.034, dado - 0.008}, 0.25)
        .line({0.034, dado})
        .line({0, dado});
    addMoulding(mesh, WhiteWood, rail, {0, 0, 0}, {length, 0, 0}, {0, 0, 1});
    mesh.addQuad(WhiteWood, {0, 0.1, 0.004}, {length, 0.1, 0.004}, {length, dado, 0.004},
                 {0, dado, 0.004});
    const int panels = std::max(1, static_cast<int>(std::lround(length / 0.5)));
    for (int k = 0; k < panels; ++k) {
        const double a = length * k / panels + 0.055;
        const double b = length * (k + 1) / panels - 0.055;
        const double low = 0.21;
        const double high = dado - 0.115;
        // A raised field within a frame of moulding.
        addBlock(mesh, WhiteWood, {a + 0.035, low + 0.035, 0}, {b - 0.035, high - 0.035, 0.012},
                 0.006);
        for (const auto& [lowEnd, highEnd] : {std::pair{Vec2(a, low), Vec2(b, low + 0.022)},
                                              {Vec2(a, high - 0.022), Vec2(b, high)},
                                              {Vec2(a, low), Vec2(a + 0.022, high)},
                                              {Vec2(b - 0.022, low), Vec2(b, high)}}) {
            addBlock(mesh, WhiteWood, {lowEnd.x, lowEnd.y, 0}, {highEnd.x, highEnd.y, 0.016},
                     0.006);
        }
    }
    return mesh;
}

void addWalls(Mesh& mesh) {
    const double width = roomRight - roomLeft;
    mesh.append(makeWainscot(mesh.detail(), width), place({roomLeft, 0, roomBack}));
    mesh.append(makeWainscot(mesh.detail(), front - roomBack), place({roomLeft, 0, front}, 90));
    mesh.addQuad(Wallpaper, {roomLeft, dado, roomBack}, {roomRight, dado, roomBack},
                 {roomRight, roomHeight, roomBack}, {roomLeft, roomHeight, roomBack});
    // The left wall, in the strips around the window; a strip runs from z to z.
    const auto strip = [&](double z0, double z1, double low, double high) {
        mesh.addQuad(Wallpaper, {roomLeft, low, z1}, {roomLeft, low, z0}, {roomLeft, high, z0},
                     {roomLeft, high, z1}, {-z1, low - dado});
    };
    strip(roomBack, windowFrom, dado, roomHeight);
    strip(windowTo, front, dado, roomHeight);
    strip(windowFrom, windowTo, lintel, roomHeight);
    // Behind the paper the wall is solid, so that no light leaks in.
    const double out = roomLeft - 0.22;
    addBlock(mesh, WhiteWood, {out, -0.1, roomBack - 0.2},
             {roomLeft - 0.002, roomHeight, windowFrom}, 0);
    addBlock(mesh, WhiteWood, {out, -0.1, windowTo}, {roomLeft - 0.002, roomHeight, front}, 0);
    addBlock(mesh, WhiteWood, {out, -0.1, windowFrom}, {roomLeft - 0.002, sill, windowTo}, 0);
    addBlock(mesh, WhiteWood, {out, lintel, windowFrom}, {roomLeft - 0.002, roomHeight, windowTo},
             0);
    addBlock(mesh, WhiteWood, {roomLeft - 0.2, -0.1, roomBack - 0.2},
             {roomRight, roomHeight, roomBack - 0.002}, 0);
    Profile cornice({0.0, roomHeight - 0.13});
    cornice.line({0.012, roomHeight - 0.13})
        .cyma({0.075, roomHeight - 0.03}, 0.5)
        .line({0.085, roomHeight - 0.028})
        .line({0.085, roomHeight});
    addMoulding(mesh, WhiteWood, cornice, {roomLeft, 0, roomBack}, {roomRight, 0, roomBack},
                {0, 0, 1});
    addMoulding(mesh, WhiteWood, cornice, {roomLeft, 0, front}, {roomLeft, 0, roomBack}, {1, 0, 0});
}

void addWindow(Mesh& mesh) {
    // Built facing +z with x along the wall, then turned into the left wall.
    Mesh part(mesh.detail());
    const double half = 0.5 * (windowTo - windowFrom);
    const auto bar = [&](Vec2 low, Vec2 high, double back, double face, double bevel) {
        addBlock(part, WhiteWood, {low.x, low.y, back}, {high.x, high.y, face}, bevel);
    };
    const double casing = 0.085;
    bar({-half - casing, sill - 0.02}, {-half, lintel + casing}, -0.02, 0.022, 0.006);
    bar({half, sill - 0.02}, {half + casing, lintel + casing}, -0.02, 0.022, 0.006);
    bar({-half - casing - 0.02, lintel}, {half + casing + 0.02, lintel + casing + 0.02}, -0.02,
        0.03, 0.008);
    bar({-half - casing - 0.03, sill - 0.035}, {half + casing + 0.03, sill}, -0.15, 0.075, 0.008);
    for (const double side : {-1.0, 1.0}) { // two casements with three panes each
        const double inner = side * 0.012;
        const double outer = side * half;
        const double a = std::min(inner, outer);
        const double b = std::max(inner, outer);
        bar({a, sill}, {a + 0.045, lintel}, -0.12, -0.075, 0.006);
        bar({b - 0.045, sill}, {b, lintel}, -0.12, -0.075, 0.006);
        bar({a + 0.045, sill}, {b - 0.045, sill + 0.055}, -0.12, -0.075, 0.006);
        bar({a + 0.045, lintel - 0.045}, {b - 0.045, lintel}, -0.12, -0.075, 0.006);
        for (int k = 1; k < 3; ++k) {
            const double y = sill + (lintel - sill) * k / 3;
            bar({a + 0.045, y - 0.011}, {b - 0.045, y + 0.011}, -0.112, -0.083, 0.004);
        }
    }
    addRod(part, Brass, {0.03, 1.45, -0.075}, {0.03, 1.45, -0.035}, 0.008);
    addRod(part, Brass, {0.03, 1.455, -0.04}, {0.03, 1.36, -0.035}, 0.009);
    // Curtains, pushed aside, on a rod with rings.
    const double top = lintel + 0.20;
    addRod(part, Brass, {-half - 0.42, top, 0.09}, {half + 0.42, top, 0.09}, 0.013, 14);
    for (const double side : {-1.0, 1.0}) {
        const auto surface = [=](double u, double v) {
            const double height = top - 0.03 - (top - 0.10) * v;
            // Gathered by a band a little below the middle.
            const double band = std::exp(-std::pow((v - 0.58) / 0.16, 2.0));
            const double width = 0.36 * (1 - 0.50 * band) * (1 + 0.12 * v);
            const double folds =
                std::sin(2 * std::numbers::pi * (6.0 * u + 0.12 * std::sin(5 * v)));
            const double depth = (0.034 - 0.014 * band) * (0.8 + 0.3 * std::sin(9 * u + 2 * v));
            const double x = side * (half + 0.40 - 0.03 * band - width * u);
            return SurfacePoint{{x, height, 0.09 + depth * folds}, {0.75 * u, height}};
        };
        part.addPatch(Curtain, mesh.detail().steps(130, 24), mesh.detail().steps(40, 8), surface,
                      {.flip = side < 0});
        part.addPatch(Curtain, mesh.detail().steps(130, 24), mesh.detail().steps(40, 8),
                      [&](double u, double v) {
                          SurfacePoint p = surface(u, v);
                          p.position.z -= 0.003;
                          return p;
                      },
                      {.flip = side > 0});
        const double y = top - 0.03 - (top - 0.10) * 0.58;
        addTube(
            part, Brass,
            [=](double t) {
                const double a = 2 * std::numbers::pi * t;
                return Vec3(side * (half + 0.28) + 0.105 * std::cos(a), y,
                            0.09 + 0.045 * std::sin(a));
            },
            [](double) { return 0.008; }, mesh.detail().steps(30, 8), 6);
    }
    mesh.append(part, place({roomLeft, 0, 0.5 * (windowFrom + windowTo)}, 90));
}

/// A rug of `size`, its middle on the origin: a pile with soft edges, and fringes.
Mesh makeRug(const Detail& detail, Vec2 size) {
    Mesh mesh(detail);
    const auto height = [=](double x, double z) {
        const double edge = std::min(0.5 * size.x - std::abs(x), 0.5 * size.y - std::abs(z));
        const double waves = 0.0025 * fractalSolidNoise({3 * x, 0, 3 * z}, 3, 81);
        return 0.011 * std::min(1.0, 0.25 + edge / 0.012) + waves * std::min(1.0, edge / 0.1);
    };
    mesh.addPatch(RugPile, detail.steps(150, 12), detail.steps(150, 12), [&](double u, double v) {
        const auto spread = [](double t) { return t - 0.012 * std::sin(2 * std::numbers::pi * t); };
        const double x = size.x * (spread(u) - 0.5);
        const double z = size.y * (0.5 - spread(v));
        return SurfacePoint{{x, std::max(0.001, height(x, z)), z}, {u, v}};
    });
    const int threads = detail.number(170, 12);
    for (const double side : {-1.0, 1.0}) {
        for (int k = 0; k < threads; ++k) {
            const auto id = static_cast<std::uint32_t>(k + (side > 0 ? 1000 : 0));
            const double z = size.y * ((k + 0.5) / threads - 0.5);
            const double drift = hashRange(-0.012, 0.012, id, 83);
            const double length = hashRange(0.045, 0.06, id, 84);
            addTube(
                mesh, RugFringe,
                [=](double t) {
                    return Vec3(side * (0.5 * size.x - 0.004 + length * t), 0.008 * (1 - t) + 0.003,
                                z + drift * t * t);
                },
                [](double t) { return 0.0028 * (1.1 - 0.3 * t); }, 2, 4);
        }
    }
    return mesh;
}

void addPicture(Mesh& mesh, Vec2 centre, Vec2 half) {
    Mesh part(mesh.detail());
    Profile frame({0.004, 0.004});
    frame.line({0.0, 0.014})
        .line({-0.010, 0.022})
        .bow({-0.026, 0.030}, 0.3)
        .line({-0.030, 0.034})
        .cyma({-0.060, 0.020}, 0.5)
        .line({-0.060, 0.0});
    addInnerRing(part, Gilt, frame, half);
    const auto sheet = [&](int material, Vec2 extent, double y) {
        part.addPatch(material, 1, 1, [=](double u, double v) {
            return SurfacePoint{{extent.x * (2 * u - 1), y, extent.y * (1 - 2 * v)}, {u, v}};
        });
    };
    sheet(Mount, half, 0.005);
    sheet(Picture, half - Vec2(0.055), 0.006);
    // From lying (y up) to hanging (z out of the wall).
    const Transform hang(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 0, 1, 0), glm::dvec4(0, -1, 0, 0),
                         glm::dvec4(centre.x, centre.y, roomBack + 0.004, 1));
    mesh.append(part, hang);
}

} // namespace

void addRoom(Mesh& mesh) {
    addFloor(mesh);
    addWalls(mesh);
    addWindow(mesh);
    mesh.append(makeRug(mesh.detail(), {2.0, 1.35}), place({0.12, 0, 0.22}, 4));
    addPicture(mesh, {0.02, 1.42}, {0.42, 0.32});
    addPicture(mesh, {-0.80, 1.50}, {0.17, 0.22});
}

} // namespace dirt::generate
