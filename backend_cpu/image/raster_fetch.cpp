#include "backend_cpu/image/raster_fetch.h"

#include "backend_cpu/build/rasterizer.h"
#include "backend_cpu/image/prefetch_texels.h"
#include "core/path/fetch_surface.h"

#include <algorithm>
#include <bit>
#include <span>

#include <hwy/cache_control.h>

namespace dirt {
namespace {

constexpr size_t kPixelsPerPiece = 4096;
constexpr size_t kPointsPerPiece = 1024;
/// How many points ahead their buffers are asked for, and then their texels.
constexpr size_t kBuffersAhead = 32, kTexelsAhead = 8;

/// Owner of no record.
constexpr uint32_t kNoPixel = 0xffffffffu;

/// A set of small numbers.
class BitSet {
public:
    /// Empty, of numbers below \p count.
    void clear(size_t count) { words_.assign((count + 63) / 64, 0); }
    void insert(uint32_t i) { words_[i / 64] |= bit(i); }
    void remove(uint32_t i) { words_[i / 64] &= ~bit(i); }
    bool holds(uint32_t i) const { return (words_[i / 64] & bit(i)) != 0; }
    const std::vector<uint64_t>& words() const { return words_; }

    static uint64_t bit(uint32_t i) { return uint64_t(1) << i % 64; }

private:
    std::vector<uint64_t> words_;
};

/// The records of some neighbouring primitives, in lists of those that have any.
class HitLists {
public:
    /// Files \p entries, of the \p count primitives from \p first on.
    void fill(std::span<const HitEntry> entries, uint32_t first, uint32_t count) {
        named_.clear(count);
        for (const HitEntry& entry : entries) named_.insert(entry.primitive - first);
        ids_.clear();
        before_.clear();
        for (size_t word = 0; word < named_.words().size(); ++word) {
            before_.push_back((uint32_t) ids_.size());
            for (uint64_t rest = named_.words()[word]; rest != 0; rest &= rest - 1)
                ids_.push_back((uint32_t) (word * 64) + (uint32_t) std::countr_zero(rest));
        }
        // Each list is filled from its end, which leaves heads at the beginnings.
        heads_.assign(ids_.size() + 1, 0);
        for (const HitEntry& entry : entries) ++heads_[listOf(entry.primitive - first)];
        uint32_t sum = 0;
        for (uint32_t& head : heads_) head = sum += head;
        records_.resize(entries.size());
        for (size_t i = entries.size(); i-- > 0;)
            records_[--heads_[listOf(entries[i].primitive - first)]] = entries[i];
    }

    /// The primitives that have records, increasing and counted from the first.
    std::span<const uint32_t> ids() const { return ids_; }
    /// The records of the i-th of them, in the order of pixels, and how many there are before.
    std::span<const HitEntry> list(size_t i) const {
        return {records_.data() + heads_[i], records_.data() + heads_[i + 1]};
    }
    size_t before(size_t i) const { return heads_[i]; }

private:
    size_t listOf(uint32_t id) const {
        const uint64_t smaller = named_.words()[id / 64] & (BitSet::bit(id) - 1);
        return before_[id / 64] + (size_t) std::popcount(smaller);
    }

    BitSet named_;
    std::vector<uint32_t> ids_;
    std::vector<uint32_t> before_; ///< each word of the set
    std::vector<uint32_t> heads_;
    std::vector<HitEntry> records_;
};

/// Files the records in buckets of neighbouring primitives; pixels without one see nothing.
void fileRecords(const FrameContext& frame, const Grid& grid, Executor& executor,
                 FetchBuffers& buffers, PathBuffers& paths) {
    const std::vector<Hit>& hits = paths.hits;
    buffers.pieces.resize((hits.size() + kPixelsPerPiece - 1) / kPixelsPerPiece);
    executor.forRange(hits.size(), kPixelsPerPiece, [&](size_t begin, size_t end) {
        std::vector<HitEntry>& entries = buffers.pieces[begin / kPixelsPerPiece].fragments;
        entries.clear();
        for (size_t pixel = begin; pixel < end; ++pixel) {
            const Hit& hit = hits[pixel];
            if (!hit.found()) {
                paths.clearNext(pixel);
                continue;
            }
            const uint32_t tile = hit.view < grid.views.size() ? grid.firstTile[hit.view] + hit.tile
                                                               : grid.firstTile.back();
            entries.push_back({hit.primitive, tile, (uint32_t) pixel});
        }
    });
    buffers.buckets.fill(buffers.pieces, (uint32_t) frame.geometry.triangles.size(), executor);
}

/// Rasterizes the primitives of one bucket that records name. Writes to \p pixels the owner of each
/// record in whose tile its primitive is, by primitive; another record's sees nothing.
void findRecords(const FrameContext& frame, const Grid& grid, const FetchBuffers& buffers,
                 size_t bucket, std::span<uint32_t> pixels, PathBuffers& paths) {
    thread_local HitLists lists;
    thread_local RasterPiece piece;
    thread_local BitSet covered;
    const uint32_t first = buffers.buckets.firstTile(bucket), eye = grid.firstTile.back();
    lists.fill(buffers.buckets[bucket], first, buffers.buckets.tiles(bucket));
    covered.clear(eye + 1);
    const std::span<const uint32_t> ids = lists.ids();
    for (size_t begin = 0; begin < ids.size(); begin += kTrianglesPerPiece) {
        const size_t end = std::min(begin + kTrianglesPerPiece, ids.size());
        rasterizeSome(frame.geometry, grid, buffers.tables, first, ids.subspan(begin, end - begin),
                      piece);
        auto fragment = piece.fragments.begin();
        auto atEye = piece.atEye.begin();
        for (size_t i = begin; i < end; ++i) {
            const uint32_t id = first + ids[i];
            const auto itsFirst = fragment;
            for (; fragment != piece.fragments.end() && fragment->id == id; ++fragment)
                covered.insert(fragment->tile);
            const bool holdsEye = atEye != piece.atEye.end() && *atEye == id;
            if (holdsEye) covered.insert(eye), ++atEye;
            uint32_t* out = pixels.data() + lists.before(i);
            for (const HitEntry& entry : lists.list(i)) {
                const bool found = covered.holds(entry.tile);
                if (!found) paths.clearNext(entry.pixel);
                *out++ = found ? entry.pixel : kNoPixel;
            }
            for (auto it = itsFirst; it != fragment; ++it) covered.remove(it->tile);
            if (holdsEye) covered.remove(eye);
        }
    }
}

void askForBuffers(const PathBuffers& paths, uint32_t pixel) {
    hwy::Prefetch(&paths.hits[pixel]);
    hwy::Prefetch(&paths.rays[pixel].direction);
    if (paths.next.empty()) return;
    const auto* point = reinterpret_cast<const char*>(&paths.next[pixel]);
    hwy::Prefetch(point);
    hwy::Prefetch(point + sizeof(SurfacePoint) - 1);
}

} // namespace

void rasterFetch(const FrameContext& frame, const Grid& grid, Executor& executor,
                 FetchBuffers& buffers, PathBuffers& paths) {
    buffers.tables.set(grid);
    fileRecords(frame, grid, executor, buffers, paths);
    const auto& buckets = buffers.buckets;
    std::vector<uint32_t>& pixels = buffers.pixels;
    pixels.resize(buckets.before(buckets.count()));
    executor.forRange(buckets.count(), 1, [&](size_t bucket, size_t) {
        findRecords(frame, grid, buffers, bucket,
                    std::span(pixels).subspan(buckets.before(bucket), buckets[bucket].size()),
                    paths);
    });
    // By primitive, since a triangle's data and texels are then near those of the one before; the
    // buffers' places are known early enough to ask for them.
    executor.forRange(pixels.size(), kPointsPerPiece, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            if (i + kBuffersAhead < end && pixels[i + kBuffersAhead] != kNoPixel)
                askForBuffers(paths, pixels[i + kBuffersAhead]);
            if (i + kTexelsAhead < end && pixels[i + kTexelsAhead] != kNoPixel) {
                const Hit& ahead = paths.hits[pixels[i + kTexelsAhead]];
                prefetchTexels(frame.scene, ahead.primitive, ahead.u, ahead.v);
            }
            const uint32_t pixel = pixels[i];
            if (pixel == kNoPixel) continue;
            Hit& hit = paths.hits[pixel];
            paths.setNext(pixel,
                          fetchSurface(frame.scene, frame.geometry, paths.rays[pixel].direction,
                                       hit.primitive, hit.u, hit.v),
                          frame.geometry);
            ++hit.fetches;
        }
    });
}

} // namespace dirt
