#include "backend_cpu/image/image_cull.h"

// Compiles what follows once for each instruction set that Highway knows on this architecture.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "backend_cpu/image/image_cull.cpp"
#include <hwy/foreach_target.h>

#include "backend_cpu/build/load_triangles-inl.h"

#include <hwy/highway.h>

// u = 2^-24, N the largest 1-norm of a triangle's vertices. The matrix's components are at most
// 1 + 2^-20 and rounded, each sum has three products: x, y and z are off by less than e = 6 u N,
// and by what underflows, below 2^-100. All three vertices are behind the eye by more than the
// footprint's 2^-20 of their distance, 1.75 N at most, if z < -2^-19 N.
//
// With z > 2^-10 N for all, a slope x/z is off by (e/z) (1 + |x/z|), a thousandth more for the
// exact x/z in it, and u |x/z| for the division, in all 8 u (1 + |x/z|) N/z. Its place, k x/z + m,
// by 4 u (k |x/z| + 2 |m|) more, and one u of that when the margin is added: together less than
// 16 u k (1 + |x/z|) N/z + 12 u |m|. The closed triangle has no slope beyond its vertices', so
// where no whole number lies between the least and the greatest place, with the margin, no pixel's
// ray meets it.

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using CullTag = hn::CappedTag<float, 16>;
using CullVertices = Vertices<CullTag>;
using CullFloats = hn::Vec<CullTag>;
using CullMask = hn::Mask<CullTag>;

/// Lanes that certainly cover no pixel.
HWY_INLINE CullMask coversNone(const ImageCull& image, const CullVertices& t) {
    const CullTag d;
    CullFloats p[3][3], norm = hn::Zero(d); // [component][vertex]
    for (int i = 0; i < 3; ++i) {
        const auto& v = t.v[i];
        norm = hn::Max(norm, hn::Add(hn::Add(hn::Abs(v[0]), hn::Abs(v[1])), hn::Abs(v[2])));
        for (int k = 0; k < 3; ++k) {
            const float* row = image.toImage[k];
            p[k][i] = hn::Add(
                hn::Add(hn::Mul(hn::Set(d, row[0]), v[0]), hn::Mul(hn::Set(d, row[1]), v[1])),
                hn::Mul(hn::Set(d, row[2]), v[2]));
        }
    }
    const auto least = [&](CullFloats a, CullFloats b, CullFloats c)
                           HWY_ATTR { return hn::Min(hn::Min(a, b), c); };
    const auto most = [&](CullFloats a, CullFloats b, CullFloats c)
                          HWY_ATTR { return hn::Max(hn::Max(a, b), c); };
    const auto& z = p[2];
    const CullFloats nearest = least(z[0], z[1], z[2]);
    const CullFloats tiny = hn::Set(d, 0x1p-60f); // far above what underflows
    const auto behind =
        hn::Lt(hn::Add(most(z[0], z[1], z[2]), tiny), hn::Mul(norm, hn::Set(d, -0x1p-19f)));
    const auto before = hn::Gt(nearest, hn::Add(hn::Mul(norm, hn::Set(d, 0x1p-10f)), tiny));
    const CullFloats one = hn::Set(d, 1.0f);
    const CullFloats inclined = hn::Div(norm, nearest);
    auto none = hn::Lt(one, one);
    for (int axis = 0; axis < 2; ++axis) {
        const auto& x = p[axis];
        const CullFloats a = hn::Div(x[0], z[0]), b = hn::Div(x[1], z[1]), c = hn::Div(x[2], z[2]);
        const CullFloats low = least(a, b, c), high = most(a, b, c);
        const CullFloats far = hn::Max(hn::Abs(low), hn::Abs(high));
        const CullFloats margin =
            hn::Add(hn::Set(d, image.margin[axis]), hn::Mul(hn::Set(d, image.marginPerSlope[axis]),
                                                            hn::Mul(inclined, hn::Add(one, far))));
        const CullFloats k = hn::Set(d, image.perSlope[axis]), m = hn::Set(d, image.middle[axis]);
        const CullFloats first = hn::Ceil(hn::Sub(hn::Add(hn::Mul(k, low), m), margin));
        const CullFloats last = hn::Floor(hn::Add(hn::Add(hn::Mul(k, high), m), margin));
        none = hn::Or(none, hn::Lt(last, hn::Max(first, hn::Zero(d))));
        none = hn::Or(none, hn::Gt(first, hn::Set(d, image.last[axis])));
    }
    return hn::Or(behind, hn::And(before, none));
}

size_t KeepInImage(const ImageCull& image, std::span<const Triangle> triangles, uint32_t* kept) {
    const CullTag d;
    const hn::RebindToSigned<CullTag> di;
    const hn::RebindToUnsigned<CullTag> du;
    const size_t lanes = hn::Lanes(d);
    const auto end = hn::Set(di, (int32_t) triangles.size());
    const auto last = hn::Sub(end, hn::Set(di, 1));
    size_t count = 0;
    for (size_t i = 0; i < triangles.size(); i += lanes) {
        const auto id = hn::Iota(di, (int32_t) i);
        const auto none =
            coversNone(image, i + lanes <= triangles.size()
                                  ? CullVertices::from(triangles.data() + i)
                                  : CullVertices::at(triangles.data(), hn::Min(id, last)));
        const auto keep = hn::AndNot(hn::RebindMask(di, none), hn::Lt(id, end));
        hn::StoreU(hn::BitCast(du, hn::Compress(id, keep)), du, kept + count);
        count += hn::CountTrue(di, keep);
    }
    return count;
}

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dirt {

HWY_EXPORT(KeepInImage);

size_t keepInImage(const ImageCull& image, std::span<const Triangle> triangles, uint32_t* kept) {
    return HWY_DYNAMIC_DISPATCH(KeepInImage)(image, triangles, kept);
}

} // namespace dirt
#endif // HWY_ONCE
