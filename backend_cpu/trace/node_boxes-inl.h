// Boxes of a node's children, as they are gathered and then rounded to the node's steps. Included
// once for each instruction set.

#if defined(DIRT_NODE_BOXES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DIRT_NODE_BOXES_INL_H_
#undef DIRT_NODE_BOXES_INL_H_
#else
#define DIRT_NODE_BOXES_INL_H_
#endif

#include "backend_cpu/trace/leaf_boxes.h"
#include "backend_cpu/trace/leaves.h"

#include <algorithm>
#include <bit>
#include <cfloat>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

class NodeBoxes {
public:
    void add(const LeafBox& box) { add(&box.low.x, &box.high.x); }
    void add(const float* low, const float* high) {
        for (int axis = 0; axis < 3; ++axis) {
            low_[axis][count_] = low[axis], high_[axis][count_] = high[axis];
            all_.low[axis] = std::min(all_.low[axis], low[axis]);
            all_.high[axis] = std::max(all_.high[axis], high[axis]);
        }
        ++count_;
    }

    /// The box around all.
    const LeafBox& all() const { return all_; }

    void write(LeafBoxes& node) {
        const hn::CappedTag<float, LeafBoxes::kChildren> d;
        const hn::RebindToSigned<decltype(d)> di;
        const hn::Rebind<uint8_t, decltype(d)> d8;
        node.children = (uint8_t) count_;
        for (int axis = 0; axis < 3; ++axis) {
            // The power of two above a 254th of the extent: the quotients below stay under 255,
            // and are off by less than 2^-23 of the extent, which the ray's test allows for.
            const float origin = all_.low[axis];
            const float least = std::max((all_.high[axis] - origin) * (1.0f / 254.0f), 0x1p-60f);
            node.origin[axis] = origin;
            node.exponent[axis] = (uint8_t) ((std::bit_cast<uint32_t>(least) >> 23) + 1);
            std::fill(low_[axis] + count_, low_[axis] + LeafBoxes::kChildren,
                      low_[axis][count_ - 1]);
            std::fill(high_[axis] + count_, high_[axis] + LeafBoxes::kChildren,
                      high_[axis][count_ - 1]);
            const auto from = hn::Set(d, origin), inverse = hn::Set(d, 1.0f / node.step(axis));
            for (size_t i = 0; i < LeafBoxes::kChildren; i += hn::Lanes(d)) {
                const auto steps = [&](const float* at) HWY_ATTR {
                    return hn::Mul(hn::Sub(hn::Load(d, at + i), from), inverse);
                };
                const auto store = [&](auto steps, uint8_t* bound) HWY_ATTR {
                    hn::StoreU(hn::DemoteTo(d8, hn::ConvertTo(di, steps)), d8, bound + i);
                };
                store(steps(low_[axis]), node.bound[0][axis]);
                store(hn::Min(hn::Add(steps(high_[axis]), hn::Set(d, 1.0f)), hn::Set(d, 255.0f)),
                      node.bound[1][axis]);
            }
        }
    }

private:
    alignas(64) float low_[3][LeafBoxes::kChildren], high_[3][LeafBoxes::kChildren];
    LeafBox all_{glm::vec3(FLT_MAX), glm::vec3(-FLT_MAX)};
    int count_ = 0;
};

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
