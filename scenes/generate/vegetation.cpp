#include "scenes/generate/vegetation.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "scenes/generate/atrium_materials.h"
#include "scenes/generate/noise.h"
#include "scenes/generate/numbers.h"
#include "scenes/generate/sweep.h"

namespace dirt::generate {
namespace {

/// A leaf from `root` along `along`, its upper side towards `up`; folded on the midrib and bent.
void addLeaf(Mesh& mesh, int material, Vec3 root, Vec3 along, Vec3 up, double length,
             double width) {
    const Vec3 way = glm::normalize(along);
    Vec3 side = glm::cross(way, up);
    side = glm::length(side) > 1e-6 ? glm::normalize(side) : Vec3(1, 0, 0);
    const Vec3 top = glm::cross(side, way);
    const auto surface = [&](double u, double v) -> SurfacePoint {
        const double across = 2 * u - 1;
        const double outline = std::sin(std::numbers::pi * std::pow(v, 0.8)) * (1.05 - 0.35 * v);
        const double w = 0.5 * width * outline * across;
        const double lift = 0.28 * std::abs(w) - 0.32 * length * v * v;
        return {root + way * (length * v) + side * w + top * lift, {u, v}};
    };
    // Grows slowly: more leaves matter more than finer ones.
    const int rows =
        std::max(2, static_cast<int>(std::lround(3 * std::sqrt(mesh.detail().quality))));
    mesh.addPatch(material, 2, rows, surface);
}

} // namespace

Mesh makePot(const Detail& detail) {
    Mesh mesh(detail);
    Profile pot({0.19, 0});
    pot.line({0.20, 0.03})
        .spline({{0.235, 0.16}, {0.27, 0.32}, {0.285, 0.42}})
        .line({0.315, 0.43})
        .bow({0.32, 0.54}, 0.18)
        .line({0.27, 0.55})
        .line({0.26, 0.44});
    addLathe(mesh, Terracotta, pot, detail.steps(28, 8));
    Profile swag({0.262, 0.24});
    swag.bow({0.268, 0.28}, 0.5);
    addLathe(mesh, Terracotta, swag, detail.steps(28, 8));
    Profile soil({0.265, 0.47});
    soil.spline({{0.14, 0.50}, {0.0, 0.51}});
    addLathe(mesh, Soil, soil, detail.steps(14, 6));
    return mesh;
}

Mesh makeLemonTree(const Detail& detail, std::uint32_t seed) {
    Mesh mesh(detail);
    const Vec3 crown(hashRange(-0.03, 0.03, seed, 1), 1.38, hashRange(-0.03, 0.03, seed, 2));
    const auto stem = [=](double t) {
        return Vec3(crown.x * t + 0.02 * std::sin(7 * t), crown.y * t,
                    crown.z * t + 0.02 * std::sin(9 * t));
    };
    addTube(
        mesh, Bark, stem, [](double t) { return 0.032 - 0.012 * t; }, detail.steps(8, 2),
        detail.steps(8, 4));
    const double radius = 0.55;
    const int branches = detail.number(14, 2);
    for (int k = 0; k < branches; ++k) {
        const Vec3 tip =
            crown + hashDirection(seed + 5, static_cast<std::uint32_t>(k)) * (0.8 * radius);
        const Vec3 root = crown - Vec3(0, 0.25 - 0.02 * k, 0);
        addTube(
            mesh, Bark,
            [=](double t) { return root + (tip - root) * t + Vec3(0, 0.08 * t * (1 - t), 0); },
            [](double t) { return 0.012 * (1 - 0.8 * t); }, detail.steps(3, 1), 4);
    }
    // Leaves sit in a shell, drawn together into clumps, and look outwards and up to the light.
    const int leaves =
        std::max(10, static_cast<int>(std::lround(1500 * std::pow(detail.quality, 1.6))));
    const double size = 0.15 * std::pow(std::clamp(420.0 / leaves, 0.1, 30.0), 0.42);
    for (int k = 0; k < leaves; ++k) {
        const auto id = static_cast<std::uint32_t>(k);
        const Vec3 clump = hashDirection(seed + 5, id % 40u);
        const Vec3 out = glm::normalize(clump * 0.9 + hashDirection(seed + 9, id));
        const double depth = radius * std::pow(hashRange(0.35, 1.0, seed + 13, id), 0.4);
        const double flatten = 0.9;
        const Vec3 root = crown + Vec3(out.x, out.y * flatten, out.z) * depth;
        const Vec3 along = out + hashDirection(seed + 17, id) * 0.9 + Vec3(0, -0.15, 0);
        addLeaf(mesh, Leaf, root, along, out + Vec3(0, 0.6, 0),
                size * hashRange(0.75, 1.2, seed + 21, id), 0.5 * size);
    }
    const int lemons = detail.number(16, 2);
    Profile fruit({0.0, -0.045});
    fruit.spline({{0.012, -0.038}, {0.033, -0.012}, {0.033, 0.012}, {0.012, 0.034}, {0.0, 0.045}});
    Mesh lemon(detail);
    addLathe(lemon, Lemon, fruit, detail.steps(9, 5));
    for (int k = 0; k < lemons; ++k) {
        const Vec3 out = hashDirection(seed + 31, static_cast<std::uint32_t>(k));
        mesh.append(lemon, place(crown + out * (radius * 0.97) - Vec3(0, 0.08, 0)));
    }
    return mesh;
}

Mesh makeAgave(const Detail& detail, std::uint32_t seed) {
    Mesh mesh(detail);
    const int blades = detail.number(34, 6, 0.4);
    for (int k = 0; k < blades; ++k) {
        const auto id = static_cast<std::uint32_t>(k);
        const double angle = 2.39996 * k + hashRange(-0.2, 0.2, seed, id);
        const double rank = (k + 0.5) / blades; // inner blades stand, outer ones arch over
        const double length = hashRange(0.62, 0.85, seed, id, 3) * (1.1 - 0.35 * rank);
        const double tilt = 1.35 - 1.1 * rank;
        const double droop = 0.5 * rank + 0.35;
        const Vec3 out(std::cos(angle), 0, -std::sin(angle));
        const Vec3 side(-std::sin(angle), 0, -std::cos(angle));
        const auto surface = [&](double u, double v) -> SurfacePoint {
            const double across = 2 * u - 1;
            const double half = 0.035 * std::pow(1 - v, 0.6) * (0.65 + 1.4 * v * (1 - v) * 2);
            const double reach = length * (v * std::cos(tilt) + 0.45 * droop * v * v);
            const double rise = length * (v * std::sin(tilt) - droop * 0.75 * v * v * v);
            const double gutter = 0.35 * half * across * across;
            return {out * (0.03 + reach - gutter * 0.3) + side * (half * across) +
                        Vec3(0, rise + gutter, 0),
                    {u, v}};
        };
        mesh.addPatch(Leaf, 2, detail.steps(8, 3), surface, {.flip = true});
    }
    return mesh;
}

Mesh makeHangingIvy(const Detail& detail, double width, double length, std::uint32_t seed) {
    Mesh mesh(detail);
    const int vines = detail.number(width / 0.11, 3, 0.4);
    for (int vine = 0; vine < vines; ++vine) {
        const auto id = static_cast<std::uint32_t>(vine);
        const double x0 = width * ((vine + 0.5) / vines - 0.5);
        const double middle = 1 - std::pow(2 * x0 / width, 2.0);
        const double reach = length * hashRange(0.25, 1.0, seed, id) * (0.45 + 0.55 * middle);
        const double phase = turn * hashUnit(seed, id, 4);
        const auto path = [=](double t) {
            const double over = std::min(1.0, 6 * t);
            return Vec3(x0 + 0.07 * std::sin(5 * t + phase) * t,
                        0.05 * std::sin(over * 3) - reach * t * t * 0.3 - reach * 0.7 * t,
                        -0.22 + 0.30 * over + 0.03 * std::sin(11 * t + phase));
        };
        addTube(
            mesh, Bark, path, [](double t) { return 0.006 * (1.1 - t); }, detail.steps(8, 2), 4);
        const double wanted = reach * 60 * std::pow(detail.quality, 1.4);
        const int leaves = std::max(3, static_cast<int>(std::lround(wanted)));
        const double size = 0.10 * std::pow(std::clamp(reach * 20 / leaves, 0.3, 8.0), 0.4);
        for (int k = 0; k < leaves; ++k) {
            const auto leaf = hashBits(seed, id, static_cast<std::uint32_t>(k));
            const double t = (k + hashUnit(leaf, 1)) / leaves;
            const double angle = turn * hashUnit(leaf, 2);
            const Vec3 along(std::cos(angle), -0.7 + 0.5 * std::sin(angle),
                             0.55 + 0.4 * hashUnit(leaf, 3));
            addLeaf(mesh, Ivy, path(t), along, {0.2 * std::cos(angle), 0.5, 1},
                    size * hashRange(0.6, 1.15, leaf, 4), 0.85 * size);
        }
    }
    return mesh;
}

} // namespace dirt::generate
