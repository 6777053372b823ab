#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "scenes/generate/block.h"
#include "scenes/generate/noise.h"
#include "scenes/generate/temples_doric.h"
#include "scenes/generate/temples_materials.h"

namespace dirt::generate {
namespace {

using namespace temples;

constexpr int across = 6;
constexpr int along = 10;
constexpr double bay = 2.75;
constexpr double columnHeight = 6.3;
constexpr double step = 0.36;
constexpr double floorHeight = 3 * step;
constexpr double halfWidth = bay * (across - 1) / 2;
constexpr double depth = bay * (along - 1);
constexpr double first = -1.9; // z of the front row

constexpr double architrave = 1.0;
constexpr double frieze = 1.05;
constexpr double cornice = 0.42;

/// Three steps of long blocks, and the paving on top.
void addSteps(Mesh& mesh, std::uint32_t seed) {
    std::uint32_t id = seed * 1000;
    for (int k = 0; k < 3; ++k) {
        const double out = 1.75 - 0.42 * k;
        const double y = step * k;
        const double x = halfWidth + out;
        const double z0 = first + out;
        const double z1 = first - depth - out;
        const double length = 1.55;
        const auto row = [&](bool alongX, double fixed, double from, double to, double inwards) {
            const int count = static_cast<int>(std::lround((to - from) / length));
            for (int n = 0; n < count; ++n) {
                ++id;
                const double a = from + (to - from) * n / count + 0.004;
                const double b = from + (to - from) * (n + 1) / count - 0.004;
                const double slip = hashRange(-0.02, 0.02, id, 1);
                const double top = y + step + hashRange(-0.012, 0.006, id, 2);
                const double near = fixed + slip;
                const double far = fixed + inwards;
                const Vec3 low =
                    alongX ? Vec3(a, y, std::min(near, far)) : Vec3(std::min(near, far), y, a);
                const Vec3 high =
                    alongX ? Vec3(b, top, std::max(near, far)) : Vec3(std::max(near, far), top, b);
                addWornBlock(mesh, Marble, low, high, 0.05, id);
            }
        };
        row(true, z0, -x, x, -1.0);
        row(true, z1, -x, x, 1.0);
        row(false, -x, z1 + 1, z0 - 1, 1.0);
        row(false, x, z1 + 1, z0 - 1, -1.0);
    }
    const double top = floorHeight - 0.03;
    mesh.addPatch(Marble, 12, 20, [=](double u, double v) {
        const double x = (halfWidth + 0.2) * (2 * u - 1);
        const double z = first + 0.2 - (depth + 0.4) * v;
        const double dip = 0.04 * fractalSolidNoise({0.4 * x, 0, 0.4 * z}, 3, seed + 5);
        return SurfacePoint{{x, top + dip, z}, {x, -z}};
    });
}

/// What lies over one bay, along x from 0 to `bay`, its face towards +z; y = 0 is the capitals'
/// top. `courses`: 1 architrave, 2 with frieze, 3 with cornice.
void addBay(Mesh& mesh, const Transform& at, int courses, std::uint32_t seed) {
    Mesh part(mesh.detail());
    const double half = 0.52;
    addWornBlock(part, Marble, {0.004, 0, -half}, {bay - 0.004, architrave - 0.13, half}, 0.05,
                 seed);
    addWornBlock(part, Marble, {0, architrave - 0.13, -half}, {bay, architrave, half + 0.07}, 0.03,
                 seed + 1);
    if (courses >= 2) {
        const double y0 = architrave;
        const double y1 = architrave + frieze;
        addWornBlock(part, Marble, {0, y0, -half}, {bay, y1, half - 0.10}, 0.03, seed + 2);
        for (const double centre : {0.0, bay / 2}) {
            const double w = 0.40;
            for (int k = -1; k <= 1; ++k) { // a triglyph's three bars
                const double x = centre + k * 0.275;
                if (x < -0.35) continue;
                addWornBlock(part, Marble, {x - 0.115, y0, half - 0.14},
                             {x + 0.115, y1 - 0.12, half + 0.03}, 0.018,
                             seed + 10 + static_cast<std::uint32_t>(k + 1));
            }
            addWornBlock(part, Marble, {centre - w, y1 - 0.13, half - 0.14},
                         {centre + w, y1, half + 0.05}, 0.018, seed + 14);
            addBlock(part, Marble, {centre - w, y0 - 0.21, half},
                     {centre + w, y0 - 0.13, half + 0.06}, 0.008);
        }
    }
    if (courses >= 3) {
        const double y0 = architrave + frieze;
        addWornBlock(part, Marble, {0.003, y0 + 0.10, -half},
                     {bay - 0.003, y0 + cornice, half + 0.52}, 0.045, seed + 20);
        for (int k = 0; k < 2; ++k) {
            const double x = bay * (k + 0.5) / 2 - bay / 4;
            addBlock(part, Marble, {x - 0.38, y0, half - 0.1}, {x + 0.38, y0 + 0.11, half + 0.46},
                     0.015);
        }
    }
    mesh.append(part, at, {5 * hashUnit(seed, 6), 5 * hashUnit(seed, 7)});
}

/// The front gable, of which the right-hand part has come down: courses of blocks and raking slabs.
void addGable(Mesh& mesh, double whole, std::uint32_t seed) {
    const double half = halfWidth + 0.5;
    const double rise = 0.245;
    const double base = floorHeight + columnHeight + architrave + frieze + cornice;
    std::uint32_t id = seed * 500;
    for (int row = 0; row < 5; ++row) {
        const double y = 0.52 * row;
        const double reach = half - y / rise;
        if (reach < 0.5) break;
        const int count = std::max(1, static_cast<int>(2 * reach / 1.4));
        for (int k = 0; k < count; ++k) {
            ++id;
            const double a = -reach + 2 * reach * k / count;
            const double b = -reach + 2 * reach * (k + 1) / count;
            if (b > half * (2 * whole - 1) + hashRange(-0.4, 0.4, id, 1) - 0.3 * row) continue;
            const double middle = 0.5 * (a + b);
            const double top = std::min(0.52, (half - std::abs(middle)) * rise - y + 0.1);
            if (top < 0.1) continue;
            addWornBlock(mesh, Marble, {a + 0.004, base + y, first - 0.30},
                         {b - 0.004, base + y + top, first + 0.22}, 0.03, id);
        }
    }
    for (const double side : {-1.0, 1.0}) {
        const int slabs = 5;
        for (int k = 0; k < slabs; ++k) {
            ++id;
            const double t0 = static_cast<double>(k) / slabs;
            const double t1 = static_cast<double>(k + 1) / slabs;
            const double x = side * (half + 0.55) * (1 - 0.5 * (t0 + t1));
            if (x > half * (2 * whole - 1)) continue;
            Mesh slab(mesh.detail());
            const double length = (half + 0.55) / slabs * 1.03;
            addWornBlock(slab, Marble, {-length / 2, 0, -0.55}, {length / 2, 0.34, 0.95}, 0.04, id);
            const double y = base + (half + 0.55 - std::abs(x)) * rise - 0.02;
            mesh.append(slab,
                        glm::translate(Transform(1), {x, y, first}) *
                            glm::rotate(Transform(1), -side * std::atan(rise), Vec3(0, 0, 1)),
                        {hashUnit(id, 8) * 5, 0});
        }
    }
}

/// The walls of the inner room, in courses; the upper ones have fallen unevenly.
void addCella(Mesh& mesh, double whole, std::uint32_t seed) {
    const double x = 3.7;
    const double from = first - 2 * bay;
    const double to = first - depth + 1.5 * bay;
    std::uint32_t id = seed * 700;
    for (const double side : {-1.0, 1.0}) {
        const int count = 13;
        for (int row = 0; row < 11; ++row) {
            for (int k = 0; k < count; ++k) {
                ++id;
                const double shift = row % 2 == 0 ? 0 : 0.5;
                const double z = from + (to - from) * (k + shift) / count;
                const double next = from + (to - from) * (k + 1 + shift) / count;
                const double ruin =
                    11 * whole * (0.62 + 0.75 * solidNoise({0.23 * z + 9, side * 3, 0.5}, seed));
                if (row > ruin) continue;
                addWornBlock(mesh, Marble, {side * x - 0.38, floorHeight + 0.5 * row, next + 0.003},
                             {side * x + 0.38, floorHeight + 0.5 * row + 0.497, z - 0.003}, 0.035,
                             id);
            }
        }
    }
}

} // namespace

Mesh makeTemple(const Detail& detail, double whole, std::uint32_t seed) {
    Mesh mesh(detail);
    addSteps(mesh, seed);
    addCella(mesh, whole, seed);
    const double top = floorHeight + columnHeight;
    // Columns in order around: the front from left to right, then both sides backwards.
    const auto column = [&](double x, double z, double left, std::uint32_t id) {
        mesh.append(makeDoricColumn(detail, Marble, {columnHeight, 0.60, left, id}),
                    place({x, floorHeight, z}, 18.0 * (id % 7)), {hashUnit(id, 8) * 6, 0});
    };
    std::uint32_t id = seed * 100;
    for (int k = 0; k < across; ++k) {
        const double x = -halfWidth + bay * k;
        column(x, first, k == across - 1 ? 0.3 + 0.9 * whole : 2, ++id);
        if (hashUnit(seed, 50 + static_cast<std::uint32_t>(k)) < 0.5 + 0.5 * whole) {
            ++id;
            column(x, first - depth, hashRange(0.25, 1.6, id, 51), id);
        }
    }
    for (int k = 1; k + 1 < along; ++k) {
        const double z = first - bay * k;
        const double left =
            k < 6 ? 2 : hashRange(0.2, 0.9, seed, 60 + static_cast<std::uint32_t>(k));
        column(-halfWidth, z, left, ++id);
        const double right = hashRange(0.12, 1.25, seed, 80 + static_cast<std::uint32_t>(k));
        if (k != 3) column(halfWidth, z, right, ++id);
    }
    // Beams: the front but for its last bay, and along the left as far as the columns stand.
    for (int k = 0; k < across - 2; ++k) {
        const int courses = k < 3 ? 3 : 2;
        addBay(mesh, place({-halfWidth + bay * k, top, first}), courses, ++id * 40);
    }
    for (int k = 0; k < 5; ++k) {
        const int courses = k < 2 ? 3 : k < 4 ? 2 : 1;
        addBay(mesh, place({-halfWidth, top, first - bay * (k + 1)}, -90), courses, ++id * 40);
    }
    addGable(mesh, 0.5 * whole + 0.17, seed);
    return mesh;
}

} // namespace dirt::generate
