#include "core/path/grid_spotlight.h"

#include "core/path/camera_rays.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace dirt {
namespace {

constexpr double kPi = std::numbers::pi;

Spotlight lightAbove() {
    Spotlight light;
    light.position = {0, 2, 0};
    light.target = {0, 0, 0};
    light.color = {1.0f, 0.5f, 0.25f};
    light.flux = 100.0f;
    light.aperture = 90.0f;
    light.penumbra = 90.0f;
    return light;
}

/// A point at \p angle from the axis of lightAbove (radians), \p distance from it.
glm::vec3 below(double angle, double turn, double distance) {
    return glm::vec3(distance * std::sin(angle) * std::cos(turn), 2.0 - distance * std::cos(angle),
                     distance * std::sin(angle) * std::sin(turn));
}

// Rounding: point, difference, squared length (3), falloff's angle and quotient (about 12 in all),
// product; 24 of 2^-24 each hold them.
constexpr double kRounding = 24 * 0x1p-24;

TEST(Spotlight, IrradianceFallsWithTheSquareOfTheDistance) {
    const GridSpotlight light = makeGridSpotlight(lightAbove(), GridFrame{});
    const double intensity = 100.0 / (2.0 * kPi * (1.0 - std::cos(kPi / 4.0)));
    for (double distance : {1e-3, 0.5, 1.0, 3.0, 1000.0}) {
        const LightSample sample = sampleSpotlight(light, below(0.3, 1.0, distance));
        // The point itself is rounded, relative to the light's height of 2.
        const double bound = kRounding + 4.0 * 0x1p-24 * (2.0 + distance) / distance;
        const double exact = intensity / (distance * distance);
        EXPECT_NEAR(sample.irradiance.x / exact, 1.0, bound) << distance;
        EXPECT_NEAR(sample.irradiance.y / exact, 0.5, bound) << distance;
        EXPECT_NEAR(sample.irradiance.z / exact, 0.25, bound) << distance;
        EXPECT_NEAR(glm::length(glm::dvec3(sample.direction)), 1.0, 8 * 0x1p-24);
    }
}

TEST(Spotlight, PenumbraFallsOffByTheFormula) {
    for (float exponent : {0.0f, 0.5f, 1.0f, 3.0f}) {
        Spotlight description = lightAbove();
        description.penumbra = 40.0f;
        description.exponent = exponent;
        const GridSpotlight light = makeGridSpotlight(description, GridFrame{});
        const double outer = std::cos(kPi / 4.0), inner = std::cos(kPi / 9.0);
        const double axis = sampleSpotlight(light, below(0.0, 0.0, 1.0)).irradiance.x;
        for (double angle : {0.1, 0.3, 0.36, 0.5, 0.7, 0.78}) {
            const double part = std::min(1.0, (std::cos(angle) - outer) / (inner - outer));
            const double exact = std::pow(part, (double) exponent);
            // part is a difference of numbers of order 1 over a range of 0.23.
            const double bound = (kRounding / 0.23 / part) * std::max(1.0f, exponent) + 0x1p-20;
            for (double turn : {0.0, 1.0, 4.0})
                EXPECT_NEAR(sampleSpotlight(light, below(angle, turn, 1.0)).irradiance.x /
                                (exact * axis),
                            1.0, bound)
                    << "exponent " << exponent << ", angle " << angle;
        }
        for (double angle : {0.79, 1.5, 2.0, 3.1})
            EXPECT_EQ(sampleSpotlight(light, below(angle, 0.5, 1.0)).irradiance, glm::vec3(0.0f))
                << angle;
    }
}

TEST(Spotlight, FluxIsWhatTheConeEmits) {
    for (float aperture : {0.1f, 5.0f, 40.0f, 90.0f, 179.0f, 270.0f}) {
        Spotlight description = lightAbove();
        description.color = glm::vec3(1.0f);
        description.aperture = description.penumbra = aperture;
        description.position = description.target = glm::vec3(0.0f);
        description.target.y = -1.0f;
        const GridSpotlight light = makeGridSpotlight(description, GridFrame{});
        // Rings of equal solid angle around the axis, out to twice the cone's: the edge falls
        // between two rings, so that the sum is exact but for rounding near it (one ring).
        const int rings = 20000;
        const double s = std::sin(aperture * kPi / 720.0);
        const double cone = 2.0 * s * s; // 1 - cos
        const double step = cone / (rings + 0.5);
        double flux = 0.0;
        for (int ring = 0; (ring + 0.5) * step < std::min(2.0 * cone, 2.0); ++ring) {
            const double depth = (ring + 0.5) * step; // 1 - cos(angle) of the ring's middle
            const double side = std::sqrt(depth * (2.0 - depth));
            const glm::vec3 point(side, depth - 1.0, 0.0);
            flux += sampleSpotlight(light, point).irradiance.x * 2.0 * kPi * step;
        }
        EXPECT_NEAR(flux, 100.0, 100.0 * (1.0 / rings)) << aperture;
    }
}

/// The power of a light at the origin by the midpoint rule, over directions (x, -1, z) of a square
/// that holds its beam: each has a solid angle of (1 + x^2 + z^2)^-3/2.
double powerOf(Spotlight description) {
    description.position = {0, 0, 0};
    description.target = {0, -1, 0};
    const GridSpotlight light = makeGridSpotlight(description, GridFrame{});
    const int n = 1000;
    const double reach = 1.001 * std::tan(description.aperture * kPi / 360.0), step = 2 * reach / n;
    double power = 0.0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double x = (i + 0.5) * step - reach, z = (j + 0.5) * step - reach;
            const double squared = 1.0 + x * x + z * z;
            // irradiance is intensity over the squared distance
            power += sampleSpotlight(light, glm::vec3(x, -1.0, z)).irradiance.x * step * step /
                     std::sqrt(squared);
        }
    return power;
}

TEST(Spotlight, PowerIsFluxLessTheFallOff) {
    Spotlight light;
    light.flux = 10.0f;
    light.aperture = light.penumbra = 70.0f;
    EXPECT_NEAR(powerOf(light), 10.0,
                0.02); // some of the 3000 cells at the border are counted whole
    light.penumbra = 0.0f;
    light.exponent = 2.0f;
    EXPECT_NEAR(powerOf(light), 10.0 / 3.0, 1e-3);
    light.penumbra = 30.0f;
    light.exponent = 1.0f;
    const double all = 1.0 - std::cos(35.0 * kPi / 180.0),
                 even = 1.0 - std::cos(15.0 * kPi / 180.0);
    EXPECT_NEAR(powerOf(light), 10.0 * (even + (all - even) / 2.0) / all, 1e-3);
    light.aperture = light.penumbra = 60.0f;
    light.conical = false;
    const double corner = std::asin(0.25), outer = 1.0 - std::cos(kPi / 6.0);
    EXPECT_NEAR(powerOf(light), 10.0 * 4.0 * corner / (2.0 * kPi * outer), 0.02); // 12.0
}

TEST(Spotlight, SquareFrustum) {
    Spotlight description = lightAbove();
    description.conical = false;
    const GridSpotlight light = makeGridSpotlight(description, GridFrame{});
    // Half aperture 45 degrees: |x| and |z| up to the depth are lit, corners included.
    EXPECT_GT(sampleSpotlight(light, {0.99f, 1.0f, 0.99f}).irradiance.x, 0.0f);
    EXPECT_GT(sampleSpotlight(light, {-0.99f, 1.0f, 0.99f}).irradiance.x, 0.0f);
    EXPECT_EQ(sampleSpotlight(light, {1.01f, 1.0f, 0.0f}).irradiance.x, 0.0f);
    EXPECT_EQ(sampleSpotlight(light, {0.0f, 1.0f, -1.01f}).irradiance.x, 0.0f);
    EXPECT_EQ(sampleSpotlight(light, {0.0f, 3.0f, 0.0f}).irradiance.x, 0.0f);
}

TEST(Spotlight, WorldUnitsAtAnyScaleAndInBothModes) {
    // The same world seen from two eyes and in both modes, enlarged by any factor s with s^2 times
    // the flux: the same irradiance everywhere.
    const glm::vec3 world(0.4f, 0.25f, -0.3f);
    const float reference =
        sampleSpotlight(makeGridSpotlight(lightAbove(), GridFrame{}), world).irradiance.x;
    for (float s : {1e-6f, 1e-3f, 1.0f, 1e6f})
        for (ViewMode mode : {ViewMode::full, ViewMode::single}) {
            Spotlight description = lightAbove();
            description.position *= s;
            description.flux *= s * s;
            Camera camera;
            camera.eye = glm::vec3(1.0f, 1.5f, 2.0f) * s;
            camera.target = glm::vec3(0.1f, 0.2f, 0.0f) * s;
            Mesh mesh;
            mesh.positions = {world * s, glm::vec3(s, 0, 0), glm::vec3(0, 0, s)};
            mesh.triangles = {{0, 1, 2}};
            const GridFrame frame = makeFrameGeometry(mesh, camera, mode).frame;
            const LightSample sample =
                sampleSpotlight(makeGridSpotlight(description, frame), frame.toGrid(world * s));
            // Position and rotation are rounded at coordinates of about 3, the distance is 1.8.
            EXPECT_NEAR(sample.irradiance.x / reference, 1.0, 4 * kRounding) << s;
        }
}

/// By powers of two nothing is rounded otherwise, though the flux leaves float's range.
TEST(Spotlight, ScalesByPowersOfTwoToTheBit) {
    const glm::vec3 world(0.4f, 0.25f, -0.3f);
    const auto irradiance = [&](int exponent) {
        const float s = std::ldexp(1.0f, exponent);
        Spotlight description = lightAbove();
        description.position *= s;
        description.flux = std::ldexp(description.flux, 2 * exponent);
        Camera camera;
        camera.eye = glm::vec3(1.0f, 1.5f, 2.0f) * s;
        Mesh mesh;
        mesh.positions = {world * s, glm::vec3(s, 0, 0), glm::vec3(0, 0, s)};
        mesh.triangles = {{0, 1, 2}};
        const GridFrame frame = makeFrameGeometry(mesh, camera, ViewMode::full).frame;
        return sampleSpotlight(makeGridSpotlight(description, frame), frame.toGrid(world * s))
            .irradiance;
    };
    for (int exponent : {-110, -83, -40, -1, 1, 40, 83, 110})
        EXPECT_EQ(irradiance(exponent), irradiance(0)) << exponent;
}

/// The squares of these distances are no floats.
TEST(Spotlight, ShinesFromAsFarAndAsNearAsFloatTells) {
    const double intensity = 100.0 / (2.0 * kPi * (1.0 - std::cos(kPi / 4.0)));
    for (int exponent : {-100, -70, -20, 20, 70, 120}) {
        const float distance = std::ldexp(1.0f, exponent);
        Spotlight description = lightAbove();
        description.position = {0, distance, 0};
        description.target = glm::vec3(0.0f);
        const double nearest = std::max((double) distance, 0x1p-63); // kNearestToLight
        description.flux = roundedFlux(description.flux * nearest * nearest);
        const GridSpotlight light = makeGridSpotlight(description, GridFrame{});
        const LightSample sample = sampleSpotlight(light, glm::vec3(0.0f));
        EXPECT_NEAR(sample.irradiance.x / intensity, 1.0, kRounding) << exponent;
        EXPECT_EQ(sample.direction, glm::vec3(0, 1, 0));
    }
}

/// What no float holds is a bound, and never a NaN.
TEST(Spotlight, IrradianceIsBounded) {
    for (double flux : {1e-300, 1e300, std::numeric_limits<double>::max()})
        for (float distance : {1e-38f, 1e-20f, 1.0f, 1e20f, 3e38f})
            for (glm::vec3 color : {glm::vec3(0, 1, FLT_MAX), glm::vec3(0.0f)}) {
                Spotlight description = lightAbove();
                description.position = {0, distance, 0};
                description.color = color;
                description.flux = flux;
                const GridSpotlight light = makeGridSpotlight(description, GridFrame{});
                for (float x : {0.0f, 1e-30f, 1.0f, 1e30f}) { // in and outside its cone
                    const glm::vec3 found = sampleSpotlight(light, {x, 0, 0}).irradiance;
                    for (int c = 0; c < 3; ++c) {
                        EXPECT_GE(found[c], 0.0f) << flux << " " << distance << " " << x;
                        EXPECT_LE(found[c], kMostRadiance) << flux << " " << distance << " " << x;
                    }
                }
            }
}

TEST(CameraRays, BothModesLookTheSame) {
    Camera camera;
    camera.eye = {3, 2, 1};
    camera.target = {-1, 0.5f, 0.25f};
    camera.verticalFov = 53.0f;
    const CameraBasis basis = cameraBasis(camera);
    const CameraRays full(camera, 200, 100, ViewMode::full);
    const CameraRays single(camera, 200, 100, ViewMode::single);
    for (float y : {0.0f, 0.5f, 50.0f, 99.9f})
        for (float x : {0.0f, 0.5f, 100.0f, 199.9f}) {
            const glm::dvec3 world(full.through(x, y).direction);
            const glm::dvec3 view(single.through(x, y).direction);
            // Values of at most 2, a few roundings each.
            EXPECT_NEAR(glm::dot(world, glm::dvec3(basis.right)), view.x, 8 * 0x1p-23);
            EXPECT_NEAR(glm::dot(world, glm::dvec3(basis.down)), view.y, 8 * 0x1p-23);
            EXPECT_NEAR(glm::dot(world, glm::dvec3(basis.forward)), view.z, 8 * 0x1p-23);
            EXPECT_EQ(view.z, 1.0);
        }
}

TEST(CameraRays, PixelZeroIsTopLeft) {
    Camera camera; // looks along -Z, Y up
    const CameraRays rays(camera, 100, 100, ViewMode::full);
    const glm::vec3 corner = rays.through(0.0f, 0.0f).direction;
    const float slope = (float) std::tan(22.5 * kPi / 180.0);
    EXPECT_NEAR(corner.x, -slope, 0x1p-22);
    EXPECT_NEAR(corner.y, slope, 0x1p-22);
    EXPECT_EQ(corner.z, -1.0f);
}

} // namespace
} // namespace dirt
