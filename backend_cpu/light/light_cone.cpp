#include "backend_cpu/light/light_cone.h"

#include "shaders/shared/margins.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace dirt {
namespace {

/// Blocks along a face by which rectangles are found where a cone reaches around the face.
constexpr int kBlocks = 16;

struct Slopes {
    double low, high;
};

/// Slopes x/w of the cone's directions, if all have w > 0: those of the tangent planes x = s w,
/// (x - s w)^2 = sin^2 (1 + s^2) for the axis.
Slopes slopesOf(const LightCone& cone, double x, double w) {
    const double sine = cone.halfAngle < std::numbers::pi / 2 ? std::sin(cone.halfAngle) : 2.0;
    const double a = w * w - sine * sine;
    if (!(w > sine) || !(a > 1e-6)) return {-1.0, 1.0};
    const double root = sine * std::sqrt(std::max(0.0, x * x + w * w - sine * sine));
    return {(x * w - root) / a - kLightConeSlack, (x * w + root) / a + kLightConeSlack};
}

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Columns (or rows) of roots that hold the slopes.
void setRange(Slopes slopes, int roots, int& first, int& count) {
    const auto rootOf = [&](double slope) {
        return std::clamp((int) std::floor((slope + 1.0) * 0.5 * roots), 0, roots - 1);
    };
    first = rootOf(slopes.low);
    count = rootOf(slopes.high) - first + 1;
}

} // namespace

LightCone::LightCone(const Spotlight& light, const GridFrame& frame)
    : axis(0.0, 0.0, 1.0), halfAngle(light.aperture * (std::numbers::pi / 360.0)) {
    const glm::dvec3 world = glm::dvec3(light.target) - glm::dvec3(light.position);
    const double distance = glm::length(world);
    if (distance > 0.0)
        axis = glm::normalize(glm::dvec3(frame.directionToGrid(glm::vec3(world / distance))));
    // The frustum's corner; what is behind the light it does not reach.
    if (!light.conical)
        halfAngle = halfAngle < 1.57 ? std::atan(std::numbers::sqrt2 * std::tan(halfAngle))
                                     : std::numbers::pi / 2;
    halfAngle = std::min(halfAngle + kLightConeSlack, std::numbers::pi);
}

double LightCone::part() const {
    const double sine = std::sin(0.5 * halfAngle);
    return sine * sine;
}

uint32_t setFaces(const LightCone& cone, int roots, std::array<LightFace, 6>& faces) {
    uint32_t sum = 0;
    for (int i = 0; i < 6; ++i) {
        LightFace& face = faces[i];
        face = {};
        face.axisW = i / 2;
        face.axisX = (face.axisW + 1) % 3;
        face.axisY = (face.axisW + 2) % 3;
        face.signW = i % 2 == 0 ? 1.0f : -1.0f;
        face.firstNode = sum;
        const glm::dvec3 axis(cone.axis[face.axisX], cone.axis[face.axisY],
                              face.signW * cone.axis[face.axisW]);

        // The box of the blocks that the cone may meet, each within a cone of its own.
        Slopes x{2.0, -2.0}, y{2.0, -2.0};
        for (int block = 0; block < kBlocks * kBlocks; ++block) {
            const double width = 2.0 / kBlocks;
            const double s = (block % kBlocks) * width - 1.0, t = (block / kBlocks) * width - 1.0;
            const glm::dvec3 middle(s + 0.5 * width, t + 0.5 * width, 1.0);
            double radius = 0.0;
            for (int corner = 0; corner < 4; ++corner)
                radius = std::max(radius, angleBetween(middle, {s + (corner & 1) * width,
                                                                t + (corner >> 1) * width, 1.0}));
            if (angleBetween(middle, axis) > cone.halfAngle + radius + kLightConeSlack) continue;
            x = {std::min(x.low, s), std::max(x.high, s + width)};
            y = {std::min(y.low, t), std::max(y.high, t + width)};
        }
        const Slopes allX = slopesOf(cone, axis.x, axis.z), allY = slopesOf(cone, axis.y, axis.z);
        x = {std::max(x.low, allX.low), std::min(x.high, allX.high)};
        y = {std::max(y.low, allY.low), std::min(y.high, allY.high)};
        if (x.low > x.high || y.low > y.high) continue;
        setRange(x, roots, face.column, face.columns);
        setRange(y, roots, face.row, face.rows);
        sum += (uint32_t) face.columns * (uint32_t) face.rows;
    }
    return sum;
}

} // namespace dirt
