#pragma once

#include "core/check/check_row.h"
#include "core/frame/path_buffers.h"
#include "core/grid/geometry.h"

#include <functional>
#include <string>

namespace dirt {

/// The buffers of PathBuffers.
enum class PathBuffer { previous, current, next, mask, rays, hits, visibility, radiance, image };

/// As reports call it.
std::string nameOf(PathBuffer buffer);

/// What two backends may have different.
struct PathTolerance {
    /// Where false, results of float arithmetic may be off as PathComparison says.
    bool isIeee = true;
    /// Whether the hits of both are listed in tiles.
    bool tiles = true;
    /// Whether \p pixel may see either primitive; asked in direct visibility alone.
    std::function<bool(size_t pixel, uint32_t a, uint32_t b)> mayConfuse;
};

/// Compares buffers record by record. All fields must be equal to the bit, but for the signs of
/// zeros. Without IEEE arithmetic,
///   - t by err(t) (T7), of the same primitive or of another that the ray hits as well;
///   - barycentric weights by 2^-21, twice their error (intersect.h);
///   - vectors of the grid frame, where coordinates and directions are about 1, by 1e-5;
///   - densities, throughputs, colours and radiance by 1e-5 of their value:
/// 1e-5 are 84 ulp, and no record is made in more than some 30 operations of 2.5 ulp at most, all
/// of equal rays or surface points. Integers are equal always.
class PathComparison {
public:
    /// \p geometry must outlive the comparison. \p width is the image's.
    PathComparison(const FrameGeometry& geometry, int width, PathTolerance tolerance);

    void compare(PathBuffer buffer, const PathBuffers& expected, const PathBuffers& found,
                 CheckRow& row) const;
    /// PathBuffers::next, as DirectVisibility has found it.
    void compareDirectVisibility(const PathBuffers& expected, const PathBuffers& found,
                                 CheckRow& row) const;

private:
    void compareHits(const PathBuffers& expected, const PathBuffers& found, CheckRow& row) const;
    bool areTied(const PathRay& ray, const Hit& a, const Hit& b) const;

    const FrameGeometry& geometry_;
    int width_;
    PathTolerance tolerance_;
};

} // namespace dirt
