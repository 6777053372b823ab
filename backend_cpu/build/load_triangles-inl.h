// Triangles from the triangle buffer to one vector a coordinate. Included once for each instruction
// set.

#if defined(DIRT_LOAD_TRIANGLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DIRT_LOAD_TRIANGLES_INL_H_
#undef DIRT_LOAD_TRIANGLES_INL_H_
#else
#define DIRT_LOAD_TRIANGLES_INL_H_
#endif

#include "core/grid/geometry.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

/// The vertices of several triangles, [vertex][component].
template <class Tag>
struct Vertices {
    using V = hwy::HWY_NAMESPACE::Vec<Tag>;
    using Index = hwy::HWY_NAMESPACE::Vec<hwy::HWY_NAMESPACE::RebindToSigned<Tag>>;
    V v[3][3];

    /// Those at \p index.
    static HWY_INLINE Vertices at(const Triangle* triangles, Index index) {
        namespace hn = hwy::HWY_NAMESPACE;
        const auto* floats = reinterpret_cast<const float*>(triangles);
        const Index first = hn::Add(hn::ShiftLeft<3>(index), index);
        Vertices result;
        for (int i = 0; i < 9; ++i)
            result.v[i / 3][i % 3] = hn::GatherIndex(Tag(), floats + i, first);
        return result;
    }

    /// As many as a vector has lanes, one after the other: apart by component, then by vertex.
    static HWY_INLINE Vertices from(const Triangle* triangles) {
        namespace hn = hwy::HWY_NAMESPACE;
        const Tag d;
        const size_t lanes = hn::Lanes(d);
        const auto* floats = reinterpret_cast<const float*>(triangles);
        HWY_ALIGN float component[3][3 * hn::MaxLanes(Tag())];
        for (size_t i = 0; i < 3; ++i) {
            V x, y, z;
            hn::LoadInterleaved3(d, floats + 3 * lanes * i, x, y, z);
            hn::Store(x, d, component[0] + lanes * i);
            hn::Store(y, d, component[1] + lanes * i);
            hn::Store(z, d, component[2] + lanes * i);
        }
        Vertices result;
        for (size_t i = 0; i < 3; ++i)
            hn::LoadInterleaved3(d, component[i], result.v[0][i], result.v[1][i], result.v[2][i]);
        return result;
    }
};

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
