#include "core/grid/view.h"

#include "core/base/error.h"
#include "shaders/shared/margins.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <glm/geometric.hpp>

namespace dirt {
namespace {

struct Borders {
    std::vector<float> at, lo, hi;
};

/// Border slopes of a view that spans [-rim, rim] with \p pixels pixels: double, rounded once.
/// \p guardBand: in tiles.
Borders makeBorders(int pixels, int tile, double rim, double guardBand) {
    const int tiles = (pixels + tile - 1) / tile;
    const double guard = guardBand * 2.0 * rim * tile / pixels;
    // 2 p - pixels is exact, so that the borders are symmetric and the rim is exactly +-rim.
    const auto slope = [&](int i) {
        return rim * (2.0 * std::min((int64_t) i * tile, (int64_t) pixels) - pixels) / pixels;
    };
    Borders borders;
    for (int i = 0; i <= tiles; ++i) borders.at.push_back((float) slope(i));
    for (int i = 0; i < tiles; ++i) {
        borders.lo.push_back((float) (slope(i) - guard));
        borders.hi.push_back((float) (slope(i + 1) + guard));
    }
    return borders;
}

View makeView(int width, int height, int tile, double rimX, double rimY, double guardBand) {
    View view;
    view.width = width;
    view.height = height;
    view.columns = (width + tile - 1) / tile;
    view.rows = (height + tile - 1) / tile;
    if (view.columns > kMaxTiles || view.rows > kMaxTiles)
        throw InputError("a view of " + std::to_string(width) + "x" + std::to_string(height) +
                         " pixels has more than " + std::to_string(kMaxTiles) +
                         " tiles a side at tile " + std::to_string(tile) + "; take a larger tile");
    Borders x = makeBorders(width, tile, rimX, guardBand);
    Borders y = makeBorders(height, tile, rimY, guardBand);
    view.s = std::move(x.at);
    view.sLo = std::move(x.lo);
    view.sHi = std::move(x.hi);
    view.t = std::move(y.at);
    view.tLo = std::move(y.lo);
    view.tHi = std::move(y.hi);
    return view;
}

void require(bool right, const char* what, double value, const char* range) {
    if (right) return;
    char text[128];
    std::snprintf(text, sizeof text, "%s %g; %s", what, value, range);
    throw InputError(text);
}

/// What no view can be made of.
void check(const GridSettings& settings, const Camera& camera) {
    require(settings.tile >= 1, "pixels of a tile:", settings.tile, "there is 1 at least");
    require(settings.bins >= 1, "bins of a tile:", settings.bins, "there is 1 at least");
    require(settings.width >= 1, "an image width of", settings.width, "it is 1 at least");
    require(settings.height >= 1, "an image height of", settings.height, "it is 1 at least");
    require(settings.viewSize >= 0, "a view size of", settings.viewSize,
            "it is 1 at least, or 0 for the image's height");
    if (settings.mode != ViewMode::single) return;
    const float fov = camera.verticalFov;
    require(fov > 0.0f && fov < 180.0f, "a field of view of", fov, "it is between 0 and 180");
    const glm::vec3 ahead = camera.target - camera.eye;
    if (ahead == glm::vec3(0.0f) || !(glm::dot(ahead, ahead) >= 0.0f))
        throw InputError("a single view needs a target that is not the eye");
}

} // namespace

std::vector<View> makeViews(const GridSettings& settings, const Camera& camera) {
    check(settings, camera);
    const double guardBand = settings.precision == Precision::exact ? kGuardBand : 0.0;
    if (settings.mode == ViewMode::single) {
        const double pi = 3.14159265358979323846;
        const double rimY = std::tan(camera.verticalFov * pi / 360.0);
        const double rimX = rimY * settings.width / settings.height;
        return {makeView(settings.width, settings.height, settings.tile, rimX, rimY, guardBand)};
    }
    const int size = settings.viewSize > 0 ? settings.viewSize : settings.height;
    std::vector<View> views(6, makeView(size, size, settings.tile, 1.0, 1.0, guardBand));
    for (int face = 0; face < 6; ++face) {
        View& view = views[face];
        view.axisW = face / 2;
        view.axisX = (view.axisW + 1) % 3;
        view.axisY = (view.axisW + 2) % 3;
        view.signW = face % 2 == 0 ? 1.0f : -1.0f;
    }
    return views;
}

} // namespace dirt
