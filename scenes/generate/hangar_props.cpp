#include "scenes/generate/hangar_props.h"

#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "scenes/generate/block.h"
#include "scenes/generate/hangar_aircraft.h"
#include "scenes/generate/hangar_materials.h"
#include "scenes/generate/loft.h"
#include "scenes/generate/noise.h"
#include "scenes/generate/numbers.h"
#include "scenes/generate/sweep.h"

namespace dirt::generate {
namespace {

using namespace hangar;

void addCastors(Mesh& mesh, double x, double z, double radius) {
    const Mesh wheel = makeWheel(mesh.detail(), radius, 0.6 * radius);
    for (const double sx : {-x, x}) {
        for (const double sz : {-z, z}) {
            mesh.append(wheel, place({sx, radius, sz}, 20 * sx + 35 * sz));
            addRod(mesh, Iron, {sx, radius, sz}, {sx, 2.3 * radius, sz}, 0.25 * radius, 8);
        }
    }
}

} // namespace

Mesh makeDrum(const Detail& detail, int material) {
    Mesh mesh(detail);
    const int sides = detail.steps(44, 10);
    Profile side({0.275, 0.0});
    side.bow({0.29, 0.03}, 0.3).line({0.283, 0.05});
    for (const double y : {0.29, 0.57}) {
        side.line({0.283, y - 0.02}).bow({0.283, y + 0.02}, 0.5);
    }
    side.line({0.283, 0.83}).bow({0.275, 0.88}, 0.35).line({0.268, 0.88}).line({0.266, 0.862});
    side.line({0.0, 0.862});
    addLathe(mesh, material, side, sides);
    Profile bung({0.035, 0.86});
    bung.line({0.035, 0.875}).line({0.0, 0.875});
    Mesh cap(detail);
    addLathe(cap, Polished, bung, detail.steps(14, 6));
    mesh.append(cap, place({0.17, 0, 0.05}));
    return mesh;
}

Mesh makeToolChest(const Detail& detail) {
    Mesh mesh(detail);
    addCastors(mesh, 0.40, 0.17, 0.065);
    addBlock(mesh, ToolRed, {-0.48, 0.15, -0.24}, {0.48, 0.95, 0.20}, 0.012);
    addBlock(mesh, Rubber, {-0.5, 0.95, -0.26}, {0.5, 0.975, 0.26}, 0.008);
    double y = 0.18;
    for (const double h : {0.20, 0.14, 0.12, 0.10, 0.09, 0.09}) {
        addBlock(mesh, ToolRed, {-0.46, y, 0.20}, {0.46, y + h - 0.008, 0.225}, 0.006, {y, h});
        addBlock(mesh, Polished, {-0.40, y + h - 0.034, 0.224}, {0.40, y + h - 0.016, 0.238},
                 0.004);
        y += h;
    }
    addRod(mesh, Polished, {0.53, 0.72, -0.16}, {0.53, 0.72, 0.16}, 0.014, 10);
    // The upper chest, its lid open.
    addBlock(mesh, ToolRed, {-0.40, 0.975, -0.22}, {0.40, 1.27, 0.14}, 0.012);
    for (int k = 0; k < 3; ++k) {
        const double low = 0.985 + 0.09 * k;
        addBlock(mesh, ToolRed, {-0.385, low, 0.14}, {0.385, low + 0.08, 0.16}, 0.005, {0, low});
        addBlock(mesh, Polished, {-0.33, low + 0.056, 0.159}, {0.33, low + 0.07, 0.171}, 0.003);
    }
    Mesh lid(detail);
    addBlock(lid, ToolRed, {-0.40, 0, 0}, {0.40, 0.03, 0.36}, 0.008);
    mesh.append(lid, glm::translate(Transform(1), {0, 1.27, -0.22}) *
                         glm::rotate(Transform(1), -1.75, Vec3(1, 0, 0)));
    for (int k = 0; k < 5; ++k) { // tools left on top
        const double x = -0.4 + 0.17 * k;
        addRod(mesh, Polished, {x, 0.99, 0.17}, {x + 0.13, 0.99, 0.22 - 0.02 * k}, 0.009, 6);
    }
    return mesh;
}

Mesh makeWorkPlatform(const Detail& detail) {
    Mesh mesh(detail);
    const double w = 0.62;
    const auto rod = [&](Vec3 a, Vec3 b, double r = 0.024) {
        addRod(mesh, CraneYellow, a, b, r, 12);
    };
    addCastors(mesh, 0.7, 1.05, 0.10);
    const double deck = 2.1;
    for (const double x : {-w, w}) {
        rod({x, 0.25, -1.05}, {x, deck + 1.05, -1.05});
        rod({x, 0.25, 0.1}, {x, deck + 1.05, 0.1});
        rod({x, 0.25, -1.1}, {x, 0.25, 1.5});
        rod({x, deck - 0.05, -1.1}, {x, deck - 0.05, 0.15});
        rod({x, 0.28, -1.05}, {x, deck - 0.08, 0.1}, 0.018);
        rod({x, deck + 1.05, -1.05}, {x, deck + 1.05, 0.1});
        rod({x, deck + 0.55, -1.05}, {x, deck + 0.55, 0.1}, 0.018);
        rod({x, deck + 1.05, 0.1}, {x, 1.15, 1.5});
        rod({x, 1.15, 1.5}, {x, 0.25, 1.5});
        rod({x, deck + 0.55, 0.1}, {x, 0.70, 1.5}, 0.018);
        addBar(mesh, CraneYellow, {x, deck - 0.1, 0.1}, {x, 0.25, 1.5}, 0.03, 0.16, 0.005);
    }
    for (const double y : {deck + 1.05, deck + 0.55}) {
        rod({-w, y, -1.05}, {w, y, -1.05}, 0.02);
    }
    rod({-w, 0.25, -1.05}, {w, 0.25, -1.05});
    rod({-w, 0.25, 0.1}, {w, 0.25, 0.1});
    addBlock(mesh, Plank, {-w, deck, -1.1}, {w, deck + 0.04, 0.12}, 0.008);
    addBlock(mesh, Hazard, {-w, deck - 0.08, 0.12}, {w, deck + 0.04, 0.14}, 0.004);
    for (int k = 0; k < 8; ++k) {
        const double t = (k + 0.7) / 8.5;
        const double y = deck - t * (deck - 0.25);
        const double z = 0.1 + 1.4 * t;
        addBlock(mesh, Aluminium, {-w + 0.02, y - 0.02, z - 0.11}, {w - 0.02, y + 0.012, z + 0.11},
                 0.006, {0, 0.3 * k});
    }
    return mesh;
}

Mesh makeEngineStand(const Detail& detail) {
    Mesh mesh(detail);
    addCastors(mesh, 0.62, 0.75, 0.11);
    for (const double x : {-0.62, 0.62}) {
        addBlock(mesh, GreenSteel, {x - 0.06, 0.26, -0.85}, {x + 0.06, 0.38, 0.85}, 0.01);
        addBar(mesh, GreenSteel, {x, 0.35, -0.55}, {0.35 * x, 1.25, -0.48}, 0.09, 0.09, 0.008);
        addBar(mesh, GreenSteel, {x, 0.35, 0.3}, {0.45 * x, 1.0, -0.46}, 0.06, 0.06, 0.006);
    }
    addBlock(mesh, GreenSteel, {-0.68, 0.27, -0.84}, {0.68, 0.37, -0.72}, 0.01);
    addBlock(mesh, GreenSteel, {-0.68, 0.27, 0.72}, {0.68, 0.37, 0.84}, 0.01);
    addBlock(mesh, GreenSteel, {-0.30, 1.02, -0.54}, {0.30, 1.5, -0.42}, 0.015);
    mesh.append(makeRadialEngine(detail), place({0, 1.28, -0.06}));
    return mesh;
}

Mesh makeCrate(const Detail& detail, Vec3 size, std::uint32_t seed) {
    Mesh mesh(detail);
    const Vec3 h(size.x / 2, size.y, size.z / 2);
    const auto shift = [seed](std::uint32_t k) {
        return Vec2(5 * hashUnit(seed, k, 1), 5 * hashUnit(seed, k, 2));
    };
    addBlock(mesh, Plank, {-h.x + 0.03, 0.12, -h.z + 0.03}, {h.x - 0.03, h.y - 0.03, h.z - 0.03}, 0,
             shift(1));
    for (const double x : {-h.x, 0.0, h.x}) {
        addBlock(mesh, Plank, {x - 0.05, 0, -h.z}, {x + 0.05, 0.10, h.z}, 0.004, shift(2));
    }
    const int slats = std::max(2, static_cast<int>(size.y / 0.17));
    std::uint32_t id = 3;
    for (int k = 0; k < slats; ++k) {
        const double y0 = 0.11 + (h.y - 0.11) * k / slats;
        const double y1 = 0.11 + (h.y - 0.11) * (k + 1) / slats - 0.012;
        for (const double side : {-1.0, 1.0}) {
            const double out = hashRange(0, 0.004, seed, id);
            addBlock(mesh, Plank, {-h.x, y0, side * h.z - 0.012 - out},
                     {h.x, y1, side * h.z + 0.012 + out}, 0.004, shift(++id));
            addBlock(mesh, Plank, {side * h.x - 0.012 - out, y0, -h.z},
                     {side * h.x + 0.012 + out, y1, h.z}, 0.004, shift(++id));
        }
    }
    for (const double sx : {-1.0, 1.0}) {
        for (const double sz : {-1.0, 1.0}) {
            addBlock(mesh, Plank, {sx * h.x - 0.05, 0.10, sz * (h.z + 0.024) - 0.012},
                     {sx * h.x + 0.05, h.y, sz * (h.z + 0.024) + 0.012}, 0.004, shift(++id));
        }
    }
    const int boards = std::max(2, static_cast<int>(size.x / 0.17));
    for (int k = 0; k < boards; ++k) {
        const double x = -h.x + size.x * k / boards;
        addBlock(mesh, Plank, {x, h.y - 0.024, -h.z - 0.02},
                 {x + size.x / boards - 0.01, h.y, h.z + 0.02}, 0.004, shift(++id));
    }
    mesh.addQuad(Label, {-0.2, 0.45 * h.y, h.z + 0.018}, {0.2, 0.45 * h.y, h.z + 0.018},
                 {0.2, 0.45 * h.y + 0.4, h.z + 0.018}, {-0.2, 0.45 * h.y + 0.4, h.z + 0.018});
    return mesh;
}

Mesh makeGasTrolley(const Detail& detail) {
    Mesh mesh(detail);
    for (const double x : {-0.14, 0.14}) {
        Profile bottle({0.115, 0.0});
        bottle.line({0.115, 1.15})
            .spline({{0.10, 1.27}, {0.045, 1.34}, {0.035, 1.38}})
            .line({0.035, 1.43})
            .line({0, 1.43});
        Mesh one(detail);
        addLathe(one, x < 0 ? DrumBlue : ToolRed, bottle, detail.steps(30, 8));
        addRod(one, Brass, {0, 1.4, 0}, {0, 1.52, 0}, 0.018, 8);
        addRod(one, Brass, {0, 1.47, 0}, {0, 1.47, 0.09}, 0.012, 8);
        Profile wheel({0.0, 1.52});
        wheel.line({0.04, 1.52}).bow({0.04, 1.54}, 0.4).line({0, 1.545});
        addLathe(one, Iron, wheel, detail.steps(12, 6));
        mesh.append(one, place({x, 0.09, 0}));
        addRod(mesh, GreenSteel, {x * 1.9, 0.1, -0.16}, {x * 1.9, 1.25, -0.2}, 0.018, 8);
    }
    addBlock(mesh, GreenSteel, {-0.3, 0.06, -0.2}, {0.3, 0.09, 0.16}, 0.006);
    for (const double y : {0.5, 1.0}) {
        addBlock(mesh, GreenSteel, {-0.28, y, 0.118}, {0.28, y + 0.05, 0.128}, 0.003);
    }
    addRod(mesh, GreenSteel, {-0.27, 1.24, -0.2}, {0.27, 1.24, -0.2}, 0.018, 8);
    const Mesh wheel = makeWheel(detail, 0.17, 0.07);
    mesh.append(wheel, place({-0.35, 0.17, -0.2}));
    mesh.append(wheel, place({0.35, 0.17, -0.2}));
    return mesh;
}

Mesh makeWorkbench(const Detail& detail, std::uint32_t seed) {
    Mesh mesh(detail);
    for (int k = 0; k < 4; ++k) {
        addBlock(mesh, Plank, {-1.5, 0.86, -0.35 + 0.18 * k}, {1.5, 0.91, -0.18 + 0.18 * k}, 0.006,
                 {0.4 * k, 1.3 * k});
    }
    for (const double x : {-1.4, 0.0, 1.4}) {
        for (const double z : {-0.28, 0.28}) {
            addBlock(mesh, GreenSteel, {x - 0.035, 0, z - 0.035}, {x + 0.035, 0.86, z + 0.035},
                     0.005);
        }
    }
    addBlock(mesh, GreenSteel, {-1.42, 0.16, -0.3}, {1.42, 0.19, 0.3}, 0.005);
    addBlock(mesh, GreenSteel, {-1.45, 1.0, -0.4}, {1.45, 1.85, -0.37}, 0.01);
    addBlock(mesh, Iron, {0.95, 0.91, 0.02}, {1.15, 1.0, 0.3}, 0.02);
    addBlock(mesh, Iron, {0.92, 1.0, 0.20}, {1.18, 1.09, 0.26}, 0.012);
    addBlock(mesh, Iron, {0.92, 1.0, 0.29}, {1.18, 1.09, 0.35}, 0.012);
    addRod(mesh, Polished, {1.05, 1.0, 0.3}, {1.05, 1.0, 0.5}, 0.018, 10);
    addRod(mesh, Polished, {0.92, 1.0, 0.49}, {1.18, 1.0, 0.49}, 0.009, 8);
    for (std::uint32_t k = 0; k < 14; ++k) { // tools on the board
        const double x = -1.35 + 0.195 * k;
        const double drop = hashRange(0.16, 0.42, seed, k);
        addRod(mesh, Iron, {x, 1.75, -0.35}, {x, 1.75 - drop, -0.35}, 0.012, 6);
        addBlock(mesh, hashUnit(seed, k, 2) < 0.4 ? ToolRed : Plank,
                 {x - 0.018, 1.75 - drop - 0.10, -0.37}, {x + 0.018, 1.75 - drop, -0.335}, 0.008);
    }
    for (std::uint32_t k = 0; k < 5; ++k) {
        const double x = -1.3 + 0.42 * k;
        const double h = hashRange(0.10, 0.30, seed, k, 5);
        const int material = k % 3 == 0 ? DrumBlue : k % 3 == 1 ? ToolRed : GreenSteel;
        addBlock(mesh, material, {x, 0.91, -0.3}, {x + 0.28, 0.91 + h, -0.05}, 0.01, {x, h});
        addBlock(mesh, Plank, {x, 0.19, -0.2}, {x + 0.33, 0.25 + h, 0.18}, 0.008, {h, x});
    }
    return mesh;
}

Mesh makeChocks(const Detail& detail) {
    Mesh mesh(detail);
    for (const double side : {-1.0, 1.0}) {
        for (int k = 0; k < 3; ++k) {
            const double y = 0.075 * k;
            addBlock(
                mesh, Hazard,
                {-0.22, y, side * 0.72 - (side > 0 ? 0.17 - 0.05 * k : 0.11 - 0.01 * k)},
                {0.22, y + 0.075, side * 0.72 + (side > 0 ? 0.11 - 0.01 * k : 0.17 - 0.05 * k)},
                0.01, {0.2 * k, side});
        }
    }
    addTube(
        mesh, Plank,
        [](double t) {
            return Vec3(0.26 + 0.12 * std::sin(std::numbers::pi * t), 0.02, -0.7 + 1.4 * t);
        },
        [](double) { return 0.012; }, detail.steps(16, 4), 6);
    return mesh;
}

Mesh makeHose(const Detail& detail) {
    Mesh mesh(detail);
    const auto path = [](double t) {
        const double coils = 3.2;
        if (t < 0.7) {
            const double s = t / 0.7;
            const double angle = turn * coils * s;
            const double r = 0.42 + 0.10 * std::sin(2.3 * angle) + 0.06 * s;
            return Vec3(r * std::cos(angle), 0.03 + 0.045 * std::floor(coils * s) * 0.6 * s,
                        r * std::sin(angle));
        }
        const double s = (t - 0.7) / 0.3;
        const double angle = turn * coils;
        const double r = 0.42 + 0.10 * std::sin(2.3 * angle) + 0.06;
        const Vec3 start(r * std::cos(angle), 0.085 * (1 - s) + 0.03, r * std::sin(angle));
        return start + Vec3(-1.1 * s * s, 0, 2.4 * s + 0.25 * std::sin(6 * s) * s);
    };
    addTube(
        mesh, Hose, path, [](double) { return 0.028; }, detail.steps(200, 40), detail.steps(10, 5));
    return mesh;
}

} // namespace dirt::generate
