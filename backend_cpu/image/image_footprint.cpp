#include "backend_cpu/image/image_footprint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/common.hpp>
#include <glm/matrix.hpp>

// The direction of a pixel's ray is R x + D y + F in float, (x, y) its slopes, at most S. With
// u = 2^-24, the pixel's position and slope are off by less than 6 S u. Each component of the sum
// is off by less than 3.01 u (2 S + 1); taken back by the inverse of (R, D, F), whose columns are
// at right angles to 2^-22, the slopes are off by (1 + S) 1.75 * 3.01 u (2 S + 1) < 11 u (1 + S)^2.
// Together less than 2^-19 (1 + S)^2. What the projection below adds, in double and away from
// z = 0, is below 2^-28 (1 + S).

namespace dirt {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Vertices this near to z = 0, relative to their distance, have no projection worth its name.
constexpr double kFlat = 0x1p-20;

struct Interval {
    double low = kInfinity, high = -kInfinity;
    void include(double x) {
        low = std::min(low, x);
        high = std::max(high, x);
    }
};

/// Includes the slope, without end, of a direction in z = 0 whose coordinate is off by at most
/// \p error.
void includeEndless(double coordinate, double error, Interval& slopes) {
    if (coordinate >= -error) slopes.include(kInfinity);
    if (coordinate <= error) slopes.include(-kInfinity);
}

/// The same for the direction in which the edge pq crosses z = 0.
void includeCrossing(double p, double pz, double q, double qz, Interval& slopes) {
    const double first = p * std::abs(qz), second = q * std::abs(pz);
    includeEndless(first + second, 0x1p-40 * (std::abs(first) + std::abs(second)), slopes);
}

} // namespace

ImageFootprint::ImageFootprint(const Camera& camera, int width, int height, ViewMode mode,
                               glm::vec2 offset)
    : toImage_(1.0), offset_(offset), size_(width, height) {
    const double slopeY = std::tan(camera.verticalFov * (std::numbers::pi / 360.0));
    const double slopeX = slopeY * width / height;
    slope_ = {-slopeX, -slopeY};
    step_ = {2.0 * slopeX / width, 2.0 * slopeY / height};
    const double largest = 1.0 + std::max(slopeX, slopeY);
    largestSlope_ = largest;
    margin_ = 0x1p-19 * largest * largest; // see above
    first_ = slope_ + offset_ * step_ - margin_;
    last_ = slope_ + (offset_ + glm::dvec2(size_ - 1)) * step_ + margin_;
    if (mode == ViewMode::full) {
        const CameraBasis basis = cameraBasis(camera);
        toImage_ = glm::inverse(glm::dmat3(basis.right, basis.down, basis.forward));
    }
}

PixelRange ImageFootprint::operator()(const Triangle& triangle) const {
    const std::array<glm::dvec3, 3> p = {toImage_ * glm::dvec3(triangle.a),
                                         toImage_ * glm::dvec3(triangle.b),
                                         toImage_ * glm::dvec3(triangle.c)};
    const auto norm = [](const glm::dvec3& v) {
        return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
    };
    // Most triangles lie beyond one side of the image as a whole: no ray is there.
    const double clear = 0x1p-40 * largestSlope_ * std::max({norm(p[0]), norm(p[1]), norm(p[2])});
    for (int axis = 0; axis < 2; ++axis) {
        const auto allBeyond = [&](double sign, double slope) {
            return sign * (p[0][axis] - slope * p[0].z) > clear &&
                   sign * (p[1][axis] - slope * p[1].z) > clear &&
                   sign * (p[2][axis] - slope * p[2].z) > clear;
        };
        if (allBeyond(-1.0, first_[axis]) || allBeyond(1.0, last_[axis])) return {};
    }
    int sides[3]; // -1 behind, 1 before the eye's plane, 0 too near to it to tell
    for (int i = 0; i < 3; ++i)
        sides[i] = std::abs(p[i].z) <= kFlat * norm(p[i]) ? 0 : p[i].z > 0.0 ? 1 : -1;
    if (sides[0] < 0 && sides[1] < 0 && sides[2] < 0) return {};

    Interval slopes[2];
    for (int i = 0; i < 3; ++i) {
        const int next = (i + 1) % 3, other = (i + 2) % 3;
        const glm::dvec3 &v = p[i], &w = p[next];
        for (int axis = 0; axis < 2; ++axis) {
            if (sides[i] > 0) slopes[axis].include(v[axis] / v.z);
            if (sides[i] * sides[next] < 0)
                includeCrossing(v[axis], v.z, w[axis], w.z, slopes[axis]);
            if (sides[i] != 0) continue;
            // Wherever the vertex and the crossings of its edges are, within kFlat: beyond the
            // image on the side that the sign says, or on either.
            double steepest = largestSlope_;
            for (const int k : {next, other})
                if (sides[k] != 0) steepest = std::max(steepest, std::abs(p[k][axis] / p[k].z));
            includeEndless(v[axis], 2.0 * kFlat * norm(v) * steepest, slopes[axis]);
        }
    }
    int first[2], last[2];
    for (int axis = 0; axis < 2; ++axis) {
        const auto pixel = [&](double slope) {
            const double x = (slope - slope_[axis]) / step_[axis] - offset_[axis];
            return std::clamp(x, -1.0, (double) size_[axis]);
        };
        first[axis] = std::max((int) std::ceil(pixel(slopes[axis].low - margin_)), 0);
        last[axis] =
            std::min((int) std::floor(pixel(slopes[axis].high + margin_)), size_[axis] - 1);
    }
    return {first[0], last[0], first[1], last[1]};
}

ImageCull ImageFootprint::cull() const {
    ImageCull cull{};
    for (int row = 0; row < 3; ++row)
        for (int k = 0; k < 3; ++k) cull.toImage[row][k] = (float) toImage_[k][row];
    for (int axis = 0; axis < 2; ++axis) {
        const double perSlope = 1.0 / step_[axis];
        const double middle = -slope_[axis] * perSlope - offset_[axis];
        cull.perSlope[axis] = (float) perSlope;
        cull.middle[axis] = (float) middle;
        cull.margin[axis] = // as image_cull.cpp says
            (float) ((margin_ * perSlope + 12 * 0x1p-24 * std::abs(middle)) * (1.0 + 0x1p-10));
        cull.marginPerSlope[axis] = (float) (0x1p-20 * perSlope); // image_cull.cpp: 16 u
        cull.last[axis] = (float) (size_[axis] - 1);
    }
    return cull;
}

} // namespace dirt
