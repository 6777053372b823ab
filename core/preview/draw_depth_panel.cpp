#include "core/preview/ray_colours.h"
#include "core/preview/ray_panels.h"

#include "core/explain/clip_polygon.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>

namespace dirt {

namespace {

// Pixels: for the numbers at the axis, below the columns, and of the columns.
constexpr int kAxis = 100, kFoot = 50, kPassedColumn = 14, kTileColumn = 44, kTestColumn = 6;
constexpr int kWidestColumn = 220, kColumns = 760;
constexpr int kTicks = 5;

/// What became of the triangles of a tile: of several bins' tests that which says most.
std::vector<TriangleTrail> trianglesOf(const TileTrail& tile) {
    std::vector<TriangleTrail> triangles;
    std::map<uint32_t, size_t> places;
    for (const BinTrail& bin : tile.bins)
        for (const TriangleTrail& tested : bin.triangles) {
            const auto [place, isNew] = places.try_emplace(tested.id, triangles.size());
            if (isNew)
                triangles.push_back(tested);
            else if (tested.result > triangles[place->second].result)
                triangles[place->second] = tested;
        }
    return triangles;
}

/// A column: a tile that is visited, or a cell that is passed over although it lists something.
struct Step {
    const CellLook* cell;  ///< null: a tile
    const TileTrail* tile; ///< null: a cell
    int number = 0;        ///< of the tile in the order of visits
    std::vector<TriangleTrail> triangles = {};

    const DepthBounds& bounds() const { return tile ? tile->bounds : cell->bounds; }
};

/// In the ray's order. A tile follows the cell of level 0 that is it.
std::vector<Step> stepsOf(const ViewTrail& trail) {
    std::vector<Step> steps;
    size_t tile = 0;
    for (const CellLook& cell : trail.cells) {
        if (cell.passedOver && !cell.bounds.empty()) steps.push_back({&cell, nullptr});
        if (cell.passedOver || cell.level > 0 || tile == trail.tiles.size()) continue;
        const TileTrail& next = trail.tiles[tile];
        if (next.column == cell.column && next.row == cell.row)
            steps.push_back({nullptr, &next, (int) ++tile, trianglesOf(next)});
    }
    return steps;
}

int wishOf(const Step& step) {
    if (step.cell) return kPassedColumn;
    const size_t most = (kWidestColumn - kTileColumn) / kTestColumn;
    return kTileColumn + kTestColumn * (int) std::min(step.triangles.size(), most);
}

std::string numberText(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

class DepthPanel {
public:
    DepthPanel(Canvas canvas, const DrawnRay& ray, const ViewTrail& trail, Box box)
        : canvas_(canvas.within(box)), ray_(ray), view_(ray.grid.views[(size_t) trail.span.view]),
          viewIndex_(trail.span.view), steps_(stepsOf(trail)),
          box_(box), plot_{box.left + kAxis, box.top + textHeight(), box.width - kAxis - 2,
                           box.height - kFoot - textHeight()} {
        originDepth_ = (double) (view_.signW * ray.trail.ray.origin[view_.axisW]);
        depthPerT_ = (double) (view_.signW * ray.trail.ray.direction[view_.axisW]);
        findRange();
    }

    void draw() {
        drawAxis();
        int wish = 0;
        for (const Step& step : steps_) wish += wishOf(step);
        const double scale = (double) plot_.width / wish;
        double x = plot_.left;
        for (const Step& step : steps_) {
            const double width = wishOf(step) * scale;
            const Box column{(int) x, plot_.top, std::max((int) (x + width) - (int) x, 1),
                             plot_.height};
            if (step.cell)
                drawCell(*step.cell, column);
            else
                drawTile(step, column);
            x += width;
        }
        drawParameters();
    }

private:
    double depthAt(double t) const { return originDepth_ + t * depthPerT_; }

    /// The parameter at which a tile that the ray never leaves is left for the drawing: where the
    /// ray has passed all that the tile lists.
    double endOf(const TileTrail& tile) const {
        if (std::isfinite(tile.visit.end)) return tile.visit.end;
        double end = tile.visit.begin;
        if (depthPerT_ != 0.0) end = ((double) tile.bounds.far - originDepth_) / depthPerT_;
        if (std::isfinite(ray_.end())) end = std::max(end, ray_.end() * 1.1);
        return std::max(end, tile.visit.begin * 1.1);
    }

    void findRange() {
        low_ = INFINITY, high_ = -INFINITY;
        for (const Step& step : steps_) {
            low_ = std::min(low_, (double) step.bounds().near);
            high_ = std::max(high_, (double) step.bounds().far);
        }
        // The ray passes in front of, or behind what it passes over: as far as it is not far away.
        const double least = 0.8 * low_, most = 1.25 * high_;
        for (const Step& step : steps_) {
            const double near = step.tile ? (double) step.tile->visit.near : step.cell->near;
            const double far = step.tile ? (double) step.tile->visit.far : step.cell->far;
            low_ = std::min(low_, std::max(near, least));
            high_ = std::max(high_, std::min(far, most));
        }
        if (!(low_ < high_)) high_ = low_ > 0.0 ? 2.0 * low_ : 1.0;
    }

    /// What lies near takes more of a view's bins and rays than what is far away: the axis is
    /// logarithmic, unless it begins at the eye.
    double heightOf(double depth) const { return low_ > 0.0 ? std::log(depth) : depth; }
    double y(double depth) const {
        const double low = heightOf(low_), high = heightOf(high_);
        const double part = (heightOf(std::max(depth, 0.5 * low_)) - low) / (high - low);
        return plot_.bottom() - 1 - part * (plot_.height - 1);
    }
    double depthOfPart(double part) const {
        return low_ > 0.0 ? low_ * std::pow(high_ / low_, part) : low_ + (high_ - low_) * part;
    }

    /// The pixels between two depths, at least \p least.
    Box band(int left, int width, double near, double far, int least) const {
        const int top = (int) std::floor(y(far)), bottom = (int) std::ceil(y(near));
        const int height = std::max(bottom - top, least);
        return {left, std::min(top, plot_.bottom() - height), width, height};
    }

    void drawAxis() {
        canvas_.text(plot_.left, box_.top, low_ > 0.0 ? "depth, logarithmic" : "depth",
                     kFaintWords);
        for (int i = 0; i < kTicks; ++i) {
            const double depth = depthOfPart((double) i / (kTicks - 1));
            const std::string text = numberText(depth);
            const int line = (int) y(depth);
            canvas_.fill({plot_.left, line, plot_.width, 1}, kFilledTile);
            const int top = std::clamp(line - 7, plot_.top, plot_.bottom() - 16);
            canvas_.text(plot_.left - 8 - textWidth(text), top, text, kFaintWords);
        }
    }

    void drawCell(const CellLook& cell, Box column) {
        const Box bar = band(column.left + 1, std::max(column.width - 2, 1),
                             (double) cell.bounds.near, (double) cell.bounds.far, 3);
        canvas_.fill(bar, kPassedOver);
        canvas_.frame(bar, kPassedOverRim);
        const bool rises = depthPerT_ >= 0.0;
        Canvas inside = canvas_.within(plot_); // it may be nearer than what is shown
        inside.line({column.left, y(rises ? cell.near : cell.far)},
                    {column.right(), y(rises ? cell.far : cell.near)}, kRayLine, 2);
    }

    void drawBins(const TileTrail& tile, Box column) {
        const int bins = ray_.grid.settings.bins;
        const BinMap map(tile.bounds, bins);
        const int left = column.left + 1, width = std::max(column.width - 2, 1);
        const Box all = band(left, width, (double) tile.bounds.near, (double) tile.bounds.far, 3);
        canvas_.fill(all, kEmptyTile);
        canvas_.frame(all, kFaintWords);
        for (int b = 0; b < bins; ++b) {
            // All depths of a tile without depth are in the first bin.
            if (!(map.scale > 0.0f) && b > 0) break;
            const double size = map.scale > 0.0f ? 1.0 / (double) map.scale : 0.0;
            const double near = (double) map.near + b * size;
            const Box bar = band(left, width, near, near + size, 1);
            const bool visited = std::any_of(tile.bins.begin(), tile.bins.end(),
                                             [&](const BinTrail& bin) { return bin.bin == b; });
            const auto list = ray_.grid.list(viewIndex_, tile.visit.tile, b);
            if (!list.empty()) canvas_.fill(bar, visited ? kVisited : kFilledTile);
            if (bar.height >= 4) canvas_.fill({bar.left, bar.top, bar.width, 1}, kBackground);
            if (visited) canvas_.frame(bar, kVisitedRim);
        }
    }

    /// \p missed: those that were, or the others, which are to be seen above them.
    void drawTriangles(const Step& step, Box column, bool missed) {
        const TileTrail& tile = *step.tile;
        const double gap = (double) column.width / ((double) step.triangles.size() + 1.0);
        for (size_t i = 0; i < step.triangles.size(); ++i) {
            const TriangleTrail& tested = step.triangles[i];
            if ((tested.result == Tested::missed) != missed) continue;
            ViewTriangle setup;
            DepthInterval depths{tile.bounds.near, tile.bounds.far};
            if (setUpTriangle(ray_.geometry.triangles[tested.id], view_, setup))
                clipToTile(setup, view_, tile.column, tile.row, depths);
            const int x = column.left + (int) (gap * (double) (i + 1));
            const int width = missed && gap < 5.0 ? 1 : 3;
            canvas_.fill(band(x, width, (double) depths.near, (double) depths.far, 3),
                         colourOf(tested.result));
        }
    }

    void drawTile(const Step& step, Box column) {
        const TileTrail& tile = *step.tile;
        drawBins(tile, column);
        drawTriangles(step, column, true);
        drawTriangles(step, column, false);
        const double begin = tile.visit.begin, end = endOf(tile), last = ray_.end();
        const auto at = [&](double t) {
            const double part = end > begin ? (t - begin) / (end - begin) : 0.0;
            return glm::dvec2(column.left + part * column.width, y(depthAt(t)));
        };
        Canvas inside = canvas_.within({column.left, plot_.top, column.width, plot_.height});
        // In pieces, as the axis bends the line.
        const auto draw = [&](double from, double to, Colour colour) {
            constexpr int kPieces = 32;
            for (int i = 0; i < kPieces; ++i)
                inside.line(at(from + (to - from) * i / kPieces),
                            at(from + (to - from) * (i + 1) / kPieces), colour, 2);
        };
        if (last < end) draw(std::max(begin, last), end, kRayBeyond);
        if (last >= begin) draw(begin, std::min(end, last), kRayLine);
        for (const TriangleTrail& tested : step.triangles)
            if (tested.result != Tested::missed && (double) tested.hit.t >= begin &&
                (double) tested.hit.t <= end)
                inside.ring(at((double) tested.hit.t), 4, colourOf(tested.result));
        if (ray_.hits() && last >= begin && last <= end) inside.cross(at(last), 7, kHitMark, 3);
        label(step, column);
    }

    void label(const Step& step, Box column) {
        const std::string number = std::to_string(step.number);
        const std::string place =
            "(" + std::to_string(step.tile->column) + "," + std::to_string(step.tile->row) + ")";
        for (const auto& [text, top] : {std::pair(number, 4), std::pair(place, 16)})
            if (textWidth(text, 1) <= column.width)
                canvas_.text(column.left + (column.width - textWidth(text, 1)) / 2,
                             plot_.bottom() + top, text, kFaintWords, 1);
    }

    /// The parameters at which the first tile is entered and the last one left.
    void drawParameters() {
        const auto isTile = [](const Step& step) { return step.tile != nullptr; };
        const auto first = std::find_if(steps_.begin(), steps_.end(), isTile);
        const auto last = std::find_if(steps_.rbegin(), steps_.rend(), isTile);
        if (first == steps_.end()) return;
        const std::string text = "t " + numberText(first->tile->visit.begin) + " to " +
                                 numberText(last->tile->visit.end);
        canvas_.text(plot_.left, plot_.bottom() + 30, text, kFaintWords);
    }

    Canvas canvas_;
    const DrawnRay& ray_;
    const View& view_;
    int viewIndex_;
    std::vector<Step> steps_;
    Box box_, plot_;
    double originDepth_, depthPerT_;
    double low_ = 0.0, high_ = 1.0; ///< of the axis
};

} // namespace

int depthPanelWidth(const ViewTrail& trail) {
    if (trail.tiles.empty()) return 0;
    int columns = 0;
    for (const Step& step : stepsOf(trail)) columns += wishOf(step);
    return kAxis + std::clamp(columns, 440, kColumns) + 2;
}

void drawDepthPanel(Canvas canvas, const DrawnRay& ray, const ViewTrail& trail, Box box) {
    DepthPanel(canvas, ray, trail, box).draw();
}

} // namespace dirt
