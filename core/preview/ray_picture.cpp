#include "core/preview/ray_picture.h"

#include "core/base/error.h"
#include "core/dump/dump.h"
#include "core/preview/ray_colours.h"
#include "core/preview/ray_panels.h"

#include <algorithm>
#include <cstdio>

namespace dirt {

namespace {

constexpr int kLeastPanel = 340;               // pixels
constexpr uint64_t kLargestPicture = 1u << 26; // pixels

/// A view that the ray enters, and where its drawings stand.
struct Band {
    const ViewTrail* trail;
    ViewWindow window;
    Box depths; ///< of width 0: no tile is visited
    std::string title;

    int bottom() const { return std::max(window.box().bottom(), depths.bottom()); }
    int right() const { return std::max(window.box().right(), depths.right()); }
};

std::string titleOf(const Grid& grid, const ViewTrail& trail, const ViewWindow& window) {
    const View& view = grid.views[(size_t) trail.span.view];
    char text[192];
    std::snprintf(text, sizeof text, "view %d, %s: cells looked at %zu, tiles visited %zu",
                  trail.span.view, viewName(grid, (size_t) trail.span.view).c_str(),
                  trail.cells.size(), trail.tiles.size());
    std::string title = text;
    if (window.columns == view.columns && window.rows == view.rows) return title;
    std::snprintf(text, sizeof text, "; tiles (%d, %d) to (%d, %d) are shown", window.column,
                  window.row, window.column + window.columns - 1, window.row + window.rows - 1);
    return title + text;
}

std::vector<Band> bandsOf(const Grid& grid, const RayTrail& trail, int top) {
    std::vector<Band> bands;
    for (const ViewTrail& view : trail.views) {
        if (view.cells.empty()) continue; // touched in the eye alone
        Band band{&view, windowOf(grid.views[(size_t) view.span.view], view), {}, {}};
        band.title = titleOf(grid, view, band.window);
        band.window.left = kPictureMargin;
        band.window.top = top + textHeight() + 4;
        band.depths = {band.window.box().right() + kPictureMargin, band.window.top,
                       depthPanelWidth(view), std::max(band.window.height(), kLeastPanel)};
        if (band.depths.width == 0) band.depths.height = 0;
        top = band.bottom() + kPictureMargin;
        bands.push_back(band);
    }
    return bands;
}

std::vector<Key> tileKeys(bool shadow) {
    using Shape = Key::Shape;
    return {{Shape::line, kRayLine, kRayLine, "the ray, from its ring on; grey beyond its end"},
            {Shape::cross, kHitMark, kHitMark, shadow ? "what blocks it" : "what it hits"},
            {Shape::box, kVisited, kVisitedRim, "tile visited, numbered in their order"},
            {Shape::box, kPassedOver, kPassedOverRim,
             "cell passed over: depths do not meet; with its level"},
            {Shape::box, kFilledTile, kLookedInto, "cell looked into: the next level is finer"},
            {Shape::box, kFilledTile, kFilledTile, "tile that lists something"},
            {Shape::box, kEmptyTile, kEmptyTile, "tile that lists nothing"}};
}

std::vector<Key> depthKeys() {
    using Shape = Key::Shape;
    return {{Shape::box, kVisited, kVisitedRim, "bin visited"},
            {Shape::box, kFilledTile, kFaintWords, "bin that lists something, not visited"},
            {Shape::box, kEmptyTile, kFaintWords, "bin that lists nothing"},
            {Shape::box, kMissed, kMissed, "depths of a triangle in the tile: missed"},
            {Shape::box, kHitMark, kHitMark, "hit: the nearest so far"},
            {Shape::box, kFarther, kFarther, "met too far away"},
            {Shape::box, kRefused, kRefused, "met, but skipped, a hole or out of view"}};
}

std::string endOf(const DrawnRay& ray) {
    char text[192] = "hits nothing";
    if (ray.hits())
        std::snprintf(text, sizeof text, "%s primitive %u at t %.6g",
                      ray.trail.maxT ? "blocked by" : "hits", ray.primitive(), ray.end());
    std::string end = text;
    if (!ray.trail.maxT) return end;
    std::snprintf(text, sizeof text, "the light is at t %.6g", (double) *ray.trail.maxT);
    return (ray.trail.blocked ? end : "open") + "; " + text;
}

std::string outcomeOf(const DrawnRay& ray) {
    const RayTrail& trail = ray.trail;
    std::string outcome = endOf(ray);
    char text[192];
    if (!trail.atEye.empty())
        outcome += "; " + std::to_string(trail.atEye.size()) + " triangles tested at the eye";
    if (trail.views.empty()) outcome += "; enters no view";
    const GridSettings& settings = ray.grid.settings;
    std::snprintf(text, sizeof text, "; bins visited %llu (%d a tile), tests %llu",
                  (unsigned long long) trail.counts.bins, settings.bins,
                  (unsigned long long) trail.counts.tests);
    return outcome + text;
}

/// Pictures below each other. Throws InputError where they are too large together.
class Stack {
public:
    void add(Picture picture) {
        width_ = std::max(width_, (uint64_t) picture.width);
        height_ += (uint64_t) picture.height;
        if (width_ * height_ > kLargestPicture)
            throw InputError("the picture of all rays would have more than " +
                             std::to_string(kLargestPicture) + " pixels: --event K chooses some");
        pictures_.push_back(std::move(picture));
    }
    bool empty() const { return pictures_.empty(); }

    Picture whole() const {
        Picture all((int) width_, (int) height_);
        Canvas canvas(all);
        canvas.fill({0, 0, all.width, all.height}, kBackground);
        int top = 0;
        for (const Picture& picture : pictures_) {
            canvas.paste(picture, 0, top);
            top += picture.height;
        }
        return all;
    }

private:
    std::vector<Picture> pictures_;
    uint64_t width_ = 0, height_ = 0;
};

} // namespace

Picture drawRay(const Grid& grid, const FrameGeometry& geometry, const RayTrail& trail,
                const std::string& title) {
    const DrawnRay ray{grid, geometry, trail};
    const std::string outcome = outcomeOf(ray);
    const int head = kPictureMargin + 2 * textHeight() + 8;
    const std::vector<Band> bands = bandsOf(grid, trail, head);
    const std::vector<Key> ofTiles = tileKeys(trail.maxT.has_value()), ofDepths = depthKeys();
    int width = 2 * kPictureMargin + std::max(textWidth(title), textWidth(outcome));
    width = std::max(width, 4 * kPictureMargin + widthOf(ofTiles) + widthOf(ofDepths));
    int top = head;
    for (const Band& band : bands) {
        width = std::max(
            {width, band.right() + kPictureMargin, 2 * kPictureMargin + textWidth(band.title)});
        top = band.bottom() + kPictureMargin;
    }
    Picture picture(width, top + std::max(heightOf(ofTiles), heightOf(ofDepths)) + kPictureMargin);
    Canvas canvas(picture);
    canvas.fill({0, 0, picture.width, picture.height}, kBackground);
    canvas.text(kPictureMargin, kPictureMargin, title, kWords);
    canvas.text(kPictureMargin, kPictureMargin + textHeight(), outcome, kWords);
    for (const Band& band : bands) {
        canvas.text(kPictureMargin, band.window.top - textHeight() - 2, band.title, kFaintWords);
        drawTilesPanel(canvas, ray, *band.trail, band.window);
        if (band.depths.width > 0) drawDepthPanel(canvas, ray, *band.trail, band.depths);
    }
    drawKeys(canvas, kPictureMargin, top, ofTiles);
    drawKeys(canvas, 3 * kPictureMargin + widthOf(ofTiles), top, ofDepths);
    return picture;
}

Picture drawRays(const PathAccount& account, const std::string& title, std::optional<int> event) {
    if (!account.grid)
        throw InputError("this backend's structure is no grid: there is no way to draw");
    Stack pictures;
    for (const EventAccount& one : account.events) {
        if (event && *event != one.event) continue;
        for (const ExplainedRay& ray : raysOf(account, one))
            pictures.add(drawRay(*account.grid, account.geometry, *ray.trail,
                                 "event " + std::to_string(one.event) + ", " + ray.kind +
                                     " ray of " + title));
    }
    if (pictures.empty()) throw InputError("the path has no ray there: there is nothing to draw");
    return pictures.whole();
}

} // namespace dirt
