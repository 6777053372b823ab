#pragma once

#include "core/grid/view.h"
#include "core/verify/exact_clip.h"
#include "tests/support/random.h"

#include <vector>

namespace dirt::test {

/// A frame's views with the settings they were made from.
struct ViewSet {
    GridSettings settings;
    Camera camera;
    std::vector<View> views;

    ViewSet(const GridSettings& settings, const Camera& camera)
        : settings(settings), camera(camera), views(makeViews(settings, camera)) {}
    TileSize tileSize(const View& view) const { return dirt::tileSize(view, settings.tile); }
};

inline ViewSet fullViews(int viewSize, int tile) {
    GridSettings settings;
    settings.viewSize = viewSize;
    settings.tile = tile;
    return {settings, Camera{}};
}

inline ViewSet singleView(int width, int height, int tile, float verticalFov) {
    GridSettings settings;
    settings.mode = ViewMode::single;
    settings.width = width;
    settings.height = height;
    settings.tile = tile;
    Camera camera;
    camera.verticalFov = verticalFov;
    return {settings, camera};
}

/// Cube faces of 1 to 8192 tiles, powers of two and not, with and without a partial last tile; and
/// camera views from 1 to 170 degrees in odd sizes.
inline std::vector<ViewSet> variousViews(Random& random) {
    std::vector<ViewSet> sets;
    for (int size : {1, 2, 3, 5, 16, 33, 100, 512, 1000, 1024, 4099, 8191, 8192})
        sets.push_back(fullViews(size, 1));
    sets.push_back(fullViews(512, 16));
    sets.push_back(fullViews(517, 16));
    sets.push_back(fullViews(7, 16));
    sets.push_back(fullViews(8192 * 3 - 1, 3));
    sets.push_back(fullViews(8192 * 64, 64));
    for (int i = 0; i < 6; ++i) {
        const int tile = random.range(1, 64), columns = (int) random.powerOfTwo(0, 13);
        sets.push_back(fullViews(std::max(1, columns * tile - random.below(tile)), tile));
    }

    for (float fov : {1.0f, 10.0f, 45.0f, 90.0f, 120.0f, 170.0f}) {
        sets.push_back(singleView(1023, 517, random.pick({1, 2, 4, 16, 63}), fov));
        sets.push_back(singleView(random.range(1, 300), random.range(1, 300), 1, fov));
        sets.push_back(singleView(8192, random.range(1, 8192), 1, fov));
    }
    sets.push_back(singleView(1, 1, 1, 53.0f));
    sets.push_back(singleView(5, 3, 64, 53.0f));
    sets.push_back(singleView(1, 8192, 1, 60.0f));
    return sets;
}

/// The point of the grid frame that is (x, y, w) in the view's frame.
inline glm::vec3 fromView(const View& view, glm::vec3 p) {
    glm::vec3 grid;
    grid[view.axisX] = p.x;
    grid[view.axisY] = p.y;
    grid[view.axisW] = view.signW * p.z;
    return grid;
}

} // namespace dirt::test
