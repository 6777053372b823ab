#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>

#include "scenes/generate/block.h"
#include "scenes/generate/hangar_hall.h"
#include "scenes/generate/hangar_materials.h"
#include "scenes/generate/loft.h"
#include "scenes/generate/sweep.h"

namespace dirt::generate {
namespace {

using namespace hangar;

constexpr int frames = 11;

double arch(double x) {
    return 1 - x * x / (hallHalfWidth * hallHalfWidth);
}

Vec3 lowerChord(double x) {
    return {x, 10.3 + 2.5 * arch(x), 0};
}

Vec3 upperChord(double x) {
    return {x, 11.75 + 2.9 * arch(x), 0};
}

/// An I-section standing on the origin.
Mesh makePost(const Detail& detail, double height) {
    Mesh mesh(detail);
    addBlock(mesh, Steel, {-0.16, 0, -0.30}, {0.16, height, -0.27}, 0.004);
    addBlock(mesh, Steel, {-0.16, 0, 0.27}, {0.16, height, 0.30}, 0.004, {0.7, 0.3});
    addBlock(mesh, Steel, {-0.012, 0, -0.27}, {0.012, height, 0.27}, 0);
    addBlock(mesh, Concrete, {-0.3, 0, -0.42}, {0.3, 0.22, 0.42}, 0.02);
    for (double y = 1.6; y < height; y += 1.9) {
        addBlock(mesh, Steel, {-0.155, y, -0.27}, {0.155, y + 0.015, 0.27}, 0);
    }
    // The protection against bumps.
    addBlock(mesh, Hazard, {-0.19, 0.22, -0.325}, {0.19, 1.35, -0.302}, 0.004);
    addBlock(mesh, Hazard, {-0.19, 0.22, 0.302}, {0.19, 1.35, 0.325}, 0.004);
    return mesh;
}

/// An arched lattice truss in the plane z = 0.
Mesh makeTruss(const Detail& detail) {
    Mesh mesh(detail);
    const int panels = detail.shows(0.2) ? 20 : 10;
    const double step = 2 * hallHalfWidth / panels;
    for (int k = 0; k < panels; ++k) {
        const double x0 = -hallHalfWidth + step * k;
        const double x1 = x0 + step;
        for (const double z : {-0.09, 0.09}) { // chords are pairs of angles
            const Vec3 shift(0, 0, z);
            addBar(mesh, Steel, lowerChord(x0) + shift, lowerChord(x1) + shift, 0.07, 0.14, 0.006);
            addBar(mesh, Steel, upperChord(x0) + shift, upperChord(x1) + shift, 0.07, 0.16, 0.006);
        }
        const bool rising = k < panels / 2;
        addBar(mesh, Steel, rising ? lowerChord(x0) : lowerChord(x1),
               rising ? upperChord(x1) : upperChord(x0), 0.08, 0.08, 0);
        addBar(mesh, Steel, lowerChord(x1), upperChord(x1), 0.07, 0.07, 0);
        if (detail.shows(0.25)) { // gusset plates
            const Vec3 g = lowerChord(x1);
            addBlock(mesh, Steel, g - Vec3(0.24, 0.05, 0.012), g + Vec3(0.24, 0.26, 0.012), 0);
        }
    }
    return mesh;
}

void addSteelRoof(Mesh& mesh) {
    const double period = 0.32;
    const bool waves = mesh.detail().shows(0.2);
    const int columns = waves ? static_cast<int>(64 / period) * mesh.detail().steps(6, 3) : 8;
    mesh.addPatch(Roof, columns, mesh.detail().steps(20, 6),
                  [&](double u, double v) {
                      const double z = hallFar + (hallNear - hallFar) * u;
                      const double x = hallHalfWidth * 1.01 * (2 * v - 1);
                      const double wave =
                          waves ? 0.03 * std::sin(2 * std::numbers::pi * z / period) : 0;
                      return SurfacePoint{{x, upperChord(x).y + 0.3 + wave, z}, {z, x}};
                  },
                  {.flip = true});
    for (int k = 0; k <= 14; ++k) { // purlins
        const double x = -19.4 + 38.8 * k / 14;
        const double y = upperChord(x).y + 0.08;
        addBlock(mesh, Steel, {x - 0.05, y, hallFar}, {x + 0.05, y + 0.2, hallNear}, 0,
                 {0.3 * k, 0});
    }
}

/// A light panel in its housing, hung by rods; its face looks down from y = 0.
Mesh makePanel(const Detail& detail) {
    Mesh mesh(detail);
    const double w = 1.5;
    const double l = 2.75;
    mesh.addQuad(LightPanel, {-w, 0.02, -l}, {w, 0.02, -l}, {w, 0.02, l}, {-w, 0.02, l});
    addBlock(mesh, LightHousing, {-w - 0.10, 0.05, -l - 0.1}, {w + 0.10, 0.24, l + 0.1}, 0.03);
    for (const double side : {-1.0, 1.0}) {
        addBlock(mesh, LightHousing, {side < 0 ? -w - 0.12 : w, -0.07, -l - 0.12},
                 {side < 0 ? -w : w + 0.12, 0.06, l + 0.12}, 0.012);
        addBlock(mesh, LightHousing, {-w, -0.07, side < 0 ? -l - 0.12 : l},
                 {w, 0.06, side < 0 ? -l : l + 0.12}, 0.012);
        for (const double end : {-1.0, 1.0}) {
            addRod(mesh, Cable, {side * w * 0.8, 0.2, end * l * 0.8},
                   {side * w * 0.8, 2.4, end * l * 0.8}, 0.012, 6);
        }
    }
    for (int k = 1; k < (detail.shows(0.2) ? 4 : 1); ++k) { // louvres
        const double z = -l + 2 * l * k / 4;
        addBlock(mesh, LightHousing, {-w, -0.06, z - 0.012}, {w, 0.0, z + 0.012}, 0);
    }
    return mesh;
}

/// The travelling crane across the hall at z = 0, its trolley at x.
Mesh makeCrane(const Detail& detail, double trolley) {
    Mesh mesh(detail);
    for (const double z : {-1.2, 1.2}) {
        addBlock(mesh, CraneYellow, {-18.6, 8.75, z - 0.22}, {18.6, 9.65, z + 0.22}, 0.02, {z, 0});
        addBlock(mesh, CraneYellow, {-18.6, 9.65, z - 0.30}, {18.6, 9.69, z + 0.30}, 0, {z, 1});
        addBlock(mesh, CraneYellow, {-18.6, 8.71, z - 0.30}, {18.6, 8.75, z + 0.30}, 0, {z, 2});
        addBlock(mesh, Iron, {-18.6, 9.69, z - 0.04}, {18.6, 9.75, z + 0.04}, 0);
        for (int k = 0; k < (detail.shows(0.2) ? 26 : 0); ++k) {
            const double x = -18 + 36.0 * k / 25;
            addBlock(mesh, CraneYellow, {x - 0.01, 8.75, z - 0.29}, {x + 0.01, 9.65, z + 0.29}, 0);
        }
    }
    for (const double side : {-1.0, 1.0}) {
        addBlock(mesh, CraneYellow, {side * 18.6 - 0.3, 8.65, -2.3}, {side * 18.6 + 0.3, 9.3, 2.3},
                 0.03);
    }
    addBlock(mesh, Hazard, {-2.0, 8.80, 1.425}, {2.0, 9.6, 1.44}, 0.005);
    const double x = trolley;
    addBlock(mesh, CraneYellow, {x - 1.0, 9.75, -1.5}, {x + 1.0, 10.0, 1.5}, 0.03);
    Mesh drum(detail);
    Profile winch({0.0, -0.8});
    winch.line({0.34, -0.8}).line({0.34, -0.7}).line({0.25, -0.7}).line({0.25, 0.7});
    winch.line({0.34, 0.7}).line({0.34, 0.8}).line({0, 0.8});
    addLathe(drum, Iron, winch, detail.steps(28, 8));
    mesh.append(drum, glm::translate(Transform(1), {x, 10.3, 0}) *
                          glm::rotate(Transform(1), glm::radians(90.0), Vec3(1, 0, 0)));
    for (const double dx : {-0.2, -0.07, 0.07, 0.2}) {
        addRod(mesh, Cable, {x + dx, 10.2, 0}, {x + dx, 6.7, 0}, 0.014, 6);
    }
    addBlock(mesh, CraneYellow, {x - 0.32, 6.15, -0.16}, {x + 0.32, 6.75, 0.16}, 0.06);
    addBlock(mesh, Hazard, {x - 0.33, 6.3, -0.17}, {x + 0.33, 6.55, 0.17}, 0.02);
    const auto hook = [=](double t) {
        const double a = 4.6 * t;
        if (t < 0.2) return Vec3(x, 6.15 - 1.1 * t, 0);
        const double b = a - 0.92;
        return Vec3(x + 0.17 * std::sin(b), 5.76 + 0.17 * std::cos(b), 0);
    };
    addTube(
        mesh, Iron, hook, [](double t) { return 0.055 - 0.035 * t * t; }, detail.steps(24, 8),
        detail.steps(12, 6));
    return mesh;
}

/// A ventilation duct along the right wall, with flanges and outlets, and pipes below it.
void addDucts(Mesh& mesh) {
    Mesh duct(mesh.detail());
    const double x = 17.6;
    const double y = 7.9;
    const int sides = mesh.detail().steps(28, 8);
    for (int k = 0; k < 30; ++k) {
        const double z = hallFar + 1 + 2.0 * k;
        addRod(duct, LightHousing, {x, y, z}, {x, y, z + 2.0}, 0.46, 28);
        Profile flange({0.46, -0.03});
        flange.line({0.52, -0.03}).line({0.52, 0.03}).line({0.46, 0.03});
        Mesh ring(mesh.detail());
        addLathe(ring, LightHousing, flange, sides);
        duct.append(ring, standing({x, y, z}, {x, y, z + 1}));
        if (k % 3 == 1) {
            addRod(duct, LightHousing, {x - 0.2, y - 0.25, z + 1}, {x - 0.75, y - 0.95, z + 1}, 0.2,
                   18);
        }
    }
    mesh.append(duct, Transform(1));
    for (const double side : {-1.0, 1.0}) {
        int index = 0;
        for (const double height : {3.75, 3.95, 4.2}) {
            const double r = index == 2 ? 0.07 : 0.04;
            addRod(mesh, index == 1 ? ToolRed : Iron, {side * 19.72, height, hallFar},
                   {side * 19.72, height, hallNear}, r, 10);
            ++index;
        }
    }
}

} // namespace

void addHallSteel(Mesh& mesh) {
    const Detail& detail = mesh.detail();
    const Mesh post = makePost(detail, 11.7);
    const Mesh truss = makeTruss(detail);
    const Mesh panel = makePanel(detail);
    for (int k = 0; k < frames; ++k) {
        const double z = hallFar + steelBay * k;
        mesh.append(truss, place({0, 0, z}), {0.9 * k, 0});
        for (const double side : {-1.0, 1.0}) {
            mesh.append(post, place({side * 19.5, 0, z}, 90), {0.5 * k, 0.8 * k + side});
            addBlock(mesh, Steel, {side * 18.6 - 0.75, 8.15, z - 0.1},
                     {side * 18.6 + 0.75, 8.4, z + 0.1}, 0.01);
        }
        if (k + 1 == frames) break;
        for (const double x : {-15.2, -7.6, 0.0, 7.6, 15.2}) {
            mesh.append(panel, place({x, lowerChord(x).y - 0.25, z + steelBay / 2}));
        }
        for (const double x : {-9.4, 0.0, 9.4}) { // bracing between the frames
            addBar(mesh, Steel, lowerChord(x) + Vec3(0, 0, z),
                   upperChord(x) + Vec3(0, 0, z + steelBay), 0.05, 0.05, 0);
            addBar(mesh, Steel, upperChord(x) + Vec3(0, 0, z),
                   lowerChord(x) + Vec3(0, 0, z + steelBay), 0.05, 0.05, 0);
        }
    }
    for (const double side : {-1.0, 1.0}) { // the crane's rails
        addBlock(mesh, CraneYellow, {side * 18.6 - 0.16, 8.4, hallFar},
                 {side * 18.6 + 0.16, 8.62, hallNear}, 0.01);
        addBlock(mesh, Iron, {side * 18.6 - 0.03, 8.62, hallFar},
                 {side * 18.6 + 0.03, 8.68, hallNear}, 0);
    }
    addSteelRoof(mesh);
    addDucts(mesh);
    mesh.append(makeCrane(detail, -6.5), place({0, 0, -13}));
}

} // namespace dirt::generate
