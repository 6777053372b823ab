#include "scenes/generate/temples_doric.h"

#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scenes/generate/noise.h"
#include "scenes/generate/numbers.h"
#include "scenes/generate/sweep.h"

namespace dirt::generate {
namespace {

constexpr int flutes = 20;
constexpr double shrink = 0.22; // the shaft's top is this much thinner than its foot

Vec3 offset(std::uint32_t seed) {
    return 40.0 * Vec3(hashUnit(seed, 1), hashUnit(seed, 2), hashUnit(seed, 3));
}

/// Part of a shaft with flutes, chipped; its ends are given by the height at each place.
struct Shaft {
    double radius; ///< at the foot of the column
    double height; ///< of the whole shaft, for its taper
    std::uint32_t seed;

    double radiusAt(double angle, double y, double toJoint) const {
        const double s = y / height;
        const double plain = radius * (1 - shrink * std::pow(std::clamp(s, 0.0, 1.0), 1.25));
        const double phase = angle / turn * flutes;
        const double flute = std::sin(std::numbers::pi * (phase - std::floor(phase)));
        const Vec3 p(radius * std::cos(angle), y, radius * std::sin(angle));
        const double n = fractalSolidNoise(p * 1.7 + offset(seed), 4, 3);
        const double joint = std::exp(-std::pow(toJoint / 0.05, 2.0));
        const double arris = 0.5 * (1 - flute) * smoothStep(0.05, 0.5, n + 0.3 * joint);
        double r = plain * (1 - 0.105 * std::pow(flute, 0.85));
        r -= plain * 0.13 * arris;
        r -= plain * 0.14 * smoothStep(0.40, 0.66, n);
        r -= 0.03 * joint * smoothStep(-0.2, 0.5, n) + 0.012 * (toJoint < 0.012 ? 1 : 0);
        return r + 0.012 * n;
    }
};

/// How far the break at a shaft's end departs from its plane.
double breakHeight(Vec2 p, double radius, std::uint32_t seed) {
    const double lean = hashRange(0, turn, seed, 11);
    const double slope = 0.45 * (p.x * std::cos(lean) + p.y * std::sin(lean));
    return slope + 0.5 * radius * fractalSolidNoise(Vec3(p.x, 0, p.y) * 2.2 + offset(seed), 4, 5);
}

void addDrum(Mesh& mesh, int material, const Shaft& shaft, double low, double high, bool brokenTop,
             bool brokenBase) {
    const int columns = flutes * mesh.detail().steps(10);
    const int rows = mesh.detail().steps(10, 2);
    const double spin = hashRange(-0.02, 0.02, shaft.seed, 21);
    const Vec3 slip(hashRange(-0.012, 0.012, shaft.seed, 22), 0,
                    hashRange(-0.012, 0.012, shaft.seed, 23));
    const auto ring = [&](double u, double v, double inwards) {
        const double angle = -turn * (u < 1 ? u : 0);
        const double s = v - 0.11 * std::sin(turn * v);
        double y = low + (high - low) * s;
        const double toJoint = std::min(brokenBase ? 1 : y - low, brokenTop ? 1 : high - y);
        const double r = shaft.radiusAt(angle, y, toJoint) * (1 - inwards);
        const Vec2 p(r * std::cos(angle + spin), r * std::sin(angle + spin));
        if (brokenTop) y += s * breakHeight(p, shaft.radius, shaft.seed);
        if (brokenBase) y += (1 - s) * breakHeight(p, shaft.radius, shaft.seed + 7);
        return SurfacePoint{Vec3(p.x, y, p.y) + slip, {u * turn * shaft.radius, y}};
    };
    mesh.addPatch(material, columns, rows, [&](double u, double v) { return ring(u, v, 0); },
                  {.wrapU = true});
    const int inner = mesh.detail().steps(8, 2);
    const auto end = [&](double edge, bool flip) {
        mesh.addPatch(material, columns / 2, inner,
                      [&](double u, double v) {
                          SurfacePoint point = ring(u, edge, 0.999 * v);
                          point.texcoord = {point.position.x, point.position.z};
                          return point;
                      },
                      {.wrapU = true, .flip = flip});
    };
    if (brokenTop) end(1, false);
    if (brokenBase) end(0, true);
}

} // namespace

void addWornBlock(Mesh& mesh, int material, Vec3 low, Vec3 high, double wear, std::uint32_t seed) {
    const Vec3 half = (high - low) * 0.5;
    const Vec3 centre = (low + high) * 0.5;
    const double smallest = std::min({half.x, half.y, half.z});
    const double round = std::min(0.6 * wear + 0.012, 0.45 * smallest);
    const Vec2 quarry(7 * hashUnit(seed, 4), 7 * hashUnit(seed, 5));
    for (int axis = 0; axis < 3; ++axis) {
        const int first = (axis + 1) % 3;
        const int second = (axis + 2) % 3;
        for (const double side : {-1.0, 1.0}) {
            const auto surface = [&](double u, double v) -> SurfacePoint {
                // Lines crowd at the edges, which are worn.
                const auto spread = [](double t) { return 2 * t - 1 + 0.14 * std::sin(turn * t); };
                Vec3 p;
                p[axis] = side * half[axis];
                p[first] = half[first] * spread(u);
                p[second] = half[second] * spread(v);
                const Vec3 core = glm::clamp(p, round - half, half - round);
                const Vec3 out = glm::normalize(p - core);
                const double n = fractalSolidNoise((centre + p) * 1.9 + offset(seed), 4, 9);
                // Where two or three faces meet, more breaks away.
                const double edge =
                    1 - std::max({std::abs(out.x), std::abs(out.y), std::abs(out.z)});
                const double lost = wear * (0.25 * n + 3.4 * edge * smoothStep(-0.1, 0.6, n));
                const Vec3 q = core + out * (round - std::min(lost, 0.6 * smallest));
                const Vec2 texcoord = axis == 1 ? Vec2(q.x, q.z) : Vec2(axis == 0 ? q.z : q.x, q.y);
                return {centre + q, texcoord + quarry};
            };
            const auto cells = [&](double length) {
                return std::min(mesh.detail().steps(4 + 9 * length, 2), 400);
            };
            mesh.addPatch(material, cells(half[first]), cells(half[second]), surface,
                          {.flip = side < 0});
        }
    }
}

Mesh makeDoricCapital(const Detail& detail, int material, double neck, std::uint32_t seed) {
    Mesh mesh(detail);
    const double r = neck;
    Profile echinus({0.985 * r, -0.02});
    echinus.line({1.0 * r, 0.10 * r});
    for (int k = 0; k < 3; ++k) { // annulets
        const double y = 0.12 * r + 0.05 * r * k;
        echinus.line({(1.03 + 0.025 * k) * r, y}).line({(1.03 + 0.025 * k) * r, y + 0.03 * r});
    }
    echinus.spline({{1.24 * r, 0.40 * r}, {1.40 * r, 0.56 * r}, {1.45 * r, 0.66 * r}})
        .line({1.38 * r, 0.72 * r});
    addLathe(mesh, material, echinus, detail.steps(72, 12));
    const double half = 1.5 * r;
    addWornBlock(mesh, material, {-half, 0.70 * r, -half}, {half, 1.20 * r, half}, 0.035, seed + 3);
    return mesh;
}

Mesh makeDoricColumn(const Detail& detail, int material, const DoricShape& shape) {
    Mesh mesh(detail);
    const double neck = shape.radius * (1 - shrink);
    const double shaft = shape.height - 1.2 * neck;
    constexpr int drums = 6;
    for (int k = 0; k < drums; ++k) {
        const double low = shaft * k / drums;
        double high = shaft * (k + 1) / drums;
        const bool last = shape.left < 1 && high >= shaft * shape.left;
        if (last) high = std::max(shaft * shape.left, low + 0.15 * shaft / drums);
        const Shaft part{shape.radius, shaft, shape.seed * 16 + static_cast<std::uint32_t>(k)};
        addDrum(mesh, material, part, low, high, last, false);
        if (last) return mesh;
    }
    mesh.append(makeDoricCapital(detail, material, neck, shape.seed),
                place({0, shaft, 0}, hashRange(-1.5, 1.5, shape.seed, 31)),
                {hashUnit(shape.seed, 32), hashUnit(shape.seed, 33)});
    return mesh;
}

Mesh makeFallenDrum(const Detail& detail, int material, double radius, double length,
                    std::uint32_t seed) {
    Mesh drum(detail);
    addDrum(drum, material, {radius, 9, seed}, 0.3, 0.3 + length, hashUnit(seed, 41) < 0.6, true);
    Mesh mesh(detail);
    mesh.append(drum, glm::translate(Transform(1), {-0.3 - length / 2, 0.9 * radius, 0}) *
                          glm::rotate(Transform(1), glm::radians(-90.0), Vec3(0, 0, 1)));
    return mesh;
}

} // namespace dirt::generate
