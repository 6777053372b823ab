#include "scenes/generate/hangar_aircraft.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "scenes/generate/block.h"
#include "scenes/generate/hangar_materials.h"
#include "scenes/generate/loft.h"
#include "scenes/generate/numbers.h"
#include "scenes/generate/sweep.h"

namespace dirt::generate {
namespace {

using namespace hangar;

constexpr double nacelleX = 2.9;
constexpr double nacelleY = 1.95;
constexpr double cowlFront = 4.55;

// The body is drawn level, along z: its upper and lower line and half its width.
const Keys& topLine() {
    static const Keys line{{-10.4, 3.75}, {-9.6, 3.95}, {-7, 4.02},   {-2, 4.22},
                           {3, 4.28},     {5.0, 4.22},  {5.75, 4.02}, {6.5, 3.42},
                           {7.5, 3.16},   {8.35, 2.78}, {8.55, 2.52}};
    return line;
}

const Keys& bottomLine() {
    static const Keys line{{-10.4, 3.45}, {-9.6, 3.22}, {-7, 2.62},  {-3, 1.95},  {0, 1.72},
                           {4, 1.70},     {6.5, 1.82},  {7.8, 2.02}, {8.4, 2.30}, {8.55, 2.50}};
    return line;
}

const Keys& halfWidth() {
    static const Keys line{{-10.4, 0.04}, {-9.6, 0.26}, {-7, 0.68},  {-3, 1.10},  {0, 1.24},
                           {4, 1.24},     {6, 1.08},    {7.4, 0.78}, {8.3, 0.38}, {8.55, 0.02}};
    return line;
}

/// The skin at z, `angle` from below over the right-hand side (-x) to above, lifted by `lift`.
Vec3 skin(double angle, double z, double lift = 0) {
    const double low = bottomLine()(z);
    const double high = topLine()(z);
    const auto bulge = [](double x) { return std::copysign(std::pow(std::abs(x), 0.88), x); };
    const double x = -(halfWidth()(z) + lift) * bulge(std::sin(angle));
    const double y = 0.5 * (low + high) - (0.5 * (high - low) + lift) * bulge(std::cos(angle));
    return {x, y, z};
}

void addBody(Mesh& mesh) {
    const int rows = mesh.detail().steps(90, 14);
    const auto band = [&](int material, double from, double to, double columns) {
        const auto surface = [&](double u, double v) -> SurfacePoint {
            const double angle = from + (to - from) * u;
            // Rows crowd at nose and tail.
            const double s = v - 0.13 * std::sin(2 * pi * v);
            const double z = 8.55 - 18.95 * s;
            return {skin(angle, z), {angle * 1.25, z}};
        };
        mesh.addPatch(material, mesh.detail().steps(columns, 2), rows, surface);
    };
    constexpr double stripe = 1.60;
    constexpr double white = 1.74;
    band(Aluminium, -stripe, stripe, 44);
    band(RedPaint, stripe, white, 3);
    band(WhitePaint, white, 2 * pi - white, 40);
    band(RedPaint, 2 * pi - white, 2 * pi - stripe, 3);
}

/// A pane let into the skin, with a polished frame; its outline is a rounded rectangle.
void addPane(Mesh& mesh, double angle, double z, double halfAngle, double halfLength, double slant,
             bool mirrored) {
    const auto at = [=](double rim, double around, double lift) {
        const auto square = [](double x) { return std::copysign(std::sqrt(std::abs(x)), x); };
        const double a = halfAngle * rim * square(std::sin(around));
        const double l = halfLength * rim * square(std::cos(around));
        const double turn = mirrored ? 2 * pi - (angle + a) : angle + a;
        return skin(turn, z + l + slant * a, lift);
    };
    const int sides = mesh.detail().steps(28, 8);
    mesh.addPatch(Glass, sides, 2,
                  [&](double u, double v) {
                      return SurfacePoint{at(1 - 0.999 * v, 2 * pi * u, 0.006), {u, v}};
                  },
                  {.wrapU = true, .flip = mirrored});
    if (!mesh.detail().shows(0.15)) return;
    addTube(
        mesh, Polished, [&](double t) { return at(1.02, 2 * pi * t, 0.005); },
        [](double) { return 0.017; }, sides, mesh.detail().steps(6, 4));
}

void addPanes(Mesh& mesh) {
    for (const bool mirrored : {false, true}) {
        for (int k = 0; k < 7; ++k) addPane(mesh, 1.98, 3.35 - 1.22 * k, 0.15, 0.24, 0, mirrored);
        addPane(mesh, 2.72, 6.03, 0.34, 0.20, 0.55, mirrored); // windscreen
        addPane(mesh, 2.10, 5.55, 0.17, 0.20, 0, mirrored);    // beside the pilots
        addPane(mesh, 2.06, 4.98, 0.15, 0.14, 0, mirrored);
        if (mesh.detail().shows(0.2) && mirrored) { // the door's gap
            addTube(
                mesh, Rubber,
                [](double t) {
                    const double a = 2 * pi * t;
                    const auto square = [](double x) {
                        return std::copysign(std::pow(std::abs(x), 0.3), x);
                    };
                    return skin(2 * pi - 1.75 - 0.62 * square(std::sin(a)),
                                -5.9 + 0.5 * square(std::cos(a)), 0.002);
                },
                [](double) { return 0.010; }, mesh.detail().steps(60, 20), 4);
        }
    }
}

/// Cowling, engine, propeller and the fairing into the wing.
Mesh makeNacelle(const Detail& detail) {
    Mesh mesh(detail);
    const int sides = detail.steps(48, 10);
    const Transform toFront = glm::rotate(Transform(1), glm::radians(90.0), Vec3(1, 0, 0));
    Mesh cowl(detail);
    Profile outside({0.80, -1.25});
    outside.spline({{0.815, -0.9}, {0.81, -0.4}, {0.78, -0.14}, {0.70, -0.02}, {0.655, 0.0}});
    outside.spline({{0.615, -0.03}, {0.60, -0.12}, {0.62, -0.5}});
    addLathe(cowl, Aluminium, outside, sides);
    // Cooling flaps around the rear edge.
    for (int k = 0; k < (detail.shows(0.2) ? 24 : 0); ++k) {
        Mesh flap(detail);
        addBlock(flap, Aluminium, {-0.092, -1.46, 0.80}, {0.092, -1.22, 0.812}, 0.004,
                 {0.2 * k, 0});
        cowl.append(flap, glm::rotate(Transform(1), glm::radians(15.0 * k), Vec3(0, 1, 0)));
    }
    mesh.append(cowl, toFront);
    mesh.append(makeRadialEngine(detail),
                glm::translate(Transform(1), {0, 0, -0.55}) * scaled({0.93, 0.93, 0.93}));
    mesh.append(makePropeller(detail, 1.75), glm::translate(Transform(1), {0, 0, 0.16}) *
                                                 glm::rotate(Transform(1), 0.6, Vec3(0, 0, 1)));
    const Keys radius{{-5.6, 0.02}, {-4.6, 0.34}, {-3, 0.62}, {-1.2, 0.74}};
    const Keys drop{{-5.6, -0.42}, {-3, -0.10}, {-1.2, 0.0}};
    mesh.addPatch(Aluminium, sides, detail.steps(16, 4),
                  [&](double u, double v) {
                      const double angle = -2 * pi * u;
                      const double z = -1.2 - 4.4 * v;
                      const double r = radius(z);
                      return SurfacePoint{{r * std::cos(angle), drop(z) + r * std::sin(angle), z},
                                          {angle * 0.7, z}};
                  },
                  {.wrapU = true, .flip = true});
    return mesh;
}

/// Half of the wing, towards +x.
void addMainWing(Mesh& mesh) {
    const double y = 1.86;
    addWing(mesh, Aluminium, {{{0.2, y, 3.2}, 4.6, 0.15}, {{3.8, y, 3.2}, 4.6, 0.15}}, 44, 8);
    std::vector<WingStation> outer;
    for (int k = 0; k <= 10; ++k) {
        // Ends round: the chord follows an ellipse over the last part.
        const double s = k / 10.0;
        const double end = s < 0.82 ? 1.0 : std::sqrt(1 - std::pow((s - 0.82) / 0.185, 2.0));
        const double chord = (4.6 - 2.7 * s) * end;
        const double leading = 3.2 - 1.75 * s - 0.35 * (4.6 - 2.7 * s) * (1 - end);
        outer.push_back({{3.8 + 10.6 * s, y + 0.95 * s, leading}, chord, 0.15 - 0.05 * s});
    }
    addWing(mesh, Aluminium, outer, 44, 3);
    // De-icing boot along the leading edge, and landing light.
    addTube(
        mesh, Rubber,
        [=](double t) {
            return Vec3(4.2 + 8.0 * t, y + 0.95 * (0.4 + 8.0 * t) / 10.6,
                        3.2 - 1.75 * (0.4 + 8.0 * t) / 10.6 - 0.055);
        },
        [](double t) { return 0.075 - 0.03 * t; }, 1, mesh.detail().steps(12, 6));
}

void addTail(Mesh& mesh) {
    std::vector<WingStation> fin;
    std::vector<WingStation> plane;
    for (int k = 0; k <= 8; ++k) {
        const double s = k / 8.0;
        const double end = std::sqrt(std::max(0.0, 1 - std::pow(s, 5.0)) + 0.004);
        fin.push_back({{0, 3.75 + 2.75 * s, -7.1 - 1.55 * s * s - 0.35 * s - 0.5 * (1 - end)},
                       (3.5 - 0.9 * s) * end - 0.6 * s,
                       0.10});
        plane.push_back({{0.15 + 3.95 * s, 3.45, -7.55 - 0.85 * s - 0.5 * (1 - end)},
                         (2.5 - 1.0 * s) * end,
                         0.10});
    }
    addWing(mesh, RedPaint, fin, 28, 2);
    Mesh half(mesh.detail());
    addWing(half, Aluminium, plane, 28, 2);
    mesh.append(half, Transform(1));
    mesh.append(half, scaled({-1, 1, 1}));
}

void addMainGear(Mesh& mesh) {
    // In the level frame; the wheels stand on y = 0.
    const Mesh wheel = makeWheel(mesh.detail(), 0.58, 0.40);
    mesh.append(wheel, place({nacelleX, 0.58, 3.25}));
    for (const double side : {-1.0, 1.0}) {
        const double x = nacelleX + side * 0.30;
        addRod(mesh, Polished, {x, 0.58, 3.25}, {x, 1.35, 3.0}, 0.05, 12);
        addRod(mesh, Aluminium, {x, 1.10, 3.08}, {x, 1.75, 2.85}, 0.08, 12);
        addRod(mesh, Iron, {x, 0.9, 3.15}, {x, 1.5, 1.7}, 0.035, 10);
    }
    addRod(mesh, Iron, {nacelleX - 0.36, 0.58, 3.25}, {nacelleX + 0.36, 0.58, 3.25}, 0.05, 12);
    addRod(mesh, Iron, {nacelleX - 0.3, 1.3, 3.02}, {nacelleX + 0.3, 1.3, 3.02}, 0.04, 10);
}

} // namespace

Mesh makeAirliner(const Detail& detail) {
    Mesh mesh(detail);
    Mesh level(detail);
    addBody(level);
    addPanes(level);
    addTail(level);
    Mesh half(detail);
    addMainWing(half);
    half.append(makeNacelle(detail), place({nacelleX, nacelleY, cowlFront}));
    addMainGear(half);
    level.append(half, Transform(1));
    level.append(half, scaled({-1, 1, 1}), {1.3, 0.4});
    // Tail wheel, aerial mast, pitot tubes.
    level.append(makeWheel(detail, 0.24, 0.16), place({0, 2.28, -8.3}));
    for (const double side : {-0.11, 0.11}) {
        addRod(level, Iron, {side, 2.28, -8.3}, {side * 0.6, 3.0, -7.9}, 0.035, 8);
    }
    addRod(level, Iron, {0, 4.2, 3.6}, {0, 4.85, 3.5}, 0.025, 8);
    addRod(level, Cable, {0, 4.83, 3.5}, {0, 6.2, -8.6}, 0.008, 5);
    // The tail sits down: turned about the main wheels until the tail wheel meets the floor.
    const double tilt = std::atan2(2.04, 11.55);
    mesh.append(level, glm::translate(Transform(1), {0, 0.58, 0}) *
                           glm::rotate(Transform(1), -tilt, Vec3(1, 0, 0)) *
                           glm::translate(Transform(1), {0, -0.58, -3.25}));
    return mesh;
}

} // namespace dirt::generate
