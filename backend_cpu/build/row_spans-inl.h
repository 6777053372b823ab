// Which tiles of a large range a triangle's edges leave, several rows at once. Included once for
// each instruction set.

#if defined(DIRT_ROW_SPANS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef DIRT_ROW_SPANS_INL_H_
#undef DIRT_ROW_SPANS_INL_H_
#else
#define DIRT_ROW_SPANS_INL_H_
#endif

#include "backend_cpu/build/raster_tables.h"
#include "core/grid/coverage.h"

#include <algorithm>
#include <bit>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// The spans of rows [row, row + lanes) that no edge separates. The value of an edge plane at a
/// tile's corner, as core's edgesSeparate computes it, is monotone along a row, rounded as it is;
/// so each edge leaves the tiles on one side of one border, which bisection finds.
class RowSpans {
public:
    using Tag = hn::CappedTag<float, 16>;
    using IntTag = hn::RebindToSigned<Tag>;
    static constexpr size_t kMaxRows = 16;

    RowSpans(const RasterTables& tables, const TileRange& range, int row)
        : tables_(tables), range_(range), row_(row), first_(hn::Set(di_, range.column0)),
          last_(hn::Set(di_, range.column1)) {}

    /// Leaves the tiles whose corner farthest inside is outside.
    void cut(const glm::vec3& n) {
        const bool right = n.x > 0.0f, below = n.y > 0.0f;
        const Floats y = rowTerm(n, below);
        const auto separated = [&](Ints column) HWY_ATTR {
            return hn::Lt(value(n, y, right, column), hn::Zero(d_));
        };
        if (right)
            first_ = hn::Max(first_, bisect(separated));
        else
            keepBefore(bisect([&](Ints column) HWY_ATTR { return hn::Not(separated(column)); }));
    }

    void store(int32_t* first, int32_t* last) const {
        hn::StoreU(first_, di_, first);
        hn::StoreU(last_, di_, last);
    }

private:
    using Floats = hn::Vec<Tag>;
    using Ints = hn::Vec<IntTag>;

    HWY_INLINE Floats rowTerm(const glm::vec3& n, bool high) const {
        const float* border = high ? tables_.axes[1].high : tables_.axes[1].low;
        return hn::Mul(hn::Set(d_, n.y), hn::LoadU(d_, border + row_));
    }
    HWY_INLINE Floats value(const glm::vec3& n, Floats y, bool high, Ints column) const {
        const float* border = high ? tables_.axes[0].high : tables_.axes[0].low;
        const Floats x = hn::Mul(hn::Set(d_, n.x), hn::GatherIndex(d_, border, column));
        return hn::Add(hn::Add(x, y), hn::Set(d_, n.z));
    }
    void keepBefore(Ints end) { last_ = hn::Min(last_, hn::Sub(end, hn::Set(di_, 1))); }

    /// The first column of the range for which \p holds, true up to there, does not hold.
    template <class Predicate>
    HWY_INLINE Ints bisect(Predicate&& holds) const {
        Ints low = hn::Set(di_, range_.column0), high = hn::Set(di_, range_.column1 + 1);
        const Ints one = hn::Set(di_, 1);
        const unsigned columns = (unsigned) (range_.column1 - range_.column0 + 1);
        for (int step = std::bit_width(columns); step > 0; --step) {
            const Ints middle = hn::ShiftRight<1>(hn::Add(low, high));
            const auto open = hn::Lt(low, high);
            const auto up = hn::RebindMask(di_, holds(middle));
            low = hn::IfThenElse(hn::And(open, up), hn::Add(middle, one), low);
            high = hn::IfThenElse(hn::AndNot(up, open), middle, high);
        }
        return low;
    }

    const Tag d_;
    const IntTag di_;
    const RasterTables& tables_;
    const TileRange& range_;
    int row_;
    Ints first_, last_;
};

/// Calls \p emit(row, first column, last column) for the tiles of \p range that no edge plane of
/// the triangle separates; for an edge-on triangle, which edges may separate on either side, for
/// some more.
template <class Emit>
void forEachSpan(const ViewTriangle& triangle, const RasterTables& tables, const TileRange& range,
                 Emit&& emit) {
    const int lanes = (int) hn::Lanes(RowSpans::Tag());
    int32_t first[RowSpans::kMaxRows], last[RowSpans::kMaxRows];
    for (int row = range.row0; row <= range.row1; row += lanes) {
        RowSpans spans(tables, range, row);
        for (const glm::vec3& n : triangle.edges) spans.cut(n);
        spans.store(first, last);
        const int rows = std::min(lanes, range.row1 - row + 1);
        for (int i = 0; i < rows; ++i)
            if (first[i] <= last[i]) emit(row + i, first[i], last[i]);
    }
}

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
