#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "scenes/generate/block.h"
#include "scenes/generate/hangar_aircraft.h"
#include "scenes/generate/hangar_materials.h"
#include "scenes/generate/loft.h"
#include "scenes/generate/sweep.h"

namespace dirt::generate {
namespace {

using namespace hangar;

/// Brings a lathe's axis (y) to z.
Transform toZ() {
    return glm::rotate(Transform(1), glm::radians(90.0), Vec3(1, 0, 0));
}

/// Brings a lathe's axis (y) to x.
Transform toX() {
    return glm::rotate(Transform(1), glm::radians(-90.0), Vec3(0, 0, 1));
}

Transform turned(double degrees) {
    return glm::rotate(Transform(1), glm::radians(degrees), Vec3(0, 0, 1));
}

/// A finned cylinder that stands on the crankcase, with its head, rocker boxes and push rods.
Mesh makeCylinder(const Detail& detail) {
    Mesh mesh(detail);
    const int sides = detail.steps(24, 6);
    const int fins = detail.shows(0.2) ? 11 : 3;
    Profile barrel({0.085, 0.22});
    for (int k = 0; k < fins; ++k) {
        const double y = 0.25 + 0.21 * k / fins;
        const double pitch = 0.21 / fins;
        barrel.line({0.072, y}).line({0.092, y + 0.15 * pitch}).line({0.092, y + 0.45 * pitch});
        barrel.line({0.072, y + 0.6 * pitch});
    }
    addLathe(mesh, Iron, barrel, sides);
    Profile head({0.072, 0.46});
    for (int k = 0; k < fins / 2 + 1; ++k) {
        const double y = 0.465 + 0.022 * k;
        const double r = 0.112 - 0.006 * k;
        head.line({0.08, y}).line({r, y + 0.004}).line({r, y + 0.011}).line({0.078, y + 0.015});
    }
    head.line({0.07, 0.61}).line({0, 0.625});
    addLathe(mesh, Aluminium, head, sides);
    for (const double side : {-1.0, 1.0}) {
        addBlock(mesh, Aluminium, {side * 0.055 - 0.028, 0.57, -0.03},
                 {side * 0.055 + 0.028, 0.65, 0.085}, 0.012);
        addRod(mesh, Polished, {side * 0.03, 0.20, 0.12}, {side * 0.055, 0.60, 0.07}, 0.009, 8);
    }
    addRod(mesh, Brass, {0, 0.53, 0.09}, {0.0, 0.555, 0.135}, 0.010, 8);
    // Exhaust, bent backwards into the collector.
    const auto path = [](double t) {
        return Vec3(0.06 + 0.07 * t, 0.56 - 0.13 * t * t, -0.06 - 0.24 * std::sin(1.5 * t));
    };
    addTube(
        mesh, DrumRust, path, [](double) { return 0.032; }, detail.steps(10, 3),
        detail.steps(10, 5));
    return mesh;
}

} // namespace

Mesh makeRadialEngine(const Detail& detail) {
    Mesh mesh(detail);
    const int sides = detail.steps(40, 9);
    Profile casing({0.0, -0.34});
    casing.line({0.16, -0.34})
        .line({0.22, -0.30})
        .line({0.25, -0.12})
        .line({0.24, 0.11})
        .bow({0.15, 0.24}, 0.25)
        .line({0.14, 0.26})
        .spline({{0.11, 0.33}, {0.07, 0.38}, {0.06, 0.40}})
        .line({0.035, 0.40})
        .line({0.035, 0.52})
        .line({0, 0.52});
    Mesh part(detail);
    addLathe(part, GreenSteel, casing, sides);
    Profile ring({0.43, -0.33});
    ring.bow({0.53, -0.33}, 0.5);
    ring.bow({0.43, -0.33}, 0.5);
    addLathe(part, DrumRust, ring, sides);
    mesh.append(part, toZ());
    const Mesh cylinder = makeCylinder(detail);
    for (int k = 0; k < 9; ++k) mesh.append(cylinder, turned(40.0 * k), {0.3 * k, 0.1 * k});
    if (detail.shows(0.2)) {
        // Bolts of the nose, and the ignition harness.
        for (int k = 0; k < 18; ++k) {
            Mesh bolt(detail);
            Profile nut({0.011, 0.0});
            nut.line({0.011, 0.012}).line({0, 0.014});
            addLathe(bolt, Polished, nut, 6);
            mesh.append(bolt, turned(20.0 * k + 10) *
                                  glm::translate(Transform(1), {0, 0.18, 0.19}) * toZ());
        }
        const auto loop = [](double t) {
            const double angle = 2 * std::numbers::pi * t;
            return Vec3(0.27 * std::cos(angle), 0.27 * std::sin(angle), 0.16);
        };
        addTube(
            mesh, Brass, loop, [](double) { return 0.013; }, detail.steps(54, 12),
            detail.steps(8, 4));
    }
    return mesh;
}

Mesh makePropeller(const Detail& detail, double radius) {
    Mesh mesh(detail);
    const Keys chord{{0, 0.10}, {0.12, 0.12}, {0.45, 0.27}, {0.8, 0.22}, {0.95, 0.13}, {1, 0.03}};
    const Keys thickness{{0, 0.10}, {0.15, 0.09}, {0.5, 0.035}, {1, 0.012}};
    const Keys twist{{0, 1.1}, {0.3, 0.85}, {1, 0.32}};
    const auto blade = [&](double low, double high) {
        return [=](double u, double v) -> SurfacePoint {
            const double s = low + (high - low) * v;
            const double angle = 2 * std::numbers::pi * u;
            const double x = 0.5 * chord(s) * std::cos(angle);
            const double z = 0.5 * thickness(s) * std::sin(angle);
            const double c = std::cos(twist(s));
            const double d = std::sin(twist(s));
            return {{x * c + z * d, s * radius, -x * d + z * c}, {x, s * radius}};
        };
    };
    Mesh single(detail);
    const int columns = detail.steps(16, 6);
    single.addPatch(Propeller, columns, detail.steps(20, 5), blade(0.04, 0.9),
                    {.wrapU = true, .flip = true});
    single.addPatch(BladeTip, columns, detail.steps(4), blade(0.9, 1.0),
                    {.wrapU = true, .flip = true});
    for (int k = 0; k < 3; ++k) mesh.append(single, turned(120.0 * k));
    Profile hub({0.10, -0.16});
    hub.line({0.14, -0.12}).line({0.14, 0.06}).bow({0.06, 0.16}, 0.2).line({0.06, 0.2});
    hub.bow({0, 0.24}, 0.2);
    Mesh boss(detail);
    addLathe(boss, Polished, hub, detail.steps(24, 6));
    mesh.append(boss, toZ());
    return mesh;
}

Mesh makeWheel(const Detail& detail, double radius, double width) {
    Mesh mesh(detail);
    const double w = width / 2;
    const double rim = 0.52 * radius;
    Profile tyre({rim, -0.72 * w});
    tyre.spline({{0.72 * radius, -w}, {0.9 * radius, -0.86 * w}, {0.975 * radius, -0.5 * w}});
    for (int k = -2; k <= 2; ++k) { // the tread's grooves
        const double x = 0.2 * k * w;
        tyre.line({radius, x - 0.06 * w}).line({radius, x + 0.06 * w});
        if (k < 2) tyre.line({0.97 * radius, x + 0.075 * w}).line({0.97 * radius, x + 0.125 * w});
    }
    tyre.line({0.975 * radius, 0.5 * w})
        .spline({{0.9 * radius, 0.86 * w}, {0.72 * radius, w}, {rim, 0.72 * w}});
    Profile disc({0, -0.62 * w});
    disc.line({0.12 * radius, -0.62 * w})
        .spline({{0.3 * radius, -0.4 * w}, {0.46 * radius, -0.55 * w}})
        .line({rim, -0.78 * w});
    Profile other({rim, 0.78 * w});
    other.spline({{0.46 * radius, 0.55 * w}, {0.3 * radius, 0.4 * w}, {0.12 * radius, 0.62 * w}})
        .line({0, 0.62 * w});
    Mesh part(detail);
    const int sides = detail.steps(48, 10);
    addLathe(part, Rubber, tyre, sides);
    addLathe(part, Aluminium, disc, sides);
    addLathe(part, Aluminium, other, sides);
    mesh.append(part, toX());
    return mesh;
}

} // namespace dirt::generate
