// The triangles of one tile's lists, and what is done to them in SIMD while its tree is built.
// Included once for each instruction set.

#if defined(DIRT_LEAF_ITEMS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DIRT_LEAF_ITEMS_INL_H_
#undef DIRT_LEAF_ITEMS_INL_H_
#else
#define DIRT_LEAF_ITEMS_INL_H_
#endif

#include "backend_cpu/leaf_boxes.h"
#include "backend_cpu/simd_mask-inl.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <span>
#include <vector>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Four floats that are handled together, of which one is no coordinate.
struct Quad {
    using Tag = hn::CappedTag<float, 4>;
    static constexpr size_t kLanes = HWY_MIN(4, hn::MaxLanes(Tag()));
    hn::Vec<Tag> part[4 / kLanes];

    template <class Each>
    static HWY_INLINE Quad of(Each&& each) {
        Quad quad;
        for (size_t i = 0; i < 4 / kLanes; ++i) quad.part[i] = each(i);
        return quad;
    }
    static HWY_INLINE Quad load(const float* from) {
        return of([=](size_t i) HWY_ATTR { return hn::LoadU(Tag(), from + i * kLanes); });
    }
    HWY_INLINE void store(float* to) const {
        for (size_t i = 0; i < 4 / kLanes; ++i) hn::StoreU(part[i], Tag(), to + i * kLanes);
    }
};
HWY_INLINE Quad min(const Quad& a, const Quad& b) {
    return Quad::of([&](size_t i) HWY_ATTR { return hn::Min(a.part[i], b.part[i]); });
}
HWY_INLINE Quad max(const Quad& a, const Quad& b) {
    return Quad::of([&](size_t i) HWY_ATTR { return hn::Max(a.part[i], b.part[i]); });
}
HWY_INLINE Quad operator+(const Quad& a, const Quad& b) {
    return Quad::of([&](size_t i) HWY_ATTR { return hn::Add(a.part[i], b.part[i]); });
}

/// A triangle of a cell's list and a box that holds its part in the cell.
struct alignas(32) LeafItem {
    float low[4]; ///< x, y, z
    float high[3];
    uint32_t id;
};

class LeafItems {
public:
    /// Room for \p count items. Keeps its memory.
    void reserve(size_t count) {
        if (items_.size() < count) items_.resize(count);
    }

    const LeafItem& operator[](uint32_t i) const { return items_[i]; }

    /// Adds the parts of triangles inside the box of their cell. A triangle beside that, listed for
    /// the guard band's or a depth's margin, keeps a point.
    template <class Skip>
    uint32_t add(uint32_t count, std::span<const uint32_t> list,
                 const std::vector<Triangle>& triangles, const LeafBox& cell, Skip&& skip) {
        const Quad cellLow = quad(cell.low), cellHigh = quad(cell.high);
        for (const uint32_t id : list) {
            if (skip(id)) continue;
            // The fourth floats are those that follow a, b and c; after the last there is none.
            float copy[12];
            const float* at = &triangles[id].a.x;
            if (id + 1 == triangles.size())
                at = static_cast<const float*>(std::memcpy(copy, at, sizeof(Triangle)));
            const Quad a = Quad::load(at), b = Quad::load(at + 3), c = Quad::load(at + 6);
            const Quad low = min(min(a, b), c), high = max(max(a, b), c);
            LeafItem& item = items_[count++];
            min(max(cellLow, low), high).store(item.low);
            max(min(cellHigh, high), low).store(item.high);
            item.id = id;
        }
        return count;
    }

    /// The box around items [begin, end).
    LeafBox box(uint32_t begin, uint32_t end) const {
        Quad low = Quad::load(items_[begin].low), high = Quad::load(items_[begin].high);
        for (uint32_t i = begin + 1; i < end; ++i) {
            low = min(low, Quad::load(items_[i].low));
            high = max(high, Quad::load(items_[i].high));
        }
        float lows[4], highs[4];
        low.store(lows), high.store(highs);
        return {{lows[0], lows[1], lows[2]}, {highs[0], highs[1], highs[2]}};
    }

    /// Brings the \p count items of [begin, end) whose boxes' middles are lowest, along the axis on
    /// which these spread widest, to the front; equal ones by their place, each half in its order.
    void split(uint32_t begin, uint32_t end, uint32_t count) {
        const uint32_t size = end - begin;
        findMiddles(begin, end);
        const Threshold threshold = findThreshold(size, count);
        uint32_t equalLeft = count - threshold.less;
        if (moved_.size() < size) moved_.resize(size);
        const V t = hn::Set(d_, threshold.value);
        LeafItem* from = items_.data() + begin;
        uint32_t low = 0, high = count;
        for (uint32_t i = 0; i < size; i += (uint32_t) hn::Lanes(d_)) {
            const auto mine = hn::FirstN(d_, size - i);
            const V middle = hn::LoadU(d_, middle_.data() + i);
            const uint32_t less = simdMaskBits(d_, hn::And(mine, hn::Lt(middle, t)));
            uint32_t equal = simdMaskBits(d_, hn::And(mine, hn::Eq(middle, t)));
            while ((uint32_t) std::popcount(equal) > equalLeft) equal ^= std::bit_floor(equal);
            equalLeft -= (uint32_t) std::popcount(equal);
            const uint32_t here = std::min((uint32_t) hn::Lanes(d_), size - i);
            for (uint32_t k = 0; k < here; ++k) {
                const uint32_t isLow = (less | equal) >> k & 1;
                moved_[isLow ? low : high] = from[i + k];
                low += isLow, high += 1 - isLow;
            }
        }
        std::memcpy(static_cast<void*>(from), moved_.data(), size * sizeof(LeafItem));
    }

private:
    using Tag = hn::CappedTag<float, 16>;
    using V = hn::Vec<Tag>;
    static constexpr size_t kPadding = 16;
    /// Of more items the threshold is selected, of fewer counted out.
    static constexpr uint32_t kCounted = 64;

    static HWY_INLINE Quad quad(const glm::vec3& v) {
        const float floats[4] = {v.x, v.y, v.z, 0.0f};
        return Quad::load(floats);
    }

    /// Twice the middles, along the widest axis.
    void findMiddles(uint32_t begin, uint32_t end) {
        if (middle_.size() < end - begin + kPadding) middle_.resize(end - begin + kPadding);
        const auto middle = [&](uint32_t i) HWY_ATTR {
            return Quad::load(items_[i].low) + Quad::load(items_[i].high);
        };
        Quad least = middle(begin), most = least;
        for (uint32_t i = begin + 1; i < end; ++i) {
            const Quad m = middle(i);
            least = min(least, m);
            most = max(most, m);
        }
        float low[4], high[4];
        least.store(low), most.store(high);
        const float x = high[0] - low[0], y = high[1] - low[1], z = high[2] - low[2];
        const int widest = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
        for (uint32_t i = begin; i < end; ++i)
            middle_[i - begin] = items_[i].low[widest] + items_[i].high[widest];
    }

    /// The middle of rank \p count, and how many are less.
    struct Threshold {
        float value;
        uint32_t less;
    };
    Threshold findThreshold(uint32_t size, uint32_t count) {
        if (size > kCounted) {
            selected_.assign(middle_.begin(), middle_.begin() + size);
            std::nth_element(selected_.begin(), selected_.begin() + count, selected_.end());
            const float value = selected_[count];
            return {value, countLess(value, size)};
        }
        for (uint32_t i = 0;; ++i) {
            const float value = middle_[i];
            const uint32_t less = countLess(value, size);
            if (less > count) continue;
            if (less == count || count < less + countEqual(value, size)) return {value, less};
        }
    }
    HWY_INLINE uint32_t countLess(float value, uint32_t size) const {
        const V v = hn::Set(d_, value);
        uint32_t less = 0;
        for (uint32_t i = 0; i < size; i += (uint32_t) hn::Lanes(d_))
            less +=
                (uint32_t) hn::CountTrue(d_, hn::And(hn::FirstN(d_, size - i),
                                                     hn::Lt(hn::LoadU(d_, middle_.data() + i), v)));
        return less;
    }
    HWY_INLINE uint32_t countEqual(float value, uint32_t size) const {
        const V v = hn::Set(d_, value);
        uint32_t equal = 0;
        for (uint32_t i = 0; i < size; i += (uint32_t) hn::Lanes(d_))
            equal +=
                (uint32_t) hn::CountTrue(d_, hn::And(hn::FirstN(d_, size - i),
                                                     hn::Eq(hn::LoadU(d_, middle_.data() + i), v)));
        return equal;
    }

    static constexpr Tag d_{};
    std::vector<LeafItem> items_, moved_;
    std::vector<float> middle_, selected_;
};

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
