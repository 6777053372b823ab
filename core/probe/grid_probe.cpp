#include "core/probe/grid_probe.h"

#include "core/base/error.h"
#include "core/trace/traverse.h"

#include <algorithm>
#include <ostream>
#include <stdexcept>

namespace dirt {

namespace {

Mesh meshOf(const std::vector<WorldTriangle>& triangles) {
    if (triangles.empty()) throw InputError("there are no triangles");
    Mesh mesh;
    for (const WorldTriangle& t : triangles) {
        const uint32_t first = (uint32_t) mesh.positions.size();
        mesh.positions.insert(mesh.positions.end(), {t.a, t.b, t.c});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

/// Indices i of closed slices [borders[i] w, borders[i + 1] w] that hold x. Products of floats are
/// exact in double.
std::vector<int> slicesAt(const std::vector<float>& borders, float x, float w) {
    std::vector<int> slices;
    for (size_t i = 0; i + 1 < borders.size(); ++i)
        if ((double) borders[i] * w <= x && x <= (double) borders[i + 1] * w)
            slices.push_back((int) i);
    return slices;
}

} // namespace

std::ostream& operator<<(std::ostream& out, const Tile& tile) {
    return out << "view " << tile.view << ", tile (" << tile.column << ", " << tile.row << ")";
}

std::ostream& operator<<(std::ostream& out, const Cell& cell) {
    return out << cell.tile() << ", bin " << cell.bin;
}

GridProbe::GridProbe(const std::vector<WorldTriangle>& triangles, const Camera& camera,
                     const GridSettings& settings)
    : geometry_(makeFrameGeometry(meshOf(triangles), camera, settings.mode)),
      grid_(buildGrid(geometry_, camera, settings)) {}

GridProbe::GridProbe(FrameGeometry geometry, Grid grid)
    : geometry_(std::move(geometry)), grid_(std::move(grid)) {}

std::vector<Tile> GridProbe::tilesOfGridPoint(glm::vec3 point) const {
    std::vector<Tile> tiles;
    for (size_t v = 0; v < grid_.views.size(); ++v) {
        const View& view = grid_.views[v];
        const glm::vec3 p = view.toView(point);
        if (!(p.z > 0.0f)) continue;
        const std::vector<int> columns = slicesAt(view.s, p.x, p.z);
        for (int row : slicesAt(view.t, p.y, p.z))
            for (int column : columns) tiles.push_back({(int) v, column, row});
    }
    return tiles;
}

std::vector<Tile> GridProbe::tilesAt(glm::vec3 point) const {
    return tilesOfGridPoint(geometry_.frame.toGrid(point));
}

std::vector<Tile> GridProbe::tilesAlong(glm::vec3 direction) const {
    return tilesOfGridPoint(geometry_.frame.directionToGrid(direction));
}

std::vector<int> GridProbe::binsBetween(const Tile& tile, float near, float far) const {
    const DepthBounds& bounds = grid_.bounds(tile.view, indexOf(tile));
    near *= geometry_.frame.scale;
    far *= geometry_.frame.scale;
    std::vector<int> bins;
    if (bounds.empty() || far < bounds.near || near > bounds.far) return bins;
    const BinMap bin(bounds, grid_.settings.bins);
    for (int b = bin(near); b <= bin(far); ++b) bins.push_back(b);
    return bins;
}

std::vector<Cell> GridProbe::cellsAt(glm::vec3 point) const {
    std::vector<Cell> cells;
    for (const Tile& tile : tilesAt(point)) {
        const glm::vec3 p = grid_.views[tile.view].toView(geometry_.frame.toGrid(point));
        const float depth = p.z / geometry_.frame.scale;
        for (int bin : binsBetween(tile, depth, depth))
            cells.push_back({tile.view, tile.column, tile.row, bin});
    }
    return cells;
}

WorldDepths GridProbe::depths(const Tile& tile) const {
    const DepthBounds& bounds = grid_.bounds(tile.view, indexOf(tile));
    if (bounds.empty()) return {};
    return {bounds.near / geometry_.frame.scale, bounds.far / geometry_.frame.scale};
}

Ids GridProbe::ids(const Cell& cell) const {
    const int tile = indexOf(cell.tile());
    if (cell.bin < 0 || cell.bin >= grid_.settings.bins)
        throw std::out_of_range("there is no bin " + std::to_string(cell.bin) + " of " +
                                std::to_string(grid_.settings.bins));
    const auto list = grid_.list(cell.view, tile, cell.bin);
    Ids ids(list.begin(), list.end());
    std::sort(ids.begin(), ids.end()); // a GPU's lists come in any order
    return ids;
}

Ids GridProbe::ids(const Tile& tile) const {
    Ids all;
    for (int bin = 0; bin < grid_.settings.bins; ++bin) {
        const Ids some = ids(Cell{tile.view, tile.column, tile.row, bin});
        all.insert(all.end(), some.begin(), some.end());
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

void GridProbe::checkId(uint32_t id) const {
    if (id >= geometry_.triangles.size())
        throw std::out_of_range("there is no triangle " + std::to_string(id) + " of " +
                                std::to_string(geometry_.triangles.size()));
}

std::vector<Cell> GridProbe::cellsOf(uint32_t id) const {
    checkId(id);
    std::vector<Cell> cells;
    for (size_t v = 0; v < grid_.views.size(); ++v)
        for (int tile = 0; tile < grid_.views[v].tiles(); ++tile)
            for (int bin = 0; bin < grid_.settings.bins; ++bin) {
                const auto list = grid_.list((int) v, tile, bin);
                if (std::find(list.begin(), list.end(), id) != list.end())
                    cells.push_back(cellOf((int) v, tile, bin));
            }
    std::sort(cells.begin(), cells.end());
    return cells;
}

Ray GridProbe::gridRay(glm::vec3 origin, glm::vec3 direction, uint32_t skip) const {
    if (skip != kNoPrimitive) checkId(skip);
    const GridFrame& frame = geometry_.frame;
    return {frame.toGrid(origin), frame.directionToGrid(direction) * frame.scale, skip};
}

std::vector<Cell> GridProbe::visited(glm::vec3 origin, glm::vec3 direction) const {
    std::vector<Cell> cells;
    visitCells(grid_, gridRay(origin, direction),
               [&](int view, int tile, int bin) { cells.push_back(cellOf(view, tile, bin)); });
    return cells;
}

Hit GridProbe::hit(glm::vec3 origin, glm::vec3 direction, uint32_t skip, float tMax) const {
    const Hit nearest = closestHit(grid_, geometry_, gridRay(origin, direction, skip));
    return nearest.t < tMax ? nearest : Hit();
}

int GridProbe::indexOf(const Tile& tile) const {
    if (tile.view < 0 || tile.view >= (int) grid_.views.size())
        throw std::out_of_range("there is no view " + std::to_string(tile.view) + " of " +
                                std::to_string(grid_.views.size()));
    const View& view = grid_.views[tile.view];
    if (tile.column < 0 || tile.column >= view.columns || tile.row < 0 || tile.row >= view.rows)
        throw std::out_of_range("there is no tile (" + std::to_string(tile.column) + ", " +
                                std::to_string(tile.row) + ") among " +
                                std::to_string(view.columns) + "x" + std::to_string(view.rows));
    return tile.row * view.columns + tile.column;
}

Cell GridProbe::cellOf(int view, int tile, int bin) const {
    const int columns = grid_.views[view].columns;
    return {view, tile % columns, tile / columns, bin};
}

} // namespace dirt
