// The triangles of one tile's lists, and what is done to them in SIMD while its tree is built.
// Included once for each instruction set.

#if defined(DIRT_LEAF_ITEMS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DIRT_LEAF_ITEMS_INL_H_
#undef DIRT_LEAF_ITEMS_INL_H_
#else
#define DIRT_LEAF_ITEMS_INL_H_
#endif

#include "backend_cpu/trace/leaf_boxes.h"
#include "backend_cpu/trace/leaves.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <utility>
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
    /// Empty, with room for \p count items. Keeps its memory.
    void clear(size_t count) {
        if (items_.size() >= count) return;
        items_.resize(count);
        middles_.resize(4 * (count + kPadding));
        codes_.resize(count + kPadding);
        keys_.resize(count);
        moved_.resize(count);
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
            const Quad least = min(min(a, b), c), most = max(max(a, b), c);
            const Quad low = min(max(cellLow, least), most), high = max(min(cellHigh, most), least);
            (low + high).store(&middles_[4 * count]);
            LeafItem& item = items_[count++];
            low.store(item.low);
            high.store(item.high);
            item.id = id;
        }
        return count;
    }

    /// Items [first, first + count) in an order in which neighbours are near each other: that of a
    /// space-filling curve (Hilbert's, by Skilling, "Programming the Hilbert curve", 2004) through
    /// the middles of their boxes; within one of its cells, their own. As they are where \p count
    /// is that of one block. The lower half of each number is an item.
    const uint64_t* order(uint32_t first, uint32_t count) {
        if (count <= LeafBlock::kChildren) {
            for (uint32_t i = 0; i < count; ++i) keys_[i] = first + i;
            return keys_.data();
        }
        findCodes(first, count);
        uint32_t ends[kDigits][kRadix] = {};
        for (uint32_t i = 0; i < count; ++i) {
            const uint32_t code = (uint32_t) codes_[i];
            keys_[i] = (uint64_t) code << 32 | (first + i);
            for (int digit = 0; digit < kDigits; ++digit)
                ++ends[digit][code >> digit * kBits & (kRadix - 1)];
        }
        for (int digit = 0; digit < kDigits; ++digit) {
            uint32_t sum = 0;
            for (uint32_t& end : ends[digit]) sum = std::exchange(end, sum) + sum;
            const int shift = 32 + digit * kBits;
            for (uint32_t i = 0; i < count; ++i)
                moved_[ends[digit][keys_[i] >> shift & (kRadix - 1)]++] = keys_[i];
            std::swap(keys_, moved_);
        }
        return keys_.data();
    }

private:
    using Tag = hn::CappedTag<float, 16>;
    using IntTag = hn::RebindToSigned<Tag>;
    using Ints = hn::Vec<IntTag>;
    static constexpr size_t kPadding = 16;
    /// Cells along the longest side are 2^kBits; of a code's three digits each has as many bits.
    static constexpr int kBits = 6, kDigits = 3;
    static constexpr uint32_t kRadix = 1u << kBits;

    static HWY_INLINE Quad quad(const glm::vec3& v) {
        const float floats[4] = {v.x, v.y, v.z, 0.0f};
        return Quad::load(floats);
    }

    void findCodes(uint32_t first, uint32_t count) {
        const float* const middles = &middles_[4 * first];
        Quad least = Quad::load(middles), most = least;
        for (uint32_t i = 1; i < count; ++i) {
            const Quad middle = Quad::load(middles + 4 * i);
            least = min(least, middle);
            most = max(most, middle);
        }
        float low[4], high[4];
        least.store(low), most.store(high);
        const float extent = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
        const Tag d;
        const IntTag di;
        const auto scale = hn::Set(d, (float) kRadix / std::max(extent, 0x1p-60f)); // finite
        const auto last = hn::Set(d, (float) (kRadix - 1));
        for (uint32_t i = 0; i < count; i += (uint32_t) hn::Lanes(d)) {
            hn::Vec<Tag> x, y, z, unused;
            hn::LoadInterleaved4(d, middles + 4 * i, x, y, z, unused);
            const auto cell = [&](auto middle, int axis) HWY_ATTR {
                const auto at = hn::Mul(hn::Sub(middle, hn::Set(d, low[axis])), scale);
                return hn::ConvertTo(di, hn::Min(hn::Max(at, hn::Zero(d)), last));
            };
            hn::StoreU(code(cell(x, 0), cell(y, 1), cell(z, 2)), di, &codes_[i]);
        }
    }

    /// The places of cells along the curve.
    static HWY_INLINE Ints code(Ints x, Ints y, Ints z) {
        const IntTag di;
        const auto bits = [&](int32_t value) HWY_ATTR { return hn::Set(di, value); };
        const auto has = [&](Ints v, int32_t bit)
                             HWY_ATTR { return hn::Ne(hn::And(v, bits(bit)), hn::Zero(di)); };
        for (int32_t bit = kRadix / 2; bit > 1; bit >>= 1) {
            const Ints below = bits(bit - 1);
            x = hn::IfThenElse(has(x, bit), hn::Xor(x, below), x);
            const auto turn = [&](Ints& v) HWY_ATTR {
                const auto flips = has(v, bit);
                const Ints swapped = hn::IfThenZeroElse(flips, hn::And(hn::Xor(x, v), below));
                x = hn::IfThenElse(flips, hn::Xor(x, below), hn::Xor(x, swapped));
                v = hn::Xor(v, swapped);
            };
            turn(y);
            turn(z);
        }
        y = hn::Xor(y, x);
        z = hn::Xor(z, y);
        Ints t = hn::Zero(di);
        for (int32_t bit = kRadix / 2; bit > 1; bit >>= 1)
            t = hn::IfThenElse(has(z, bit), hn::Xor(t, bits(bit - 1)), t);
        const auto spread = [&](Ints v) HWY_ATTR {
            v = hn::Xor(v, t);
            v = hn::And(hn::Or(v, hn::ShiftLeft<8>(v)), bits(0x300f));
            v = hn::And(hn::Or(v, hn::ShiftLeft<4>(v)), bits(0x30c3));
            return hn::And(hn::Or(v, hn::ShiftLeft<2>(v)), bits(0x9249));
        };
        return hn::Or(hn::ShiftLeft<2>(spread(x)), hn::Or(hn::ShiftLeft<1>(spread(y)), spread(z)));
    }

    std::vector<LeafItem> items_;
    std::vector<float> middles_; ///< four floats each: twice the middles of the boxes
    std::vector<int32_t> codes_; ///< places along the curve
    std::vector<uint64_t> keys_, moved_;
};

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
