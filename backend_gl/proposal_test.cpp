#include "backend_gl/proposal_test.h"

#include "backend_gl/depth_bounds.h"
#include "backend_gl/grid_views.h"
#include "backend_gl/id_buffer.h"
#include "backend_gl/triangle_buffer.h"
#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace dirt {
namespace {

constexpr int kTriangles = 3000;
constexpr int kPixels = 512, kTile = 16; ///< of a view, 32 x 32 tiles

/// Numbers that are the same on every machine.
class Numbers {
public:
    float below(float limit) { return (float) (bits_() >> 8) * 0x1p-24f * limit; }
    float around(float limit) { return below(2.0f * limit) - limit; }
    int upTo(int most) { return (int) (bits_() % (unsigned) (most + 1)); }

private:
    std::mt19937 bits_{1};
};

/// From a thousandth of a tile to a view in size, at depths of any ratio; a fifth with
/// corners on corners of tiles, a fifth thin, some through the plane of the eye.
std::vector<Triangle> hardTriangles() {
    Numbers random;
    std::vector<Triangle> triangles;
    for (int i = 0; i < kTriangles; ++i) {
        const glm::vec2 center{random.around(1.2f), random.around(1.2f)};
        const float spread = std::ldexp(1.0f, -1 - random.upTo(12));
        const int kind = random.upTo(9), axis = random.upTo(2);
        const float side = random.upTo(1) ? 1.0f : -1.0f;
        glm::vec3 corners[3];
        for (glm::vec3& corner : corners) {
            glm::vec2 slope = center + spread * glm::vec2(random.around(2.0f), random.around(2.0f));
            if (kind < 2) slope = glm::floor(slope * 16.0f) / 16.0f;
            if (kind >= 2 && kind < 4) slope.y = center.y + 1e-4f * spread * random.around(1.0f);
            float w = std::ldexp(0.25f + random.below(0.25f), -random.upTo(12));
            if (kind == 4) w = random.around(0.4f);
            corner[axis] = side * w;
            corner[(axis + 1) % 3] = slope.x * w;
            corner[(axis + 2) % 3] = slope.y * w;
        }
        triangles.push_back({corners[0], corners[1], corners[2]});
    }
    triangles.front().a.x = 1.0f; // the grid frame's largest coordinate
    return triangles;
}

/// The lists, of one bin a tile.
Grid listsOf(const Grid& empty, const TriangleBuffer& triangles, Programs& programs,
             Proposal proposal) {
    DepthBoundsTexture bounds(programs);
    IdBuffer ids(programs, 1 << 20, 0);
    bounds.clear(empty);
    ids.clear(empty);
    bounds.fill(triangles, ViewMode::full, proposal);
    Grid grid = empty;
    if (!ids.fill(triangles, bounds, ViewMode::full, proposal))
        throw CapabilityError("this OpenGL driver has no room for the lists of a test");
    ids.read(grid);
    return grid;
}

} // namespace

ProposalFaults proposalFaults(Programs& programs, Proposal proposal) {
    GridSettings settings;
    settings.width = settings.height = settings.viewSize = kPixels;
    settings.tile = kTile;
    settings.bins = 1;
    const Grid grid = makeEmptyGrid(Camera{}, settings);
    GridViews views;
    views.set(grid);
    TriangleBuffer triangles(programs);
    FrameGeometry geometry;
    geometry.triangles = hardTriangles();
    triangles.write(geometry);
    const Grid expected = listsOf(grid, triangles, programs, Proposal::rectangles);
    const Grid found = listsOf(grid, triangles, programs, proposal);
    ProposalFaults faults;
    for (int view = 0; view < (int) grid.views.size(); ++view)
        for (int tile = 0; tile < grid.views[(size_t) view].tiles(); ++tile) {
            const auto a = expected.list(view, tile, 0), b = found.list(view, tile, 0);
            for (const uint32_t id : a)
                faults.missed += !std::binary_search(b.begin(), b.end(), id);
            for (size_t i = 1; i < b.size(); ++i) faults.repeated += b[i] == b[i - 1];
        }
    return faults;
}

} // namespace dirt
