#include "backend_cpu/trace/without_area.h"

#include "core/trace/determinant.h"
#include "shaders/shared/margins.h"

#include <algorithm>

// Compiles what follows once for each instruction set that Highway knows on this architecture.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "backend_cpu/trace/without_area.cpp"
#include <hwy/foreach_target.h>

#include "backend_cpu/build/load_triangles-inl.h"
#include "backend_cpu/build/simd_mask-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Sets \p result to 1 where a component of the normal may be zero in all three. It has two
/// products of two differences: below 2^-51 of them off in double.
void FindThin(std::span<const Triangle> triangles, uint8_t* result) {
    const hn::CappedTag<double, 8> d;
    const hn::Rebind<float, decltype(d)> df;
    const hn::Rebind<int32_t, decltype(d)> di;
    using V = hn::Vec<decltype(d)>;
    const size_t lanes = hn::Lanes(d);
    const auto last = hn::Set(di, (int32_t) triangles.size() - 1);
    for (size_t i = 0; i < triangles.size(); i += lanes) {
        const auto index = hn::Min(hn::Iota(di, (int32_t) i), last);
        const auto t = i + lanes <= triangles.size()
                           ? Vertices<decltype(df)>::from(triangles.data() + i)
                           : Vertices<decltype(df)>::at(triangles.data(), index);
        V b[3], c[3];
        for (int axis = 0; axis < 3; ++axis) {
            const V a = hn::PromoteTo(d, t.v[0][axis]);
            b[axis] = hn::Sub(hn::PromoteTo(d, t.v[1][axis]), a);
            c[axis] = hn::Sub(hn::PromoteTo(d, t.v[2][axis]), a);
        }
        auto thin = hn::Eq(b[0], b[0]);
        for (int x = 0; x < 3; ++x) {
            const int y = (x + 1) % 3;
            const V first = hn::Mul(b[x], c[y]), second = hn::Mul(b[y], c[x]);
            const V bound =
                hn::Mul(hn::Set(d, kThinDoubt), hn::Add(hn::Abs(first), hn::Abs(second)));
            thin = hn::AndNot(hn::Gt(hn::Abs(hn::Sub(first, second)), bound), thin);
        }
        const uint32_t bits = simdMaskBits(d, thin);
        const size_t count = std::min(lanes, triangles.size() - i);
        for (size_t lane = 0; lane < count; ++lane) result[i + lane] = bits >> lane & 1;
    }
}

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dirt {
namespace {

HWY_EXPORT(FindThin);

bool hasNoArea(const Triangle& t) {
    if (t.a == t.b || t.b == t.c || t.c == t.a) return true;
    for (const glm::vec3 axis : {glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)})
        if (directionDeterminantExact(axis, t.a, t.b, t.c) != 0.0) return false;
    return true;
}

} // namespace

void findWithoutArea(std::span<const Triangle> triangles, uint8_t* result) {
    if (triangles.empty()) return;
    HWY_DYNAMIC_DISPATCH(FindThin)(triangles, result);
    for (size_t i = 0; i < triangles.size(); ++i)
        if (result[i] != 0) result[i] = hasNoArea(triangles[i]);
}

} // namespace dirt
#endif // HWY_ONCE
