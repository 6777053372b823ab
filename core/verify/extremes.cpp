#include "core/verify/extremes.h"

#include "core/verify/extreme_bodies.h"
#include "core/verify/extreme_places.h"
#include "core/verify/extreme_triangles.h"

#include <algorithm>

namespace dirt {

namespace {

void asItIs(Scene&, GridSettings&) {}

template <int kExponent>
void scale(Scene& scene, GridSettings&) {
    constexpr double kPowers[] = {1e-6, 1e-3, 1.0, 1e3, 1e6};
    scaleAll(scene, kPowers[kExponent / 3 + 2]);
}

template <int kExponent>
void move(Scene& scene, GridSettings&) {
    constexpr double kPowers[] = {1e3, 1e5, 1e7};
    moveAway(scene, kPowers[kExponent / 2 - 1]);
}

template <int kScale, int kMove>
void scaleAndMove(Scene& scene, GridSettings& grid) {
    scale<kScale>(scene, grid);
    move<kMove>(scene, grid);
}

/// Only the camera's view, \p fov degrees high.
void lookThrough(Scene& scene, GridSettings& grid, float fov) {
    grid.mode = ViewMode::single;
    scene.camera.verticalFov = fov;
}

/// Few enough tiles that the longest side costs no more than the others.
void setSize(GridSettings& grid, ViewMode mode, int width, int height) {
    grid.mode = mode;
    grid.width = width, grid.height = height;
    grid.viewSize = 0;
    grid.tile = std::max(width, height) > 1024 ? 64 : 4;
}

/// Faces smaller than a tile.
void takeLargeTiles(GridSettings& grid, ViewMode mode) {
    setSize(grid, mode, 16, 16);
    grid.tile = 64;
}

/// What is closed is closed in full view; in single view rays end at its borders.
template <bool kShared>
void enclose(Scene& scene, GridSettings& grid) {
    grid.mode = ViewMode::full;
    encloseInBox(scene, kShared);
}

constexpr ViewMode kFull = ViewMode::full, kSingle = ViewMode::single;
constexpr auto kBox = Extreme::Body::closedBox, kBall = Extreme::Body::ball;
const std::vector<RayKind> kAll(kRayKinds.begin(), kRayKinds.end());

using S = Scene;
using G = GridSettings;

const std::vector<Extreme> kExtremes{
    {"rays-primary", asItIs, {RayKind::primary}},
    {"rays-diffuse", asItIs, {RayKind::diffuse}},
    {"rays-vertex", asItIs, {RayKind::vertex}},
    {"rays-edge", asItIs, {RayKind::edge}},
    {"rays-axis", asItIs, {RayKind::axis}},
    {"rays-grazing", asItIs, {RayKind::grazing}},
    {"rays-plane", asItIs, {RayKind::plane}},
    {"rays-border", asItIs, {RayKind::border}},
    {"rays-wild", asItIs, {RayKind::wild}},

    {"scale-1e-6", scale<-6>},
    {"scale-1e-3", scale<-3>},
    {"scale-1e3", scale<3>},
    {"scale-1e6", scale<6>},
    {"moved-1e3", move<3>},
    {"moved-1e5", move<5>},
    {"moved-1e7", move<7>},
    {"scale-1e-6-moved-1e3", scaleAndMove<-6, 3>},
    {"scale-1e-6-moved-1e7", scaleAndMove<-6, 7>},
    {"scale-1e6-moved-1e3", scaleAndMove<6, 3>},
    {"scale-1e6-moved-1e5", scaleAndMove<6, 5>},

    {"eye-on-vertex", [](S& s, G&) { standOnVertex(s); }},
    {"eye-on-edge", [](S& s, G&) { standOnEdge(s); }},
    {"eye-on-triangle", [](S& s, G&) { standOnTriangle(s); }},
    {"eye-in-plane", [](S& s, G&) { standInPlane(s); }},
    {"eye-on-tile-border", [](S& s, G& g) { standOnBorder(s, g, 0.5); }},
    {"eye-on-middle-border", [](S& s, G& g) { standOnBorder(s, g, 0.0); }},
    {"eye-on-face-diagonal", [](S& s, G& g) { standOnFaceDiagonal(s, g); }},

    {"near-1e-8", [](S& s, G&) { addNear(s); }},
    {"far-1e8", [](S& s, G&) { addFar(s); }},

    {"slivers", [](S& s, G&) { addSlivers(s); }},
    {"needles", [](S& s, G&) { addNeedles(s); }},
    {"points", [](S& s, G&) { addPoints(s); }},
    {"repeated", [](S& s, G&) { addRepeated(s); }},
    {"collinear", [](S& s, G&) { addCollinear(s); }},
    {"coincident", [](S& s, G&) { addCoincident(s); }},
    {"t-junctions", [](S& s, G&) { cutEdges(s); }},
    {"crowded-bin", [](S& s, G&) { crowdOneBin(s); }},
    {"covering", [](S& s, G&) { coverAll(s); }},

    {"fov-0.01", [](S& s, G& g) { lookThrough(s, g, 0.01f); }},
    {"fov-1", [](S& s, G& g) { lookThrough(s, g, 1.0f); }},
    {"fov-150", [](S& s, G& g) { lookThrough(s, g, 150.0f); }},
    {"fov-179.99", [](S& s, G& g) { lookThrough(s, g, 179.99f); }},

    {"size-1x1", [](S&, G& g) { setSize(g, kFull, 1, 1); }},
    {"size-1x1-single", [](S&, G& g) { setSize(g, kSingle, 1, 1); }},
    {"size-8192x1", [](S&, G& g) { setSize(g, kFull, 8192, 1); }},
    {"size-8192x1-single", [](S&, G& g) { setSize(g, kSingle, 8192, 1); }},
    {"size-1x8192", [](S&, G& g) { setSize(g, kFull, 1, 8192); }},
    {"size-1x8192-single", [](S&, G& g) { setSize(g, kSingle, 1, 8192); }},
    {"bins-1", [](S&, G& g) { g.bins = 1; }},
    {"bins-256", [](S&, G& g) { g.bins = 256; }},
    {"tile-beyond-image", [](S&, G& g) { takeLargeTiles(g, kFull); }},
    {"tile-beyond-image-single", [](S&, G& g) { takeLargeTiles(g, kSingle); }},

    {"box-shared", enclose<true>, kAll, kBox},
    {"box-unshared", enclose<false>, kAll, kBox},
    {"box-shared-scale-1e-6", [](S& s, G& g) { scale<-6>(s, g), enclose<true>(s, g); }, kAll, kBox},
    {"box-shared-scale-1e6", [](S& s, G& g) { scale<6>(s, g), enclose<true>(s, g); }, kAll, kBox},
    {"box-shared-moved-1e5", [](S& s, G& g) { move<5>(s, g), enclose<true>(s, g); }, kAll, kBox},
    {"box-unshared-moved-1e5", [](S& s, G& g) { move<5>(s, g), enclose<false>(s, g); }, kAll, kBox},
    {"ball", [](S& s, G&) { replaceByBall(s); }, kAll, kBall},
    {"ball-scale-1e-6", [](S& s, G& g) { scale<-6>(s, g), replaceByBall(s); }, kAll, kBall},
    {"ball-scale-1e6", [](S& s, G& g) { scale<6>(s, g), replaceByBall(s); }, kAll, kBall},
    {"ball-moved-1e3", [](S& s, G& g) { move<3>(s, g), replaceByBall(s); }, kAll, kBall},
    {"ball-moved-1e5", [](S& s, G& g) { move<5>(s, g), replaceByBall(s); }, kAll, kBall},
};

} // namespace

const std::vector<Extreme>& extremes() {
    return kExtremes;
}

const Extreme* extremeByName(std::string_view name) {
    const auto found = std::find_if(kExtremes.begin(), kExtremes.end(),
                                    [&](const Extreme& extreme) { return extreme.name == name; });
    return found == kExtremes.end() ? nullptr : &*found;
}

} // namespace dirt
