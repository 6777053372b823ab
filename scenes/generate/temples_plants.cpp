#include "scenes/generate/temples_plants.h"

#include <cmath>
#include <functional>

#include <glm/geometric.hpp>

#include "scenes/generate/noise.h"
#include "scenes/generate/numbers.h"
#include "scenes/generate/sweep.h"
#include "scenes/generate/temples_materials.h"

namespace dirt::generate {
namespace {

using namespace temples;

/// A narrow leaf, folded a little on its midrib: two quads.
void addNarrowLeaf(Mesh& mesh, int material, Vec3 root, Vec3 along, Vec3 up, double length,
                   double width) {
    const Vec3 way = glm::normalize(along);
    const Vec3 side = glm::normalize(glm::cross(way, up + Vec3(0.01, 0, 0.02)));
    const Vec3 top = glm::cross(side, way);
    const auto corner = [&](double u, double v) {
        const double across = 2 * u - 1;
        const double w = 0.5 * width * (v < 0.25 || v > 0.75 ? 0.35 : 1.0) * across;
        return SurfacePoint{root + way * (length * v) + side * w + top * (0.3 * std::abs(w)),
                            {u, v}};
    };
    mesh.addPatch(material, 2, 1, [&](double u, double v) { return corner(u, 0.1 + 0.55 * v); });
}

} // namespace

Mesh makeOliveTree(const Detail& detail, std::uint32_t seed) {
    Mesh mesh(detail);
    const int leavesPerTwig =
        std::max(2, static_cast<int>(std::lround(64 * std::min(3.0, detail.quality))));
    std::uint32_t id = seed * 4096;
    // Limbs divide; each is a bent tube from its parent's end.
    const std::function<void(Vec3, Vec3, double, double, int)> grow =
        [&](Vec3 from, Vec3 way, double length, double radius, int level) {
            ++id;
            const std::uint32_t me = id;
            const Vec3 bend = hashDirection(me, 3) * (0.28 * length);
            const Vec3 to = from + way * length;
            const auto path = [=](double t) {
                return from + (to - from) * t + bend * (4 * t * (1 - t));
            };
            const double end = radius * 0.62;
            const auto thickness = [=](double t) {
                const double flare = level == 0 ? 0.75 * std::exp(-7 * t) : 0.0;
                const double knots = 0.13 * std::sin(9 * t + me) * (level < 2 ? 1 : 0);
                return (radius + (end - radius) * t) * (1 + flare + knots);
            };
            addTube(mesh, OliveBark, path, thickness, detail.steps(level == 0 ? 16 : 7, 2),
                    detail.steps(level == 0  ? 18
                                 : level < 3 ? 9
                                             : 5,
                                 4));
            if (level < 4) {
                const int children = level == 0 ? 4 : level < 3 ? 3 : 4;
                for (int k = 0; k < children; ++k) {
                    const std::uint32_t child = hashBits(me, static_cast<std::uint32_t>(k), 9);
                    const double angle = turn * (k + hashUnit(child, 4)) / children;
                    const Vec3 out(std::cos(angle), 0, std::sin(angle));
                    const Vec3 next = glm::normalize(
                        way * 0.75 + out * hashRange(0.55, 1.0, child, 5) + Vec3(0, 0.22, 0));
                    const double t = k == 0 ? 1.0 : hashRange(0.6, 1.0, child, 6);
                    grow(path(t), next, length * hashRange(0.55, 0.78, child, 7),
                         thickness(t) * 0.78, level + 1);
                }
                return;
            }
            for (int k = 0; k < leavesPerTwig; ++k) {
                const auto leaf = hashBits(me, static_cast<std::uint32_t>(k), 13);
                const double t = hashRange(0.0, 1.15, leaf, 1);
                const Vec3 out = hashDirection(leaf, 2);
                const double size = hashRange(0.13, 0.22, leaf, 3);
                addNarrowLeaf(mesh, OliveLeaf, path(t) + out * 0.09, out + way * 0.7, {0, 1, 0},
                              size, 0.34 * size);
            }
        };
    grow({0, -0.2, 0}, glm::normalize(Vec3(0.22, 1, 0.1)), 1.45, 0.24, 0);
    return mesh;
}

Mesh makeShrub(const Detail& detail, std::uint32_t seed) {
    Mesh mesh(detail);
    const int leaves = std::max(20, static_cast<int>(std::lround(900 * detail.quality)));
    const double size = 0.055 * std::pow(900.0 / leaves, 0.35);
    for (int k = 0; k < leaves; ++k) {
        const auto id = hashBits(seed, static_cast<std::uint32_t>(k), 17);
        Vec3 out = hashDirection(id, 1);
        out.y = std::abs(out.y);
        const double lumps = 1 + 0.35 * solidNoise(out * 2.4, seed);
        const Vec3 p =
            out * Vec3(0.48, 0.40, 0.48) * (lumps * std::pow(hashRange(0.3, 1, id, 2), 0.4));
        addNarrowLeaf(mesh, Shrub, p, out + hashDirection(id, 3) * 0.8, out + Vec3(0, 0.6, 0),
                      size * hashRange(0.7, 1.3, id, 4), 0.45 * size);
    }
    return mesh;
}

Mesh makeGrassTuft(const Detail& detail, std::uint32_t seed) {
    Mesh mesh(detail);
    const int blades = detail.number(34, 5, 0.5);
    for (int k = 0; k < blades; ++k) {
        const auto id = hashBits(seed, static_cast<std::uint32_t>(k), 19);
        const double angle = turn * hashUnit(id, 1);
        const Vec3 out(std::cos(angle), 0, std::sin(angle));
        const Vec3 side(-out.z, 0, out.x);
        const Vec3 root = out * (0.09 * hashUnit(id, 2)) - Vec3(0, 0.03, 0);
        const double length = hashRange(0.14, 0.36, id, 3);
        const double lean = hashRange(0.15, 0.75, id, 4);
        mesh.addPatch(Grass, 1, std::clamp(detail.steps(4), 2, 4), [&](double u, double v) {
            const double half = 0.006 * (1 - 0.9 * v);
            const Vec3 p = root + out * (length * lean * v * v) +
                           Vec3(0, length * (v - 0.3 * lean * v * v), 0);
            return SurfacePoint{p + side * (half * (2 * u - 1)), {u, v}};
        });
    }
    return mesh;
}

} // namespace dirt::generate
