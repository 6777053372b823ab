// SIMD tests of one ray against the boxes of a node and the triangles of a block. Included once
// for each instruction set.

#if defined(DIRT_LEAF_TEST_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DIRT_LEAF_TEST_INL_H_
#undef DIRT_LEAF_TEST_INL_H_
#else
#define DIRT_LEAF_TEST_INL_H_
#endif

#include "backend_cpu/trace/leaves.h"
#include "core/trace/ray.h"
#include "shaders/shared/margins.h"

#include <algorithm>
#include <cmath>

#include <hwy/cache_control.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A ray as the tests need it, and the part of it that is of interest.
///
/// Box test. A plane at p is met at (p - o) / d. The code has p as q step + origin, both within
/// the box's rounding (2^-22 with |coordinates| below 2), and computes
/// q (step inv) + (origin - o) inv: with u = 2^-24, inv, the difference, the products and the sum
/// make it at most 4 u (|q step| + |origin - o|) |inv| < 4 u (6 + |o|) |inv| off. A component of
/// the direction below 2^-40 of the largest is replaced by that, which moves no point of the ray
/// within the scene by more than 2^-40 (2 + |o|). 2^-21 (8 + |o|) |inv| is more than all of this,
/// and each plane is moved outwards by it.
struct LeafRay {
    float origin[3];
    float inverse[3];
    float pad[3];
    int sign[3]; ///< 1 where the direction is negative

    float begin, end; ///< part of the ray, rounded outwards

    int x, y, z; ///< z is the axis of the direction's largest component
    float slopeX, slopeY, lateralError;

    /// True if the tests' bounds hold for the ray.
    bool set(const Ray& ray) {
        const glm::vec3& o = ray.origin;
        const glm::vec3& d = ray.direction;
        const float ax = std::abs(d.x), ay = std::abs(d.y), az = std::abs(d.z);
        const float largest = std::max({ax, ay, az});
        const float away = std::max({std::abs(o.x), std::abs(o.y), std::abs(o.z)});
        // So that no product under- or overflows.
        if (!(largest >= 0x1p-40f && largest <= 0x1p40f && away <= 0x1p20f)) return false;
        z = ax > ay ? (ax > az ? 0 : 2) : (ay > az ? 1 : 2);
        x = (z + 1) % 3;
        y = (z + 2) % 3;
        slopeX = d[x] / d[z];
        slopeY = d[y] / d[z];
        lateralError = kLateralError * (2.0f + away);
        for (int i = 0; i < 3; ++i) {
            const float magnitude = std::max(std::abs(d[i]), kLeastDirection * largest);
            sign[i] = d[i] < 0.0f;
            origin[i] = o[i];
            inverse[i] = (sign[i] ? -1.0f : 1.0f) / magnitude;
            pad[i] = kBoxPad * (8.0f + std::abs(o[i])) * std::abs(inverse[i]);
        }
        return true;
    }

    /// Looks only at parameters from \p from to \p to.
    void setPart(double from, double to) {
        begin = (float) (from * (1.0 - kPartSlack));
        setEnd(to);
    }
    void setEnd(double to) { end = (float) std::min(to * (1.0 + kPartSlack), 0x1p120); }

    /// False only if core's RayFilter is certain of a miss, number for number; without its
    /// branches, which none foresees.
    HWY_INLINE bool mayHit(const Triangle& t) const {
        const float *const a = &t.a.x, *const b = &t.b.x, *const c = &t.c.x;
        const float az = a[z] - origin[z], bz = b[z] - origin[z], cz = c[z] - origin[z];
        const float ax = (a[x] - origin[x]) - slopeX * az;
        const float bx = (b[x] - origin[x]) - slopeX * bz;
        const float cx = (c[x] - origin[x]) - slopeX * cz;
        const float ay = (a[y] - origin[y]) - slopeY * az;
        const float by = (b[y] - origin[y]) - slopeY * bz;
        const float cy = (c[y] - origin[y]) - slopeY * cz;
        const auto least = [](float p, float q, float r) { return std::min(std::min(p, q), r); };
        const auto most = [](float p, float q, float r) { return std::max(std::max(p, q), r); };
        const float lowX = least(ax, bx, cx), highX = most(ax, bx, cx);
        const float lowY = least(ay, by, cy), highY = most(ay, by, cy);
        const float u = bx * cy - by * cx;
        const float v = cx * ay - cy * ax;
        const float w = ax * by - ay * bx;
        const float largest = std::max(std::max(-lowX, highX), std::max(-lowY, highY));
        const float error = largest * (4.0f * lateralError);
        const bool beside = (lowX > lateralError) | (highX < -lateralError) |
                            (lowY > lateralError) | (highY < -lateralError);
        return !(beside | ((most(u, v, w) > error) & (least(u, v, w) < -error)));
    }
};

/// Children of \p node whose boxes the ray's part may meet, as bits, and where it enters them.
HWY_INLINE uint32_t childrenMet(const LeafRay& ray, const LeafBoxes& node,
                                float* HWY_RESTRICT entry) {
    const hn::CappedTag<float, LeafBoxes::kChildren> d;
    const hn::Rebind<int32_t, decltype(d)> di;
    const hn::Rebind<uint8_t, decltype(d)> d8;
    using V = hn::Vec<decltype(d)>;
    uint32_t met = 0;
    for (size_t lane = 0; lane < LeafBoxes::kChildren; lane += hn::Lanes(d)) {
        V from = hn::Set(d, ray.begin), to = hn::Set(d, ray.end);
        const auto cut = [&](int i) HWY_ATTR {
            const float base = (node.origin[i] - ray.origin[i]) * ray.inverse[i];
            const V slope = hn::Set(d, node.step(i) * ray.inverse[i]);
            const auto plane = [&](const uint8_t* bound, float at) HWY_ATTR {
                const V q = hn::ConvertTo(d, hn::PromoteTo(di, hn::Load(d8, bound + lane)));
                return hn::Add(hn::Mul(q, slope), hn::Set(d, at));
            };
            from = hn::Max(from, plane(node.bound[ray.sign[i]][i], base - ray.pad[i]));
            to = hn::Min(to, plane(node.bound[1 - ray.sign[i]][i], base + ray.pad[i]));
        };
        cut(0), cut(1), cut(2);
        hn::Store(from, d, entry + lane);
        uint8_t bits[8] = {};
        hn::StoreMaskBits(d, hn::Le(from, to), bits);
        met |= (uint32_t) (bits[0] | bits[1] << 8) << lane;
    }
    return met & ((1u << node.children) - 1);
}

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
