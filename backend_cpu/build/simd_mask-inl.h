// Masks of SIMD lanes as bits. Included once for each instruction set.

#if defined(DIRT_SIMD_MASK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DIRT_SIMD_MASK_INL_H_
#undef DIRT_SIMD_MASK_INL_H_
#else
#define DIRT_SIMD_MASK_INL_H_
#endif

#include <cstdint>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

/// Bit i is that of lane i; at most 16 lanes.
template <class Tag, class Mask>
HWY_INLINE uint32_t simdMaskBits(Tag tag, Mask mask) {
    uint8_t bits[8] = {}; // as many as StoreMaskBits may write
    hwy::HWY_NAMESPACE::StoreMaskBits(tag, mask, bits);
    return (uint32_t) (bits[0] | bits[1] << 8);
}

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
