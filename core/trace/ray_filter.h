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
/// coordinates x, y. With u = 2^-24 and N a bound of |vertex - origin|, a difference is off by u N,
/// the shear (slope, difference, product: 3 u N) and the last subtraction (of at most 2 N: 2 u N)
/// make it 6 u N. With L the largest lateral |coordinate|, a product of two is off by
/// 12 u N L + u L^2, the difference of two products by 24 u N L + 4 u L^2. The code takes 8 for 6,
/// 32 for 24 and 8 for 4, which covers terms of higher order and the rounding of the bounds.
/// Underflow only moves values towards zero, where nothing is certain.
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
        // 4 * 8 u N L >= 24 u N L with room for the rest of the first term.
        const float error = largest * (4.0f * lateralError_ + kAreaError * largest);
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
