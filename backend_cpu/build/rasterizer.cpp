#include "backend_cpu/build/rasterizer.h"

#include "core/grid/scan.h"

#include <bit>

// Compiles what follows once for each instruction set that Highway knows on this architecture.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "backend_cpu/build/rasterizer.cpp"
#include <hwy/foreach_target.h>

#include "backend_cpu/build/row_spans-inl.h"
#include "backend_cpu/build/tile_clip-inl.h"
#include "backend_cpu/build/tile_range-inl.h"

HWY_BEFORE_NAMESPACE();
namespace dirt::HWY_NAMESPACE {

/// Triangles with no more tiles in their range go to the clip without a look at their edges, which
/// the clip tests too.
inline constexpr int kSmallRange = 16;

/// The rasterization of one piece. Most triangles lie in one tile: these are done first, all
/// together. The others follow in order: tile ranges in each view, then pairs of a triangle and a
/// tile, which are collected and clipped in batches; and whenever a pair is written, so are the
/// fragments of all triangles before it.
class Rasterizer {
public:
    Rasterizer(const Grid& grid, const RasterTables& tables, const Triangle* triangles,
               uint32_t firstId, RasterPiece& out)
        : grid_(grid), tables_(tables), triangles_(triangles), firstId_(firstId), out_(out) {}

    /// All triangles of the piece.
    void run(uint32_t count) {
        const WideIntTag di;
        const uint32_t lanes = (uint32_t) hn::Lanes(di);
        const WideInts last = hn::Set(di, (int32_t) count - 1);
        run(count, [&](uint32_t i, WideInts& id) HWY_ATTR {
            id = hn::Iota(di, (int32_t) i);
            return i + lanes <= count ? WideVertices::from(triangles_ + i)
                                      : WideVertices::at(triangles_, hn::Min(id, last));
        });
    }

    /// Those of \p ids.
    void run(std::span<const uint32_t> ids) {
        const WideIntTag di;
        // Any triangle will do beyond the last; each is read before its place is used again.
        std::fill_n(std::copy(ids.begin(), ids.end(), rest_), kMaxWide, (int32_t) ids.back());
        run((uint32_t) ids.size(), [&](uint32_t i, WideInts& id) HWY_ATTR {
            id = hn::LoadU(di, rest_ + i);
            return WideVertices::at(triangles_, id);
        });
    }

private:
    /// \p load(i, ids) gives the vertices of the i-th triangle and those after it.
    template <class Load>
    void run(uint32_t count, const Load& load) {
        out_.fragments.clear();
        out_.atEye.clear();
        findSingles(count, load);
        for (uint32_t i = 0; i < restCount_; i += (uint32_t) hn::Lanes(WideTag())) findPairs(i);
        clip(true);
        writeSinglesBefore(UINT32_MAX);
    }

    template <class Load>
    void findSingles(uint32_t count, const Load& load) {
        const WideTag d;
        const WideIntTag di;
        const FloatTag df;
        const uint32_t lanes = (uint32_t) hn::Lanes(d);
        const WideInts end = hn::Set(di, (int32_t) count);
        for (uint32_t i = 0; i < count; i += lanes) {
            WideInts id;
            const InOneTile single(tables_, load(i, id));
            const auto exists = hn::RebindMask(d, hn::Lt(hn::Iota(di, (int32_t) i), end));
            const auto is = hn::And(single.is, exists), isNot = hn::AndNot(single.is, exists);
            const auto keep = [&](auto tag, auto* to, auto v, auto mask)
                                  HWY_ATTR { hn::StoreU(hn::Compress(v, mask), tag, to); };
            keep(di, singleId_ + singleCount_, id, hn::RebindMask(di, is));
            keep(di, singleTile_ + singleCount_, single.tile, hn::RebindMask(di, is));
            keep(d, singleNear_ + singleCount_, single.near, is);
            keep(d, singleFar_ + singleCount_, single.far, is);
            singleCount_ += (uint32_t) hn::CountTrue(d, is);
            keep(di, rest_ + restCount_, id, hn::RebindMask(di, isNot));
            restCount_ += (uint32_t) hn::CountTrue(d, isNot);
        }
        const DoubleTag dd;
        for (uint32_t i = 0; i < singleCount_; i += (uint32_t) hn::Lanes(dd)) {
            const Floats near = hn::LoadU(df, singleNear_ + i), far = hn::LoadU(df, singleFar_ + i);
            hn::StoreU(roundNear(hn::PromoteTo(dd, near)), df, singleNear_ + i);
            hn::StoreU(roundFar(hn::PromoteTo(dd, far)), df, singleFar_ + i);
        }
    }

    /// The pairs of as many of the other triangles as a vector holds.
    void findPairs(uint32_t begin) {
        const WideTag d;
        const WideIntTag di;
        const uint32_t lanes = (uint32_t) hn::Lanes(d);
        const uint32_t count = std::min(lanes, restCount_ - begin);
        for (uint32_t i = count; i < lanes; ++i) rest_[begin + i] = rest_[begin];
        const uint32_t exist = (1u << count) - 1;
        const WideVertices vertices = WideVertices::at(triangles_, hn::LoadU(di, rest_ + begin));
        auto ordinary = areOrdinary(vertices);
        if (!tables_.ordinary) ordinary = hn::Lt(hn::Zero(d), hn::Zero(d));
        uint32_t any = 0;
        for (int v = 0; v < tables_.views; ++v) {
            findRanges(tables_, v, vertices, ordinary, ranges_[v]);
            any |= ranges_[v].simple | ranges_[v].other;
        }
        findAtEye(vertices, exist, rest_ + begin);
        for (any &= exist; any != 0; any &= any - 1) {
            const uint32_t lane = (uint32_t) std::countr_zero(any);
            const uint32_t triangle = (uint32_t) rest_[begin + lane];
            for (int v = 0; v < tables_.views; ++v) {
                if (ranges_[v].simple >> lane & 1)
                    addRange(triangle, v, ranges_[v].range(lane));
                else if (ranges_[v].other >> lane & 1)
                    addByDefinition(triangle, v);
            }
        }
    }

    void findAtEye(const WideVertices& t, uint32_t exist, const int32_t* rest) {
        const WideTag d;
        const Wide zero = hn::Zero(d);
        auto aside = hn::Lt(zero, zero);
        for (int i = 0; i < 3; ++i)
            aside = hn::Or(aside, hn::Or(hn::Gt(min3(t.v[0][i], t.v[1][i], t.v[2][i]), zero),
                                         hn::Lt(max3(t.v[0][i], t.v[1][i], t.v[2][i]), zero)));
        for (uint32_t around = exist & ~simdMaskBits(d, aside); around != 0; around &= around - 1) {
            const uint32_t triangle = (uint32_t) rest[std::countr_zero(around)];
            if (holdsEye(triangles_[triangle])) out_.atEye.push_back(firstId_ + triangle);
        }
    }

    void addByDefinition(uint32_t triangle, int view) {
        ViewTriangle setup;
        if (!setUpTriangle(triangles_[triangle], grid_.views[view], setup)) return;
        const TileRange range = tileRange(setup, grid_.views[view]);
        if (!range.empty()) addRange(triangle, view, range);
    }

    void addRange(uint32_t triangle, int view, const TileRange& range) {
        const int columns = range.column1 - range.column0 + 1;
        if (columns * (range.row1 - range.row0 + 1) <= kSmallRange) {
            for (int row = range.row0; row <= range.row1; ++row)
                addRow(triangle, view, row, range.column0, range.column1);
            return;
        }
        ViewTriangle setup;
        setUpTriangle(triangles_[triangle], grid_.views[view], setup);
        forEachSpan(setup, tables_, range, [&](int row, int column0, int column1) {
            addRow(triangle, view, row, column0, column1);
        });
    }

    void addRow(uint32_t triangle, int view, int row, int column0, int column1) {
        for (int column = column0; column <= column1; ++column) {
            pairs_[pairCount_++] = {triangle, TilePair::placeOf(view, row, column)};
            if (pairCount_ == kPairs) clip(false);
        }
    }

    /// Clips the pairs that have been collected; \p all, or whole batches only.
    void clip(bool all) {
        const uint32_t lanes = (uint32_t) hn::Lanes(DoubleTag());
        uint32_t begin = 0;
        for (; begin + lanes <= pairCount_; begin += lanes) clipBatch(begin, lanes);
        const uint32_t left = pairCount_ - begin;
        if (all && left > 0) {
            for (uint32_t i = left; i < lanes; ++i) pairs_[begin + i] = pairs_[begin];
            clipBatch(begin, left);
            pairCount_ = 0;
            return;
        }
        for (uint32_t i = 0; i < left; ++i) pairs_[i] = pairs_[begin + i];
        pairCount_ = left;
    }

    void clipBatch(uint32_t begin, uint32_t count) {
        const TilePair* pairs = pairs_ + begin;
        ClipResult result;
        TileClip(tables_, reinterpret_cast<const float*>(triangles_), pairs).run(result);
        uint32_t listed = (result.listed | result.doubt) & ((1u << count) - 1);
        for (; listed != 0; listed &= listed - 1) {
            const uint32_t lane = (uint32_t) std::countr_zero(listed);
            const TilePair& pair = pairs[lane];
            DepthInterval depths{result.near[lane], result.far[lane]};
            if ((result.doubt >> lane & 1) != 0 && !clipExactly(pair, depths)) continue;
            writeSinglesBefore(pair.triangle);
            const uint32_t tile = tables_.tilesPerView * (uint32_t) pair.view() +
                                  (uint32_t) (pair.row() * tables_.axes[0].tiles + pair.column());
            out_.fragments.push_back({tile, firstId_ + pair.triangle, depths.near, depths.far});
        }
    }

    bool clipExactly(const TilePair& pair, DepthInterval& depths) const {
        const View& view = grid_.views[pair.view()];
        ViewTriangle setup;
        return setUpTriangle(triangles_[pair.triangle], view, setup) &&
               !edgesSeparate(setup, view, pair.column(), pair.row()) &&
               clipToTile(setup, view, pair.column(), pair.row(), depths);
    }

    void writeSinglesBefore(uint32_t triangle) {
        for (; written_ < singleCount_ && (uint32_t) singleId_[written_] < triangle; ++written_)
            out_.fragments.push_back({(uint32_t) singleTile_[written_],
                                      firstId_ + (uint32_t) singleId_[written_],
                                      singleNear_[written_], singleFar_[written_]});
    }

    static constexpr uint32_t kPairs = 512;
    static constexpr size_t kSpace = kTrianglesPerPiece + kMaxWide;

    const Grid& grid_;
    const RasterTables& tables_;
    const Triangle* triangles_;
    uint32_t firstId_;
    RasterPiece& out_;

    uint32_t singleCount_ = 0, restCount_ = 0, pairCount_ = 0, written_ = 0;
    int32_t singleId_[kSpace], singleTile_[kSpace], rest_[kSpace];
    float singleNear_[kSpace], singleFar_[kSpace];
    TilePair pairs_[kPairs + kMaxLanes];
    TileRanges ranges_[RasterTables::kViews];
};

void Rasterize(const FrameGeometry& geometry, const Grid& grid, const RasterTables& tables,
               size_t begin, size_t end, RasterPiece& piece) {
    Rasterizer(grid, tables, geometry.triangles.data() + begin, (uint32_t) begin, piece)
        .run((uint32_t) (end - begin));
}

void RasterizeSome(const FrameGeometry& geometry, const Grid& grid, const RasterTables& tables,
                   size_t first, std::span<const uint32_t> ids, RasterPiece& piece) {
    Rasterizer(grid, tables, geometry.triangles.data() + first, (uint32_t) first, piece).run(ids);
}

} // namespace dirt::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace dirt {

HWY_EXPORT(Rasterize);
HWY_EXPORT(RasterizeSome);

void rasterize(const FrameGeometry& geometry, const Grid& grid, const RasterTables& tables,
               size_t begin, size_t end, RasterPiece& piece) {
    HWY_DYNAMIC_DISPATCH(Rasterize)(geometry, grid, tables, begin, end, piece);
}

void rasterizeSome(const FrameGeometry& geometry, const Grid& grid, const RasterTables& tables,
                   size_t first, std::span<const uint32_t> ids, RasterPiece& piece) {
    HWY_DYNAMIC_DISPATCH(RasterizeSome)(geometry, grid, tables, first, ids, piece);
}

} // namespace dirt
#endif // HWY_ONCE
