#include "core/grid/scan.h"
#include "core/replay/exact_part.h"
#include "core/replay/judge_structure.h"

#include <algorithm>
#include <span>
#include <tuple>

namespace dirt {

namespace {

/// Relative rounding of a place among the bins, in any engine: 2.5 ulp of a division, a rounding
/// each of two differences and a product, which is 2^-21, and as much for double's here.
constexpr double kPlaceError = 0x1p-20;

/// The bins that a depth may be in: two where it is within rounding of their border.
class BinRange {
public:
    BinRange(const DepthBounds& bounds, int bins) : near_(bounds.near), last_(bins - 1) {
        // As BinMap: one bin for all where the bounds have no depth.
        perDepth_ = BinMap(bounds, bins).scale > 0.0f
                        ? bins / ((double) bounds.far - (double) bounds.near)
                        : 0.0;
    }
    int lowest(double depth) const { return clamped(place(depth) * (1.0 - kPlaceError)); }
    int highest(double depth) const { return clamped(place(depth) * (1.0 + kPlaceError)); }

private:
    double place(double depth) const { return std::max(0.0, (depth - near_) * perDepth_); }
    int clamped(double place) const { return (int) std::min(place, (double) last_); }

    double near_, perDepth_;
    int last_;
};

/// The lists of one view.
class ViewLists {
public:
    ViewLists(const ReplayInput& input, uint32_t view)
        : input_(input), grid_(*input.grid), view_(view) {
        const auto first =
            std::partition_point(input.entries.begin(), input.entries.end(),
                                 [&](const DumpedEntry& e) { return e.view < view; });
        const auto end = std::partition_point(first, input.entries.end(),
                                              [&](const DumpedEntry& e) { return e.view == view; });
        // By (tile, triangle), each with its bins.
        entries_.assign(first, end);
        std::sort(entries_.begin(), entries_.end(), [](const DumpedEntry& a, const DumpedEntry& b) {
            return std::tie(a.tile, a.id, a.bin) < std::tie(b.tile, b.id, b.bin);
        });
        seen_.assign(entries_.size(), false);
    }

    JudgedPass judge() {
        takeOutRepeated();
        const auto& triangles = input_.geometry.triangles;
        for (uint32_t id = 0; id < triangles.size(); ++id)
            scanTriangle(triangles[id], grid_.views[view_], [&](int tile, DepthInterval depths) {
                compare((uint32_t) tile, id, depths);
            });
        for (size_t i = 0; i < entries_.size(); ++i)
            if (!seen_[i]) decide(entries_[i].tile, entries_[i].id, take(i));
        return std::move(found_);
    }

private:
    using Entries = std::span<const DumpedEntry>;

    ReplayPlace place(uint32_t tile, uint32_t bin, uint32_t id) const {
        ReplayPlace at;
        at.view = view_;
        at.tile = tile;
        at.bin = bin;
        at.primitive = id;
        return at;
    }

    void takeOutRepeated() {
        const auto isRepeated = [&](size_t i) { return i > 0 && entries_[i] == entries_[i - 1]; };
        for (size_t i = 0; i < entries_.size(); ++i) {
            if (!isRepeated(i)) continue;
            const DumpedEntry& entry = entries_[i];
            ++found_.compared;
            const ReplayPlace at = place(entry.tile, entry.bin, entry.id);
            found_.fault("listed twice", at, [&] {
                return cellText(input_, at) + " lists triangle " + std::to_string(entry.id) +
                       " twice";
            });
        }
        entries_.erase(std::unique(entries_.begin(), entries_.end()), entries_.end());
        seen_.resize(entries_.size());
    }

    /// The entries of the tile and triangle of entry \p i, from there on.
    Entries take(size_t i) {
        size_t end = i;
        while (end < entries_.size() && entries_[end].tile == entries_[i].tile &&
               entries_[end].id == entries_[i].id)
            seen_[end++] = true;
        return Entries(entries_).subspan(i, end - i);
    }

    void compare(uint32_t tile, uint32_t id, DepthInterval depths) {
        const auto at =
            std::partition_point(entries_.begin(), entries_.end(), [&](const DumpedEntry& e) {
                return std::tie(e.tile, e.id) < std::tie(tile, id);
            });
        Entries listed;
        if (at != entries_.end() && at->tile == tile && at->id == id)
            listed = take((size_t) (at - entries_.begin()));
        const BinMap bin(grid_.bounds((int) view_, (int) tile), grid_.settings.bins);
        const auto first = (uint32_t) bin(depths.near), last = (uint32_t) bin(depths.far);
        const bool isDefined = listed.size() == last - first + 1 && listed.front().bin == first &&
                               listed.back().bin == last;
        if (!isDefined) return decide(tile, id, listed);
        found_.compared += listed.size();
        found_.right += listed.size();
    }

    /// By what the exact parts ask for and allow.
    void decide(uint32_t tile, uint32_t id, Entries listed) {
        const View& view = grid_.views[view_];
        const Triangle& triangle = input_.geometry.triangles[id];
        const auto part = [&](double widened) {
            return exactPart(triangle, view, grid_.settings.tile, tile, widened);
        };
        const BinRange range(grid_.bounds((int) view_, (int) tile), grid_.settings.bins);
        const ExactDepths must = part(kComplete), may = part(kTight);
        if (must.meets) {
            const ExactDepths own = part(0.0);
            for (const int bin : missingBins(range, must, listed)) {
                const bool inTile = own.meets && range.lowest(own.near.value()) <= bin &&
                                    bin <= range.highest(own.far.value());
                lacks(place(tile, (uint32_t) bin, id), inTile);
            }
        }
        int first = 0, last = -1;
        if (may.meets) {
            first = range.lowest(movedBy(floatBelow(may.near), -kDepthUlps));
            last = range.highest(movedBy(floatAbove(may.far), kDepthUlps));
        }
        for (const DumpedEntry& entry : listed) {
            ++found_.compared;
            if (first <= (int) entry.bin && (int) entry.bin <= last)
                ++found_.right;
            else
                isLoose(place(tile, entry.bin, id), may.meets);
        }
    }

    /// Bins that surely hold points of the part \p must and are not \p listed. Where all of it is
    /// within rounding of a border, one of the two bins will do.
    static std::vector<int> missingBins(const BinRange& range, const ExactDepths& must,
                                        Entries listed) {
        const auto has = [&](int from, int to) {
            return std::any_of(listed.begin(), listed.end(), [&](const DumpedEntry& e) {
                return from <= (int) e.bin && (int) e.bin <= to;
            });
        };
        const int first = range.highest(must.near.value()), last = range.lowest(must.far.value());
        std::vector<int> missing;
        for (int bin = first; bin <= last; ++bin)
            if (!has(bin, bin)) missing.push_back(bin);
        if (first > last && !has(last, first)) missing.push_back(first);
        return missing;
    }

    void lacks(const ReplayPlace& at, bool inTile) {
        ++found_.compared;
        found_.fault(inTile ? "incomplete" : "incomplete in the guard band", at, [&] {
            return cellText(input_, at) + " lacks triangle " + std::to_string(*at.primitive) +
                   (inTile ? "" : ", which is there in the guard band alone");
        });
    }

    void isLoose(const ReplayPlace& at, bool meets) {
        found_.fault("loose", at, [&] {
            return cellText(input_, at) + " lists triangle " + std::to_string(*at.primitive) +
                   (meets ? ", which has other depths" : ", which is beside the tile");
        });
    }

    const ReplayInput& input_;
    const Grid& grid_;
    uint32_t view_;
    std::vector<DumpedEntry> entries_;
    std::vector<bool> seen_;
    JudgedPass found_;
};

/// Two edges are parallel: no ray hits it.
bool hasNoArea(const Triangle& t) {
    const int exponent =
        std::min({lowestExponent(t.a), lowestExponent(t.b), lowestExponent(t.c), 0});
    const IntegerVector a = toIntegers(t.a, exponent);
    return cross(toIntegers(t.b, exponent) - a, toIntegers(t.c, exponent) - a).isZero();
}

} // namespace

JudgedPass judgeFillPrimitives(const ReplayInput& input, Executor& executor) {
    JudgedPass pass;
    pass.pass = "FillPrimitives";
    pass.buffer = "lists";
    pass.addPieces(executor, input.grid->views.size(), 1,
                   [&](size_t view, size_t) { return ViewLists(input, (uint32_t) view).judge(); });
    return pass;
}

JudgedPass judgeAtEye(const ReplayInput& input) {
    JudgedPass pass;
    pass.pass = "FillPrimitives";
    pass.buffer = "triangles at the eye";
    std::vector<uint32_t> dumped = *input.manifest.atEye;
    std::sort(dumped.begin(), dumped.end());
    const std::vector<uint32_t> expected = trianglesAtEye(input.geometry);
    std::vector<uint32_t> all, common;
    std::set_union(dumped.begin(), dumped.end(), expected.begin(), expected.end(),
                   std::back_inserter(all));
    std::set_intersection(dumped.begin(), dumped.end(), expected.begin(), expected.end(),
                          std::back_inserter(common));
    pass.compared = all.size();
    for (const uint32_t id : all) {
        if (std::binary_search(common.begin(), common.end(), id) ||
            hasNoArea(input.geometry.triangles[id])) {
            ++pass.right;
            continue;
        }
        ReplayPlace at;
        at.primitive = id;
        const bool isDue = std::binary_search(expected.begin(), expected.end(), id);
        pass.fault(isDue ? "incomplete" : "loose", at, [&] {
            return "at_eye " + std::string(isDue ? "lacks" : "has") + " triangle " +
                   std::to_string(id) + ", which " + (isDue ? "holds" : "does not hold") +
                   " the eye";
        });
    }
    return pass;
}

} // namespace dirt
