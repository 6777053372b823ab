#include "scenes/generate/rabbit.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "scenes/generate/implicit.h"
#include "scenes/generate/noise.h"
#include "scenes/generate/sweep.h"

namespace dirt::generate {
namespace {

/// Near its surface, about the distance to an ellipsoid.
double ellipsoid(Vec3 p, Vec3 centre, Vec3 radii) {
    const Vec3 q = (p - centre) / radii;
    const double k0 = glm::length(q);
    const double k1 = glm::length(q / radii);
    return k1 > 0 ? k0 * (k0 - 1) / k1 : -std::min({radii.x, radii.y, radii.z});
}

/// A rod between two points, thickening from one radius to the other.
double limb(Vec3 p, Vec3 a, Vec3 b, double ra, double rb) {
    const Vec3 way = b - a;
    const double t = std::clamp(glm::dot(p - a, way) / glm::dot(way, way), 0.0, 1.0);
    return glm::length(p - a - way * t) - (ra + (rb - ra) * t);
}

Vec3 turnedY(Vec3 p, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * p.x - s * p.z, p.y, s * p.x + c * p.z};
}

Vec3 turnedZ(Vec3 p, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
}

// The head turns about the neck towards the viewer, and tilts up a little.
constexpr Vec3 neck(0.115, 0.225, 0);
constexpr double headTurn = 0.42;
constexpr double headTilt = 0.06;

Vec3 toHead(Vec3 p) {
    return turnedZ(turnedY(p - neck, headTurn), -headTilt) + neck;
}

Vec3 fromHead(Vec3 p) {
    return turnedY(turnedZ(p - neck, headTilt), -headTurn) + neck;
}

constexpr Vec3 eye(0.176, 0.287, 0.0415);

/// An ear: a long bowl from its root upwards and back, the hollow forwards and outwards.
double ear(Vec3 p, double side) {
    // Into the ear's own frame: y along it, x forwards, z outwards.
    Vec3 q = p - Vec3(0.122, 0.312, side * 0.026);
    q.z *= side;
    q = turnedZ(q, -0.40);
    // Leans outwards.
    const double lean = 0.20;
    q = Vec3(q.x, q.y * std::cos(lean) + q.z * std::sin(lean),
             q.z * std::cos(lean) - q.y * std::sin(lean));
    q = turnedY(q, -0.55);
    const double bend = 0.9 * (q.y - 0.07) * (q.y - 0.07);
    q.x += bend;
    const double blade = ellipsoid(q, {0, 0.088, 0}, {0.019, 0.098, 0.031});
    const double hollow = ellipsoid(q, {0.022, 0.092, 0}, {0.021, 0.080, 0.021});
    // Hollowed, with a soft rim.
    const double h = std::max(0.010 - std::abs(blade + hollow), 0.0) / 0.010;
    return std::max(blade, -hollow) + h * h * 0.0025;
}

double head(Vec3 world) {
    const Vec3 p = toHead(world);
    const Vec3 m(p.x, p.y, std::abs(p.z)); // both sides are alike
    // Skull and snout, drawn out downwards and forwards.
    const Vec3 s = turnedZ(p - Vec3(0.150, 0.268, 0), 0.42);
    double d = ellipsoid(s, Vec3(0), {0.073, 0.055, 0.050});
    d = smoothUnion(
        d, ellipsoid(turnedZ(p - Vec3(0.203, 0.246, 0), 0.3), Vec3(0), {0.036, 0.029, 0.027}),
        0.035);
    d = smoothUnion(d, ellipsoid(m, {0.165, 0.243, 0.026}, {0.036, 0.033, 0.027}), 0.022);
    d = smoothUnion(d, ellipsoid(m, {0.223, 0.243, 0.0115}, {0.0155, 0.0135, 0.0125}), 0.008);
    d = smoothUnion(d, ellipsoid(p, {0.220, 0.229, 0}, {0.012, 0.010, 0.011}), 0.008); // chin
    // The nose with its cleft, the lids around the eyes.
    d = smoothUnion(d, ellipsoid(p, {0.2345, 0.2535, 0}, {0.0085, 0.0065, 0.0095}), 0.005);
    d = smoothUnion(d, ellipsoid(m, eye - Vec3(0.001, -0.001, 0.005), {0.0185, 0.0165, 0.0130}),
                    0.012);
    d = std::max(d, -(ellipsoid(m, eye + Vec3(0, 0, 0.001), {0.0120, 0.0105, 0.0105})));
    d += 0.0022 * std::exp(-std::pow(p.z / 0.0016, 2.0)) *
         (p.x > 0.212 && p.y < 0.2535 && p.y > 0.232 ? 1 : 0);
    d = smoothUnion(d, ear(p, 1), 0.016);
    return smoothUnion(d, ear(p, -1), 0.016);
}

double rabbit(Vec3 p) {
    const Vec3 m(p.x, p.y, std::abs(p.z));
    double d = ellipsoid(p, {-0.065, 0.128, 0}, {0.140, 0.122, 0.104});
    d = smoothUnion(d, ellipsoid(p, {0.052, 0.140, 0}, {0.082, 0.104, 0.078}), 0.07);
    d = smoothUnion(d, ellipsoid(p, {-0.035, 0.165, 0}, {0.120, 0.092, 0.088}), 0.05);
    d = smoothUnion(d, limb(p, {0.060, 0.170, 0}, {0.128, 0.245, 0}, 0.066, 0.048), 0.05);
    d = smoothUnion(d, ellipsoid(p, {0.098, 0.185, 0}, {0.042, 0.052, 0.050}), 0.03); // ruff
    // Thighs stand out from the flanks, with a crease around them.
    const Vec3 t = turnedZ(m - Vec3(-0.052, 0.092, 0.086), -0.35);
    const double thigh = ellipsoid(t, Vec3(0), {0.092, 0.074, 0.040});
    d = smoothUnion(d, thigh, 0.014);
    d = smoothUnion(d, limb(m, {-0.100, 0.024, 0.096}, {0.046, 0.019, 0.104}, 0.024, 0.0185),
                    0.016);
    d = smoothUnion(d, ellipsoid(m, {0.052, 0.017, 0.105}, {0.030, 0.017, 0.021}), 0.010);
    // Forelegs and paws.
    d = smoothUnion(d, limb(m, {0.085, 0.115, 0.043}, {0.122, 0.030, 0.041}, 0.030, 0.0185), 0.022);
    d = smoothUnion(d, ellipsoid(m, {0.139, 0.0165, 0.042}, {0.031, 0.0165, 0.0195}), 0.010);
    for (const double z : {-0.007, 0.0075}) { // toes
        const double a = (m.z - 0.042 - z) / 0.0022;
        const double b = (m.z - 0.105 - z) / 0.0022;
        if (m.x > 0.145) d += 0.0016 * std::exp(-a * a);
        if (m.x > 0.056 && m.x < 0.1) d += 0.0016 * std::exp(-b * b);
    }
    const Vec3 tail = p - Vec3(-0.205, 0.098, 0);
    d = smoothUnion(d, glm::length(tail) - 0.036 * (1 + 0.05 * solidNoise(tail * 70.0, 5)), 0.014);
    d = smoothUnion(d, head(p), 0.022);
    // A thrower's hand leaves no surface even.
    return d + 0.0007 * solidNoise(p * 28.0, 7);
}

} // namespace

Mesh makeRabbit(const Detail& detail, RabbitMaterials materials) {
    Mesh mesh(detail);
    addSolid(mesh, materials.body, rabbit,
             {Vec3(-0.26, -0.012, -0.15), Vec3(0.27, 0.53, 0.19), 0.0022, 0.40});
    const Mesh ball = [&] {
        Mesh sphere(detail);
        Profile half({0.0, -0.0105});
        std::vector<Vec2> arc;
        for (int k = 1; k <= 8; ++k) {
            const double a = std::numbers::pi * k / 8;
            arc.push_back({0.0105 * std::sin(a), -0.0105 * std::cos(a)});
        }
        half.spline(arc);
        addLathe(sphere, materials.eye, half, detail.steps(32, 8));
        return sphere;
    }();
    for (const double side : {-1.0, 1.0}) {
        mesh.append(ball, place(fromHead(eye * Vec3(1, 1, side) - Vec3(0, 0, side * 0.0015))));
    }
    return mesh;
}

} // namespace dirt::generate
