#include "scenes/generate/bunny_furniture.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scenes/generate/block.h"
#include "scenes/generate/bunny_materials.h"
#include "scenes/generate/loft.h"
#include "scenes/generate/noise.h"
#include "scenes/generate/numbers.h"
#include "scenes/generate/sweep.h"

namespace dirt::generate {
namespace {

using namespace bunny;

/// A stuffed shape: between an ellipsoid (power 1) and a box (power near 0), slightly uneven.
void addStuffed(Mesh& mesh, int material, Vec3 centre, Vec3 radii, double power,
                std::uint32_t seed) {
    const auto spread = [power](double x) {
        return std::copysign(std::pow(std::abs(x), power), x);
    };
    const double around = 2 * (radii.x + radii.z) * 1.6;
    mesh.addPatch(material, mesh.detail().steps(30 + 60 * around, 12), mesh.detail().steps(36, 8),
                  [=](double u, double v) {
                      const double a = -turn * (u < 1 ? u : 0);
                      const double e = std::numbers::pi * (v - 0.5);
                      const Vec3 p(spread(std::cos(a)) * spread(std::cos(e)), spread(std::sin(e)),
                                   spread(std::sin(a)) * spread(std::cos(e)));
                      const Vec3 q = radii * p;
                      const double dent = 0.012 * fractalSolidNoise((centre + q) * 5.0, 3, seed);
                      return SurfacePoint{centre + q * (1 + dent / glm::length(radii) * 2),
                                          {u * around, v * 2 * (radii.y + 0.5 * radii.x)}};
                  },
                  {.wrapU = true});
}

/// Piping along a closed path.
void addPiping(Mesh& mesh, int material, Vec3 centre, Vec3 radii, double power) {
    const auto spread = [power](double x) {
        return std::copysign(std::pow(std::abs(x), power), x);
    };
    addTube(
        mesh, material,
        [=](double t) {
            const double a = turn * t;
            return centre + Vec3(radii.x * spread(std::cos(a)), 0, radii.z * spread(std::sin(a)));
        },
        [](double) { return 0.006; }, mesh.detail().steps(80, 16), 6);
}

} // namespace

Mesh makeArmchair(const Detail& detail) {
    Mesh mesh(detail);
    Profile leg({0.014, 0.0});
    leg.line({0.016, 0.01}).spline({{0.018, 0.06}, {0.026, 0.12}}).line({0.026, 0.15});
    Mesh foot(detail);
    addLathe(foot, DarkWood, leg, detail.steps(20, 6));
    for (const double x : {-0.33, 0.33}) {
        for (const double z : {-0.30, 0.32}) mesh.append(foot, place({x, 0, z}));
    }
    addStuffed(mesh, Chair, {0, 0.24, 0.0}, {0.395, 0.105, 0.385}, 0.22, 1);
    addStuffed(mesh, Chair, {0, 0.39, 0.06}, {0.275, 0.075, 0.345}, 0.32, 2);
    addPiping(mesh, Chair, {0, 0.435, 0.06}, {0.272, 0, 0.342}, 0.32);
    for (const double side : {-1.0, 1.0}) {
        addStuffed(mesh, Chair, {side * 0.335, 0.40, 0.03}, {0.075, 0.19, 0.36}, 0.3, 3);
        // The arm's roll, along z.
        Mesh roll(detail);
        Profile section({0.0, -0.38});
        section.spline({{0.055, -0.372},
                        {0.078, -0.35},
                        {0.080, -0.2},
                        {0.080, 0.30},
                        {0.075, 0.35},
                        {0.05, 0.375},
                        {0.0, 0.38}});
        addLathe(roll, Chair, section, detail.steps(40, 10));
        mesh.append(roll, glm::translate(Transform(1), {side * 0.345, 0.585, 0.02}) *
                              glm::rotate(Transform(1), glm::radians(90.0), Vec3(1, 0, 0)));
        Mesh button(detail);
        Profile dome({0.028, 0.0});
        dome.bow({0.0, 0.012}, 0.2);
        addLathe(button, Chair, dome, detail.steps(20, 6));
        mesh.append(button, glm::translate(Transform(1), {side * 0.345, 0.585, 0.398}) *
                                glm::rotate(Transform(1), glm::radians(90.0), Vec3(1, 0, 0)));
    }
    Mesh back(detail);
    addStuffed(back, Chair, {0, 0.36, 0}, {0.36, 0.36, 0.085}, 0.34, 4);
    addStuffed(back, Chair, {0, 0.33, 0.075}, {0.27, 0.26, 0.06}, 0.42, 5);
    mesh.append(back, glm::translate(Transform(1), {0, 0.24, -0.30}) *
                          glm::rotate(Transform(1), -0.20, Vec3(1, 0, 0)));
    Mesh cushion(detail);
    addStuffed(cushion, Cushion, {0, 0, 0}, {0.21, 0.21, 0.075}, 0.55, 6);
    mesh.append(cushion, glm::translate(Transform(1), {0.05, 0.64, -0.06}) *
                             glm::rotate(Transform(1), -0.38, Vec3(1, 0, 0)) *
                             glm::rotate(Transform(1), 0.16, Vec3(0, 0, 1)));
    return mesh;
}

Mesh makeSideTable(const Detail& detail) {
    Mesh mesh(detail);
    const int sides = detail.steps(64, 12);
    Profile top({0.0, 0.492});
    top.line({0.235, 0.492})
        .bow({0.25, 0.506}, 0.3)
        .line({0.256, 0.510})
        .bow({0.252, 0.520}, 0.4)
        .line({0.0, 0.520});
    addLathe(mesh, DarkWood, top, sides);
    Profile post({0.026, 0.10});
    post.spline({{0.032, 0.13}, {0.022, 0.17}, {0.020, 0.20}})
        .bow({0.020, 0.225}, 0.5)
        .spline({{0.024, 0.26}, {0.035, 0.31}, {0.034, 0.35}, {0.020, 0.41}})
        .bow({0.020, 0.43}, 0.5)
        .line({0.03, 0.44})
        .line({0.09, 0.492});
    addLathe(mesh, DarkWood, post, detail.steps(32, 8));
    for (int k = 0; k < 3; ++k) {
        const double a = turn * k / 3 + 0.4;
        const Vec3 out(std::cos(a), 0, std::sin(a));
        addTube(
            mesh, DarkWood,
            [=](double t) {
                return out * (0.015 + 0.21 * t) +
                       Vec3(0, 0.135 + 0.035 * std::sin(3.0 * t) - 0.117 * t * t, 0);
            },
            [](double t) { return 0.020 - 0.006 * t; }, detail.steps(16, 4), detail.steps(12, 5));
    }
    return mesh;
}

Mesh makeTableLamp(const Detail& detail) {
    Mesh mesh(detail);
    const int sides = detail.steps(64, 12);
    Profile foot({0.0, 0.0});
    foot.line({0.070, 0.0}).bow({0.066, 0.014}, 0.4).line({0.060, 0.018});
    addLathe(mesh, Brass, foot, sides);
    Profile body({0.045, 0.016});
    body.spline({{0.060, 0.035},
                 {0.083, 0.085},
                 {0.078, 0.130},
                 {0.045, 0.180},
                 {0.026, 0.205},
                 {0.022, 0.222}})
        .bow({0.022, 0.236}, 0.6)
        .line({0.0, 0.238});
    addLathe(mesh, LampFoot, body, sides);
    addRod(mesh, Brass, {0, 0.23, 0}, {0, 0.30, 0}, 0.008, 12);
    addRod(mesh, Brass, {0, 0.27, 0}, {0, 0.305, 0}, 0.016, 16);
    Profile bulb({0.012, 0.305});
    bulb.spline({{0.020, 0.325}, {0.031, 0.350}, {0.026, 0.375}, {0.0, 0.385}});
    addLathe(mesh, Bulb, bulb, detail.steps(24, 8));
    // The shade, pleated, with its bands.
    const auto shade = [](double lift) {
        return [lift](double u, double v) {
            const double a = -turn * (u < 1 ? u : 0);
            const double r = 0.175 - 0.075 * v + 0.0022 * std::sin(64 * a) + lift;
            return SurfacePoint{{r * std::cos(a), 0.285 + 0.225 * v, r * std::sin(a)}, {u, v}};
        };
    };
    const int pleats = 64 * detail.steps(6, 2);
    mesh.addPatch(LampShade, pleats, 2, shade(0), {.wrapU = true});
    mesh.addPatch(LampShade, pleats, 2, shade(-0.0025), {.wrapU = true, .flip = true});
    for (const double v : {0.0, 1.0}) {
        addTube(
            mesh, Cushion,
            [=](double t) {
                const double a = turn * t;
                const double r = 0.175 - 0.075 * v;
                return Vec3(r * std::cos(a), 0.285 + 0.225 * v, r * std::sin(a));
            },
            [](double) { return 0.0055; }, sides, 8);
    }
    for (int k = 0; k < 3; ++k) {
        const double a = turn * k / 3;
        addRod(mesh, Brass, {0, 0.47, 0}, {0.107 * std::cos(a), 0.49, 0.107 * std::sin(a)}, 0.002,
               6);
    }
    addRod(mesh, Brass, {0, 0.385, 0}, {0, 0.47, 0}, 0.003, 6);
    return mesh;
}

Mesh makeBook(const Detail& detail, int cover, Vec3 size) {
    Mesh mesh(detail);
    const double x = size.x / 2;
    const double z = size.z / 2;
    const double board = 0.003;
    const double inset = 0.004;
    addBlock(mesh, cover, {-x, 0, -z}, {x, board, z}, 0.001);
    addBlock(mesh, cover, {-x, size.y - board, -z}, {x, size.y, z}, 0.001, {0.13, 0.07});
    addBlock(mesh, Paper, {-x + inset, board, -z + inset}, {x - inset, size.y - board, z - 0.002},
             0);
    mesh.addPatch(cover, 1, detail.steps(10, 3), [&](double u, double v) {
        const double a = std::numbers::pi * v;
        return SurfacePoint{
            {x * (2 * u - 1), size.y * 0.5 * (1 - std::cos(a)), z + 0.007 * std::sin(a)},
            {size.x * u, 0.05 * v}};
    });
    for (const double band : {-0.7, -0.45, 0.45, 0.7}) { // raised bands, gilt
        mesh.addPatch(Gilt, 1, detail.steps(10, 3), [&](double u, double v) {
            const double a = std::numbers::pi * v;
            return SurfacePoint{{x * band + 0.003 * (2 * u - 1), size.y * 0.5 * (1 - std::cos(a)),
                                 z + 0.0082 * std::sin(a) + 0.0002},
                                {0.01 * u, 0.05 * v}};
        });
    }
    return mesh;
}

Mesh makeToyBlock(const Detail& detail, int colour) {
    Mesh mesh(detail);
    const double h = 0.03;
    addBlock(mesh, FloorBoard, {-h, 0, -h}, {h, 2 * h, h}, 0.004, {0.3, 0.1});
    Mesh face(detail);
    const double w = 0.0225;
    const double t = 0.0035;
    addBlock(face, colour, {-w, -w, 0}, {w, -w + t, 0.0012}, 0.0004);
    addBlock(face, colour, {-w, w - t, 0}, {w, w, 0.0012}, 0.0004);
    addBlock(face, colour, {-w, -w + t, 0}, {-w + t, w - t, 0.0012}, 0.0004);
    addBlock(face, colour, {w - t, -w + t, 0}, {w, w - t, 0.0012}, 0.0004);
    addBlock(face, colour, {-0.011, -0.012, 0}, {-0.005, 0.012, 0.0012}, 0.0004); // an H
    addBlock(face, colour, {0.005, -0.012, 0}, {0.011, 0.012, 0.0012}, 0.0004);
    addBlock(face, colour, {-0.005, -0.003, 0}, {0.005, 0.003, 0.0012}, 0.0004);
    for (int k = 0; k < 4; ++k) {
        mesh.append(face, glm::translate(Transform(1), {0, h, 0}) * place({0, 0, 0}, 90.0 * k) *
                              glm::translate(Transform(1), {0, 0, h}));
    }
    mesh.append(face, glm::translate(Transform(1), {0, 2 * h, 0}) *
                          glm::rotate(Transform(1), glm::radians(-90.0), Vec3(1, 0, 0)));
    return mesh;
}

Mesh makeBall(const Detail& detail, double radius) {
    Mesh mesh(detail);
    const int colours[3] = {ToyRed, Mount, ToyBlue};
    const auto gore = [&](double from, double to, double low, double high) {
        return [=](double u, double v) {
            const double a = -(from + (to - from) * u);
            const double e = std::numbers::pi * (low + (high - low) * v - 0.5);
            return SurfacePoint{
                Vec3(std::cos(e) * std::cos(a), 1 + std::sin(e), std::cos(e) * std::sin(a)) *
                    radius,
                {u, v}};
        };
    };
    for (int k = 0; k < 6; ++k) {
        mesh.addPatch(colours[k % 3], detail.steps(14, 3), detail.steps(44, 10),
                      gore(turn * k / 6, turn * (k + 1) / 6, 0.05, 0.95));
    }
    mesh.addPatch(ToyYellow, detail.steps(40, 8), detail.steps(4), gore(0, turn, 0, 0.05));
    mesh.addPatch(ToyYellow, detail.steps(40, 8), detail.steps(4), gore(0, turn, 0.95, 1));
    return mesh;
}

Mesh makeCarrotPlate(const Detail& detail) {
    Mesh mesh(detail);
    Profile plate({0.0, 0.004});
    plate.line({0.055, 0.004}).line({0.06, 0.0}).line({0.066, 0.0});
    plate.spline({{0.085, 0.007}, {0.112, 0.018}, {0.116, 0.021}})
        .line({0.114, 0.023})
        .spline({{0.090, 0.014}, {0.072, 0.008}})
        .line({0.0, 0.008});
    addLathe(mesh, Plate, plate, detail.steps(72, 14));
    for (std::uint32_t n = 0; n < 3; ++n) {
        Mesh carrot(detail);
        const double length = 0.14 - 0.012 * n;
        const int rings = detail.steps(40, 8);
        carrot.addPatch(bunny::Carrot, detail.steps(24, 7), rings,
                        [=](double u, double v) {
                            const double a = -turn * (u < 1 ? u : 0);
                            const double taper = std::sqrt(std::min(1.0, 14 * (1 - v) + 0.001)) *
                                                 (0.16 + 0.84 * std::pow(v, 0.75));
                            const double r = 0.0155 * taper *
                                             (1 + 0.05 * std::sin(95 * v + 3 * n) *
                                                      std::max(0.0, std::sin(a * 2 + 9 * v)));
                            return SurfacePoint{{r * std::cos(a) + 0.004 * std::sin(3 * v + n),
                                                 length * v, r * std::sin(a)},
                                                {0.1 * u, length * v}};
                        },
                        {.wrapU = true});
        for (std::uint32_t k = 0; k < 9; ++k) { // stalks with feathery leaves
            const double a = turn * hashUnit(n, k, 31);
            const Vec3 out(std::cos(a), 0, std::sin(a));
            const double reach = hashRange(0.02, 0.05, n, k, 32);
            const double rise = hashRange(0.06, 0.11, n, k, 33);
            const auto path = [=](double t) {
                return Vec3(0, length - 0.004 + rise * t, 0) + out * (0.004 + reach * t * t);
            };
            addTube(
                carrot, CarrotTop, path, [](double t) { return 0.0018 * (1.2 - t); },
                detail.steps(8, 3), 5);
            const int leaves = detail.number(12, 3);
            for (int j = 0; j < leaves; ++j) {
                const auto id = hashBits(n * 16 + k, static_cast<std::uint32_t>(j), 34);
                const Vec3 root = path(0.35 + 0.65 * (j + 0.5) / leaves);
                const Vec3 way = glm::normalize(
                    out + Vec3(hashRange(-1, 1, id, 1), 0.8, hashRange(-1, 1, id, 2)));
                const Vec3 side = glm::normalize(glm::cross(way, Vec3(0.1, 1, 0.2)));
                carrot.addPatch(CarrotTop, 1, 2, [=](double u, double v) {
                    const double half = 0.0035 * std::sin(std::numbers::pi * (0.1 + 0.85 * v));
                    return SurfacePoint{root + way * (0.019 * v) + side * (half * (2 * u - 1)),
                                        {u, v}};
                });
            }
        }
        mesh.append(carrot, glm::translate(Transform(1), {0.05 - 0.012 * n, 0.024 + 0.006 * n,
                                                          -0.032 + 0.030 * n}) *
                                place({0, 0, 0}, -14.0 + 13.0 * n) *
                                glm::rotate(Transform(1), glm::radians(97.0), Vec3(0, 0, 1)));
    }
    return mesh;
}

Mesh makeHousePlant(const Detail& detail, std::uint32_t seed) {
    Mesh mesh(detail);
    Profile pot({0.0, 0.0});
    pot.line({0.10, 0.0}).line({0.105, 0.01}).line({0.14, 0.22}).line({0.158, 0.225});
    pot.bow({0.160, 0.27}, 0.08).line({0.145, 0.272}).line({0.138, 0.235});
    addLathe(mesh, PotClay, pot, detail.steps(56, 12));
    Profile soil({0.14, 0.245});
    soil.spline({{0.07, 0.252}, {0.0, 0.25}});
    addLathe(mesh, PotSoil, soil, detail.steps(28, 8));
    const int leaves = 22;
    for (int k = 0; k < leaves; ++k) {
        const auto id = hashBits(seed, static_cast<std::uint32_t>(k));
        const double rank = (k + 0.5) / leaves;
        const double a = 2.39996 * k + hashRange(-0.2, 0.2, id, 1);
        const Vec3 out(std::cos(a), 0, std::sin(a));
        const double rise = (0.62 - 0.40 * rank) * hashRange(0.85, 1.1, id, 2);
        const double reach = 0.06 + 0.26 * rank;
        const auto stem = [=](double t) {
            return Vec3(0, 0.24 + rise * t, 0) + out * (0.02 + reach * t * t);
        };
        addTube(
            mesh, PlantLeaf, stem, [](double t) { return 0.0055 - 0.0025 * t; },
            detail.steps(12, 4), detail.steps(8, 4));
        const Vec3 root = stem(1);
        const Vec3 side(-out.z, 0, out.x);
        const double length = hashRange(0.20, 0.29, id, 3);
        const double width = 0.62 * length;
        const double droop = hashRange(0.35, 0.8, id, 4);
        mesh.addPatch(
            PlantLeaf, detail.steps(14, 4), detail.steps(22, 6),
            [=](double u, double v) {
                const double across = 2 * u - 1;
                // A heart's outline, waved at its rim and folded along the rib.
                const double outline =
                    std::pow(std::sin(std::numbers::pi * std::pow(v, 0.62)), 0.8);
                const double w = 0.5 * width * outline * across;
                const double wave = 0.010 * std::sin(11 * v + 4 * across) * std::abs(across);
                const double back = -0.10 * length * std::abs(across) * std::exp(-9 * v);
                const double forward = length * v + back;
                return SurfacePoint{root + out * (forward * std::cos(droop * v)) + side * w +
                                        Vec3(0,
                                             0.10 * v * length - 0.55 * droop * length * v * v +
                                                 0.35 * std::abs(w) + wave,
                                             0),
                                    {u, v}};
            },
            {.flip = true});
    }
    return mesh;
}

} // namespace dirt::generate
