#include "core/cost/footprint.h"

#include "core/cost/depth_map.h"
#include "core/grid/geometry.h"
#include "shaders/shared/margins.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dirt {

namespace {

constexpr size_t kGrain = 4096;

/// Of more triangles than this each n-th is summed, which still says the sums to parts in hundreds.
/// All of them make the depth ranges, which would shrink.
constexpr size_t kMeasured = 1 << 18;

/// Triangles as the views see them.
class Eye {
public:
    Eye(const Mesh& mesh, const Camera& camera, const GridSettings& grid)
        : mesh_(mesh), frame_(makeUnscaledFrame(camera, grid.mode)),
          views_(makeViews(grid, camera)) {}

    const std::vector<View>& views() const { return views_; }
    double rimX() const { return views_.front().s.back(); }
    double rimY() const { return views_.front().t.back(); }

    /// Whether a triangle lies where the one before it lies. Thousands may.
    bool repeats(size_t triangle) const {
        if (triangle == 0) return false;
        const Corners &own = mesh_.triangles[triangle], &before = mesh_.triangles[triangle - 1];
        for (int i = 0; i < 3; ++i)
            if (mesh_.positions[own[i]] != mesh_.positions[before[i]]) return false;
        return true;
    }

    /// Calls \p use(view, polygon) for what each view sees of a triangle.
    template <typename Use>
    void look(size_t triangle, const Use& use) const {
        std::array<glm::vec3, 3> corners;
        for (int i = 0; i < 3; ++i)
            corners[i] = frame_.toGrid(mesh_.positions[mesh_.triangles[triangle][i]]);
        for (size_t v = 0; v < views_.size(); ++v) {
            std::array<glm::dvec3, 3> seen;
            for (int i = 0; i < 3; ++i) seen[i] = glm::dvec3(views_[v].toView(corners[i]));
            const SeenPolygon polygon = seenPolygon(seen, rimX(), rimY());
            if (polygon.count > 0) use(v, polygon);
        }
    }

private:
    const Mesh& mesh_;
    GridFrame frame_;
    std::vector<View> views_;
};

} // namespace

Footprint::Footprint(const Mesh& mesh, const Camera& camera, const GridSettings& grid,
                     Executor& executor) {
    GridSettings coarse = grid;
    coarse.tile = 64;
    const Eye eye(mesh, camera, coarse);
    views_ = (int) eye.views().size();
    width_ = eye.views().front().width;
    height_ = eye.views().front().height;
    rimX_ = eye.rimX();
    rimY_ = eye.rimY();

    const size_t views = eye.views().size();
    const size_t stride = mesh.triangles.size() / kMeasured + 1;
    const size_t measured = (mesh.triangles.size() + stride - 1) / stride;
    std::vector<std::vector<DepthMap>> maps(kLevels); // [level][view]
    const int finest = kFewestTiles << (kLevels - 1), longer = std::max(width_, height_);
    const auto across = [&](int pixels) {
        return std::max(1, (int) std::lround((double) finest * pixels / longer));
    };
    for (size_t v = 0; v < views; ++v)
        maps[kLevels - 1].emplace_back(across(width_), across(height_), rimX_, rimY_);
    executor.forRange(mesh.triangles.size(), kGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i)
            if (i == begin || !eye.repeats(i))
                eye.look(i, [&](size_t view, const SeenPolygon& polygon) {
                    maps[kLevels - 1][view].include(polygon);
                });
    });
    for (int level = kLevels - 2; level >= 0; --level)
        for (size_t v = 0; v < views; ++v) maps[level].push_back(maps[level + 1][v].coarser());

    // A sum for each piece, and the pieces in their order: the same bits for any thread count.
    std::vector<Sums> pieces((measured + kGrain - 1) / kGrain);
    const auto measure = [&](size_t triangle, Sums& sum) {
        eye.look(triangle, [&](size_t view, const SeenPolygon& polygon) {
            const glm::dvec3 extent = polygon.high() - polygon.low();
            sum.polygons += 1.0;
            sum.area += polygon.area(0, 1);
            sum.extentX += extent.x;
            sum.extentY += extent.y;
            for (int level = 0; level < kLevels; ++level)
                sum.depth[level].add(polygon, maps[level][view]);
        });
    };
    executor.forRange(measured, kGrain, [&](size_t begin, size_t end) {
        Sums& sum = pieces[begin / kGrain];
        std::optional<Sums> repeated; // of the triangles at hand, which all lie in one place
        for (size_t i = begin; i < end; ++i) {
            if (stride > 1 || !eye.repeats(i)) {
                repeated.reset();
                measure(i * stride, sum);
                continue;
            }
            if (!repeated) measure(i, repeated.emplace());
            sum.add(*repeated, 1.0);
        }
    });
    for (const Sums& piece : pieces) sums_.add(piece, (double) stride);
}

void Footprint::DepthSums::add(const SeenPolygon& polygon, const DepthMap& map) {
    if (map.spansTiles(polygon)) {
        crossed += map.rangesCrossed(polygon);
        return;
    }
    const double inverse = map.inverseLength(polygon);
    extent += (polygon.high().z - polygon.low().z) * inverse;
    alongX += polygon.area(0, 2) * inverse;
    alongY += polygon.area(1, 2) * inverse;
}

void Footprint::Sums::add(const Sums& other, double times) {
    polygons += times * other.polygons;
    area += times * other.area;
    extentX += times * other.extentX;
    extentY += times * other.extentY;
    for (int level = 0; level < kLevels; ++level) {
        depth[level].crossed += times * other.depth[level].crossed;
        depth[level].extent += times * other.depth[level].extent;
        depth[level].alongX += times * other.depth[level].alongX;
        depth[level].alongY += times * other.depth[level].alongY;
    }
}

double Footprint::tiles(const GridSettings& grid) const {
    return (double) views_ * ((width_ + grid.tile - 1) / grid.tile) *
           ((height_ + grid.tile - 1) / grid.tile);
}

double Footprint::tilesAcross(const GridSettings& grid) const {
    return (double) std::max(width_, height_) / grid.tile;
}

double Footprint::listEntries(const GridSettings& grid) const {
    const double tileX = 2.0 * rimX_ * grid.tile / width_;
    const double tileY = 2.0 * rimY_ * grid.tile / height_;
    // Tiles list what lies in their guard bands too: a polygon is swept by that much more.
    const double wide = grid.precision == Precision::exact ? 1.0 + 2.0 * kGuardBand : 1.0;
    const double tiles = sums_.area / (tileX * tileY) +
                         wide * (sums_.extentX / tileX + sums_.extentY / tileY) +
                         wide * wide * sums_.polygons;
    // A range of depths has bins - 1 borders inside, which is what a triangle may cross.
    const auto crossings = [&](const DepthSums& depth) {
        return depth.crossed + wide * (depth.alongX / tileX + depth.alongY / tileY) +
               wide * wide * depth.extent;
    };
    const double level =
        std::clamp(std::log2(tilesAcross(grid) / kFewestTiles), 0.0, kLevels - 1.0);
    const int below = std::min((int) level, kLevels - 2);
    const double part = level - below;
    return tiles + (grid.bins - 1) * ((1.0 - part) * crossings(sums_.depth[below]) +
                                      part * crossings(sums_.depth[below + 1]));
}

} // namespace dirt
