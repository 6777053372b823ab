#include "core/grid/grid.h"

#include "core/base/denormals.h"
#include "core/base/error.h"
#include "core/base/exact_sum.h"
#include "core/grid/scan.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace dirt {

bool holdsEye(const Triangle& t) {
    for (int i = 0; i < 3; ++i) {
        if (t.a[i] > 0.0f && t.b[i] > 0.0f && t.c[i] > 0.0f) return false;
        if (t.a[i] < 0.0f && t.b[i] < 0.0f && t.c[i] < 0.0f) return false;
    }
    if (tripleProductExact(t.a, t.b, t.c) != 0.0) return false;
    // In the plane of the eye the edge normals are parallel; around the eye they point to the same
    // side. Their components have one rounding each, so signs are exact.
    const glm::dvec3 a(t.a), b(t.b), c(t.c);
    const glm::dvec3 ab = glm::cross(a, b), bc = glm::cross(b, c), ca = glm::cross(c, a);
    for (int i = 0; i < 3; ++i) {
        const bool positive = ab[i] > 0.0 || bc[i] > 0.0 || ca[i] > 0.0;
        const bool negative = ab[i] < 0.0 || bc[i] < 0.0 || ca[i] < 0.0;
        if (positive && negative) return false;
    }
    return true;
}

std::vector<uint32_t> trianglesAtEye(const FrameGeometry& geometry) {
    std::vector<uint32_t> ids;
    for (uint32_t id = 0; id < geometry.triangles.size(); ++id)
        if (holdsEye(geometry.triangles[id])) ids.push_back(id);
    return ids;
}

void buildPyramid(DepthPyramid& pyramid) {
    pyramid.levels.resize(1);
    while (pyramid.levels.back().columns > 1 || pyramid.levels.back().rows > 1) {
        const DepthPyramid::Level& below = pyramid.levels.back();
        DepthPyramid::Level level;
        level.columns = (below.columns + 1) / 2;
        level.rows = (below.rows + 1) / 2;
        level.bounds.resize((size_t) level.columns * level.rows);
        for (int row = 0; row < below.rows; ++row)
            for (int column = 0; column < below.columns; ++column) {
                const DepthBounds& child = below.at(column, row);
                level.bounds[(size_t) (row / 2) * level.columns + column / 2].include(child.near,
                                                                                      child.far);
            }
        pyramid.levels.push_back(std::move(level));
    }
}

Grid makeEmptyGrid(const Camera& camera, const GridSettings& settings) {
    Grid grid;
    grid.settings = settings;
    grid.views = makeViews(settings, camera);
    grid.pyramids.resize(grid.views.size());
    uint64_t tiles = 0;
    for (size_t v = 0; v < grid.views.size(); ++v) {
        const View& view = grid.views[v];
        grid.firstTile.push_back((uint32_t) tiles);
        tiles += view.tiles();
        DepthPyramid::Level level{view.columns, view.rows, {}};
        level.bounds.resize(view.tiles());
        grid.pyramids[v].levels.push_back(std::move(level));
    }
    grid.firstTile.push_back((uint32_t) tiles);
    if (tiles * settings.bins > kMaxCells)
        throw InputError(std::to_string(tiles) + " tiles of " + std::to_string(settings.bins) +
                         " bins are more than " + std::to_string(kMaxCells) +
                         " cells; take a larger tile or fewer bins");
    return grid;
}

Grid buildGrid(const FrameGeometry& geometry, const Camera& camera, const GridSettings& settings) {
    const FlushDenormals flush;
    Grid grid = makeEmptyGrid(camera, settings);

    // FillDepth
    for (const Triangle& triangle : geometry.triangles)
        for (size_t v = 0; v < grid.views.size(); ++v)
            scanTriangle(triangle, grid.views[v], [&](int tile, DepthInterval depths) {
                grid.pyramids[v].levels[0].bounds[tile].include(depths.near, depths.far);
            });

    // FillDepthMipmap
    for (DepthPyramid& pyramid : grid.pyramids) buildPyramid(pyramid);

    grid.atEye = trianglesAtEye(geometry);

    // FillPrimitives: count, then fill; ids come in order, so every list is sorted.
    const auto forEachEntry = [&](auto&& visit) {
        for (uint32_t id = 0; id < geometry.triangles.size(); ++id)
            for (size_t v = 0; v < grid.views.size(); ++v)
                scanTriangle(geometry.triangles[id], grid.views[v],
                             [&](int tile, DepthInterval depths) {
                                 const BinMap bin(grid.bounds((int) v, tile), settings.bins);
                                 for (int b = bin(depths.near); b <= bin(depths.far); ++b)
                                     visit(grid.cell((int) v, tile, b), id);
                             });
    };
    std::vector<uint64_t> counts((size_t) grid.firstTile.back() * settings.bins + 1);
    forEachEntry([&](size_t cell, uint32_t) { ++counts[cell + 1]; });
    for (size_t c = 1; c < counts.size(); ++c) counts[c] += counts[c - 1];
    checkEntryCount(counts.back());
    grid.heads.assign(counts.begin(), counts.end());
    grid.ids.resize(counts.back());
    forEachEntry([&](size_t cell, uint32_t id) { grid.ids[counts[cell]++] = id; });
    return grid;
}

void checkEntryCount(uint64_t entries) {
    if (entries > UINT32_MAX)
        throw InputError(std::to_string(entries) +
                         " list entries exceed 32 bits; take a larger tile or fewer bins");
}

} // namespace dirt
