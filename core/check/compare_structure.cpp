#include "core/check/compare_structure.h"

#include "core/grid/clip.h"
#include "core/trace/intersect.h"
#include "shaders/shared/margins.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>

namespace dirt {
namespace {

std::string hex(float x) {
    char text[40];
    std::snprintf(text, sizeof text, "%a", x);
    return text;
}

/// Floats in between, and one; none if they are equal. Both have the same sign, or one is zero.
int64_t distance(float a, float b) {
    const auto place = [](float x) {
        const int64_t bits = std::bit_cast<int32_t>(std::fabs(x));
        return x < 0.0f ? -bits : bits;
    };
    return std::abs(place(a) - place(b));
}

std::string tileName(const View& view, size_t viewIndex, size_t tile) {
    const size_t columns = (size_t) view.columns;
    return "view " + std::to_string(viewIndex) + ", column " + std::to_string(tile % columns) +
           ", row " + std::to_string(tile / columns);
}

/// \p x moved by \p ulps floats.
float moved(float x, int ulps) {
    for (; ulps > 0; --ulps) x = std::nextafter(x, HUGE_VALF);
    for (; ulps < 0; ++ulps) x = std::nextafter(x, -HUGE_VALF);
    return x;
}

/// Judges list entries that only one side has.
class ListTolerance {
public:
    ListTolerance(const FrameGeometry& geometry, const Grid& grid, int ulps)
        : geometry_(geometry), grid_(grid), ulps_(ulps) {}

    /// Whether it takes no more than ulps_ in the triangle's depths to enter or to leave the bin.
    bool allows(size_t view, size_t tile, int bin, uint32_t id) const {
        if (ulps_ == 0 || id >= geometry_.triangles.size()) return false;
        const View& v = grid_.views[view];
        const int column = (int) tile % v.columns, row = (int) tile / v.columns;
        ViewTriangle triangle;
        DepthInterval depths;
        if (!setUpTriangle(geometry_.triangles[id], v, triangle) ||
            !overlaps(triangle, v, column, row) || !clipToTile(triangle, v, column, row, depths))
            return false;
        const BinMap map(grid_.bounds((int) view, (int) tile), grid_.settings.bins);
        const auto spans = [&](int widen) {
            return map(moved(depths.near, -widen)) <= bin && bin <= map(moved(depths.far, widen));
        };
        return spans(ulps_) && !spans(-ulps_);
    }

private:
    const FrameGeometry& geometry_;
    const Grid& grid_;
    int ulps_;
};

} // namespace

void compareTriangles(const FrameGeometry& source, const FrameGeometry& tested, CheckRow& row) {
    const auto &a = source.triangles, &b = tested.triangles;
    row.compared = std::max(a.size(), b.size()) * 9;
    if (a.size() != b.size())
        row.differ({}, [&] {
            return std::to_string(a.size()) + " and " + std::to_string(b.size()) + " triangles";
        });
    for (size_t id = 0; id < std::min(a.size(), b.size()); ++id) {
        const glm::vec3 *p = &a[id].a, *q = &b[id].a;
        for (int i = 0; i < 9; ++i) {
            const float x = p[i / 3][i % 3], y = q[i / 3][i % 3];
            if (x == y)
                ++row.equal;
            else
                row.differ(Place::ofPrimitive((uint32_t) id), [&] {
                    return "triangle " + std::to_string(id) + ", vertex " + std::to_string(i / 3) +
                           ", " + "xyz"[i % 3] + ": " + hex(x) + ", not " + hex(y);
                });
        }
    }
}

void compareLevel(const Grid& source, const Grid& tested, size_t level, int ulps, CheckRow& row) {
    for (size_t view = 0; view < source.pyramids.size(); ++view) {
        const DepthPyramid::Level& a = source.pyramids[view].levels[level];
        for (int y = 0; y < a.rows; ++y)
            for (int x = 0; x < a.columns; ++x) {
                const DepthBounds& expected = a.at(x, y);
                const DepthBounds& found = tested.pyramids[view].levels[level].at(x, y);
                const int64_t off = std::max(distance(expected.near, found.near),
                                             distance(expected.far, found.far));
                ++row.compared;
                if (off == 0)
                    ++row.equal;
                else if (off <= ulps)
                    ++row.withinTolerance;
                else
                    row.differ(Place::ofTile((int) view, x << level, y << level), [&] {
                        return "view " + std::to_string(view) + ", column " + std::to_string(x) +
                               ", row " + std::to_string(y) + ": " + hex(expected.near) + " to " +
                               hex(expected.far) + ", not " + hex(found.near) + " to " +
                               hex(found.far);
                    });
            }
    }
}

void compareLists(const FrameGeometry& geometry, const Grid& source, const Grid& tested, int ulps,
                  CheckRow& row) {
    const ListTolerance tolerance(geometry, source, ulps);
    for (size_t view = 0; view < source.views.size(); ++view)
        for (size_t tile = 0; tile < (size_t) source.views[view].tiles(); ++tile) {
            const int columns = source.views[view].columns;
            const Place place =
                Place::ofTile((int) view, (int) tile % columns, (int) tile / columns);
            for (int bin = 0; bin < source.settings.bins; ++bin) {
                // Rounding moves an entry, and makes no second one.
                const auto one = [&](uint32_t id, const char* what, bool isRepeated) {
                    ++row.compared;
                    if (!isRepeated && tolerance.allows(view, tile, bin, id))
                        ++row.withinTolerance;
                    else
                        row.differ(place, [&] {
                            return tileName(source.views[view], view, tile) + ", bin " +
                                   std::to_string(bin) + ": " + what + " triangle " +
                                   std::to_string(id);
                        });
                };
                const auto a = source.list((int) view, (int) tile, bin);
                const auto b = tested.list((int) view, (int) tile, bin);
                size_t i = 0, j = 0;
                while (i < a.size() || j < b.size()) {
                    if (j == b.size() || (i < a.size() && a[i] < b[j])) {
                        one(a[i], "lacks", i > 0 && a[i] == a[i - 1]);
                        ++i;
                    } else if (i == a.size() || b[j] < a[i]) {
                        one(b[j], "has in addition", j > 0 && b[j] == b[j - 1]);
                        ++j;
                    } else {
                        ++row.compared;
                        ++row.equal;
                        ++i;
                        ++j;
                    }
                }
            }
        }
}

void compareAtEye(const Grid& source, const Grid& tested, CheckRow& row) {
    std::vector<uint32_t> common, different;
    const auto &a = source.atEye, &b = tested.atEye;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(),
                                  std::back_inserter(different));
    row.equal = common.size();
    row.compared = common.size() + different.size();
    for (uint32_t id : different)
        row.differ(Place::ofPrimitive(id),
                   [&] { return "only one lists triangle " + std::to_string(id); });
}

void compareShadowMaps(const std::vector<float>& source, const std::vector<float>& tested,
                       size_t resolution, bool isIeee, CheckRow& row) {
    row.compared = std::max(source.size(), tested.size());
    for (size_t i = 0; i < row.compared; ++i) {
        const bool both = i < source.size() && i < tested.size();
        if (both && source[i] == tested[i])
            ++row.equal;
        else if (both && !isIeee &&
                 std::fabs(source[i] - tested[i]) <=
                     kRelativeErrorT * std::max(source[i], tested[i]))
            ++row.withinTolerance;
        else
            row.differ(Place::ofTexel((int) (i % resolution), (int) (i / resolution)), [&] {
                const std::string texel = "texel " + std::to_string(i % resolution) + "," +
                                          std::to_string(i / resolution) + ": ";
                return both ? texel + hex(source[i]) + ", not " + hex(tested[i])
                            : texel + "in one of the two alone";
            });
    }
}

} // namespace dirt
