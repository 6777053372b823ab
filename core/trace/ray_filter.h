#pragma once

#include "core/grid/geometry.h"
#include "core/trace/ray.h"
#include "shaders/shared/margins.h"

#include <algorithm>
#include <cmath>

namespace dirt {

/// Float filter before the exact ray-triangle decision: tells of most triangles that the line of a
/// ray certainly misses them, and is never wrong.
///
/// The triangle is seen from the ray: moved to the origin and sheared so that the ray becomes the z
/// axis (Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", 2013), which leaves lateral
/// coordinates x, y. With u = 2^-24 and N a bound of |vertex - origin|, the difference is off by
/// u N, the shear (slope, difference, product) by 3 u N, and the last subtraction by u of what it
/// gives: e <= 4 u N + u L, L the largest lateral |coordinate|, which is 2 N at most. A coordinate
/// beyond 5 u N thus has its sign.
///
/// The difference of two products of such is off by 4 e L + 2 e^2 and the products' 2 u L^2: that
/// is 16 u N L + 6 u L^2 + 2 e^2, and 28 u N L + 2 e^2. The code asks for more than 32 u N L: then
/// L is above 16 u N, as no difference exceeds 2 L^2, which makes 2 e^2 less than 2 u N L, and all
/// of it 30 u N L. The rest covers higher orders and the rounding of the bound. Underflow only
/// moves values towards zero, where nothing is certain.
class RayFilter {
public:
    /// For triangles whose |coordinates| are at most \p extent, as those of a FrameGeometry.
    explicit RayFilter(const Ray& ray, float extent = 2.0f) : origin_(ray.origin) {
        const glm::vec3& d = ray.direction;
        const float x = std::abs(d.x), y = std::abs(d.y), z = std::abs(d.z);
        z_ = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
        x_ = (z_ + 1) % 3;
        y_ = (z_ + 2) % 3;
        slopeX_ = d[x_] / d[z_];
        slopeY_ = d[y_] / d[z_];
        const float distance =
            extent + std::max({std::abs(origin_.x), std::abs(origin_.y), std::abs(origin_.z)});
        // 8 u N. Very far away nothing is certain, rather than products overflow.
        lateralError_ = distance < 0x1p40f ? kLateralError * distance : HUGE_VALF;
    }

    /// True only if the exact line does not meet the closed triangle.
    bool certainlyMisses(const Triangle& t) const {
        const float az = t.a[z_] - origin_[z_];
        const float bz = t.b[z_] - origin_[z_];
        const float cz = t.c[z_] - origin_[z_];
        const float ax = (t.a[x_] - origin_[x_]) - slopeX_ * az;
        const float bx = (t.b[x_] - origin_[x_]) - slopeX_ * bz;
        const float cx = (t.c[x_] - origin_[x_]) - slopeX_ * cz;
        if (sameSide(ax, bx, cx)) return true;
        const float ay = (t.a[y_] - origin_[y_]) - slopeY_ * az;
        const float by = (t.b[y_] - origin_[y_]) - slopeY_ * bz;
        const float cy = (t.c[y_] - origin_[y_]) - slopeY_ * cz;
        if (sameSide(ay, by, cy)) return true;

        const float u = bx * cy - by * cx;
        const float v = cx * ay - cy * ax;
        const float w = ax * by - ay * bx;
        const float largest = std::max(
            {std::abs(ax), std::abs(ay), std::abs(bx), std::abs(by), std::abs(cx), std::abs(cy)});
        const float error = largest * (4.0f * lateralError_);
        return std::max({u, v, w}) > error && std::min({u, v, w}) < -error;
    }

private:
    bool sameSide(float a, float b, float c) const {
        return std::min({a, b, c}) > lateralError_ || std::max({a, b, c}) < -lateralError_;
    }

    glm::vec3 origin_;
    int x_, y_, z_; ///< z is the axis of the direction's largest component
    float slopeX_, slopeY_, lateralError_;
};

} // namespace dirt
