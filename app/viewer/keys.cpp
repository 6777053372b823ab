#include "app/viewer/keys.h"

#include "app/viewer/navigation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dirt {

namespace {

/// The way through the scene's box takes so long.
constexpr double kSecondsThrough = 6.0;
constexpr double kRadiansPerPixel = 0.004;

using Edit = void (*)(ViewState&);

void change(Viewer& viewer, Edit edit) {
    viewer.model.change(edit);
}

void addBounces(ViewState& s, int more) {
    s.settings.bounces = std::clamp(s.settings.bounces + more, 1, kMostBounces);
}
void addBins(ViewState& s, int more) {
    s.settings.grid.bins = std::clamp(s.settings.grid.bins + more, 1, kMostBins);
}
void scaleLens(ViewState& s, float factor) {
    s.lensRadius *= factor;
    if (s.camera.apertureRadius > 0.0f) s.camera.apertureRadius = s.lensRadius;
}

/// The powers of two around a tile's side.
void widenTile(ViewState& s) {
    int tile = 1;
    while (tile <= s.settings.grid.tile) tile *= 2;
    s.settings.grid.tile = std::min(tile, kLargestTile);
}
void narrowTile(ViewState& s) {
    int tile = kLargestTile;
    while (tile > 1 && tile >= s.settings.grid.tile) tile /= 2;
    s.settings.grid.tile = tile;
}

/// -1, all levels, is above the highest.
void changeLevel(ViewState& s, int more) {
    int& level = s.settings.grid.maxMip;
    if (level < 0)
        level = more > 0 ? -1 : kHighestLevel;
    else
        level = level + more > kHighestLevel ? -1 : std::max(0, level + more);
}

template <typename Enum>
void cycle(Enum& value, Enum last) {
    value = value == last ? Enum(0) : Enum((int) value + 1);
}

/// The next kind of preview, or the one before.
void showNext(ViewState& s, int step) {
    const auto kinds = previewKinds();
    const auto count = (std::ptrdiff_t) kinds.size();
    std::ptrdiff_t at = s.shown - kinds.data();
    do // those that need a light's map do not stand in every scene
        at = (at + step + count) % count;
    while (kinds[(size_t) at].of == PreviewKind::Of::light &&
           s.settings.visibility != LightVisibility::shadowMap);
    s.shown = &kinds[(size_t) at];
}

void toggleRay(Viewer& viewer) {
    viewer.step = 0;
    change(viewer, [](ViewState& s) {
        if (s.ray)
            s.ray.reset();
        else
            showRay(s, 0.5, 0.5);
    });
}

/// From all rays of a path to the first alone, and on; or back.
void stepAlongPath(Viewer& viewer, int step) {
    const std::shared_ptr<const ViewPicture> shown = viewer.model.picture();
    const int steps = shown ? (int) shown->path.size() : 0;
    if (steps == 0) return viewer.say("no rays are shown: -");
    viewer.step = (viewer.step + step + steps) % steps;
}

void playOrPause(Viewer& viewer) {
    if (viewer.model.facts().lastFrame == 0) return viewer.say("nothing moves in this scene");
    change(viewer, [](ViewState& s) { s.playing = !s.playing; });
}

void move(Viewer& viewer, double seconds, double ahead, double right, double up) {
    const double step = viewer.model.facts().extent / kSecondsThrough * seconds;
    viewer.model.change(
        [&](ViewState& s) { moveCamera(s.camera, ahead * step, right * step, up * step); }, true);
}

constexpr KeyBinding kBindings[] = {
    {kF1, "F1", "this list", [](Viewer& v) { v.help = !v.help; }},
    {kEscape, "Esc", "quit", [](Viewer& v) { v.quit = true; }},
    {kUp, "Up", "move ahead", nullptr, [](Viewer& v, double s) { move(v, s, 1, 0, 0); }},
    {kDown, "Down", "move back", nullptr, [](Viewer& v, double s) { move(v, s, -1, 0, 0); }},
    {kLeft, "Left", "move left", nullptr, [](Viewer& v, double s) { move(v, s, 0, -1, 0); }},
    {kRight, "Right", "move right", nullptr, [](Viewer& v, double s) { move(v, s, 0, 1, 0); }},
    {kPageUp, "PgUp", "move up", nullptr, [](Viewer& v, double s) { move(v, s, 0, 0, 1); }},
    {kPageDown, "PgDn", "move down", nullptr, [](Viewer& v, double s) { move(v, s, 0, 0, -1); }},
    {'M', "M", "progressive: samples add up at rest, or one alone",
     [](Viewer& v) { change(v, [](ViewState& s) { s.progressive = !s.progressive; }); }},
    {'3', "3", "more bounces",
     [](Viewer& v) { change(v, [](ViewState& s) { addBounces(s, 1); }); }},
    {'4', "4", "fewer bounces",
     [](Viewer& v) { change(v, [](ViewState& s) { addBounces(s, -1); }); }},
    {'F', "F", "depth of field, on or off",
     [](Viewer& v) {
         change(v, [](ViewState& s) {
             s.camera.apertureRadius = s.camera.apertureRadius > 0.0f ? 0.0f : s.lensRadius;
         });
     }},
    {'C', "C", "larger aperture",
     [](Viewer& v) { change(v, [](ViewState& s) { scaleLens(s, 1.25f); }); }},
    {'V', "V", "smaller aperture",
     [](Viewer& v) { change(v, [](ViewState& s) { scaleLens(s, 0.8f); }); }},
    {'Z', "Z", "focus farther",
     [](Viewer& v) { change(v, [](ViewState& s) { s.camera.focalDistance *= 1.1f; }); }},
    {'X', "X", "focus nearer",
     [](Viewer& v) { change(v, [](ViewState& s) { s.camera.focalDistance /= 1.1f; }); }},
    {'G', "G", "a single view, or six",
     [](Viewer& v) {
         change(v, [](ViewState& s) { cycle(s.settings.grid.mode, ViewMode::single); });
     }},
    {'5', "5", "more bins", [](Viewer& v) { change(v, [](ViewState& s) { addBins(s, 1); }); }},
    {'6', "6", "fewer bins", [](Viewer& v) { change(v, [](ViewState& s) { addBins(s, -1); }); }},
    {'7', "7", "larger tiles", [](Viewer& v) { change(v, widenTile); }},
    {'8', "8", "smaller tiles", [](Viewer& v) { change(v, narrowTile); }},
    {'9', "9", "higher top level of the pyramid",
     [](Viewer& v) { change(v, [](ViewState& s) { changeLevel(s, 1); }); }},
    {'0', "0", "lower top level of the pyramid",
     [](Viewer& v) { change(v, [](ViewState& s) { changeLevel(s, -1); }); }},
    {'Q', "Q", "light by rays, or by a shadow map",
     [](Viewer& v) {
         change(v, [](ViewState& s) { cycle(s.settings.visibility, LightVisibility::shadowMap); });
     }},
    {'=', "=", "next type of rays: as materials say, diffuse, glossy, specular, visibility",
     [](Viewer& v) {
         change(v, [](ViewState& s) { cycle(s.settings.rayType, RayType::visibility); });
     }},
    {'B', "B", "next backend",
     [](Viewer& v) { change(v, [](ViewState& s) { cycle(s.backend, BackendKind::embree); }); }},
    {'P', "P", "a buffer in false colours, or the image",
     [](Viewer& v) {
         change(v, [](ViewState& s) {
             const PreviewKind* image = previewKind("image");
             s.shown = s.shown == image ? previewKind("overview") : image;
         });
     }},
    {'1', "1", "previous buffer",
     [](Viewer& v) { change(v, [](ViewState& s) { showNext(s, -1); }); }},
    {'2', "2", "next buffer", [](Viewer& v) { change(v, [](ViewState& s) { showNext(s, 1); }); }},
    {'-', "-", "the rays of the pixel in the middle, or of the one that was clicked", toggleRay},
    {'.', ".", "the next ray of the pixel's path alone", [](Viewer& v) { stepAlongPath(v, 1); }},
    {',', ",", "the one before", [](Viewer& v) { stepAlongPath(v, -1); }},
    {' ', "Space", "an animated scene: pause, or go on", playOrPause},
    {kTab, "Tab", "all of this for the mouse", [](Viewer& v) { v.panel = !v.panel; }},
    {'T', "T", "time of each pass", [](Viewer& v) { v.timers = !v.timers; }},
    {kF8, "F8", "figures over the picture", [](Viewer& v) { v.text = !v.text; }},
    {kF5, "F5", "save what is shown", savePicture},
    {kF6, "F6", "write the camera to standard error and the log", logCamera},
    {'R', "R", "read scene and shaders again", [](Viewer& v) { v.model.reload(); }},
};

} // namespace

std::span<const KeyBinding> keyBindings() {
    return kBindings;
}

const KeyBinding* keyBinding(int key) {
    const auto* found = std::find_if(std::begin(kBindings), std::end(kBindings),
                                     [&](const KeyBinding& binding) { return binding.key == key; });
    return found == std::end(kBindings) ? nullptr : found;
}

void dragView(Viewer& viewer, double right, double down) {
    viewer.model.change(
        [&](ViewState& s) {
            turnCamera(s.camera, right * kRadiansPerPixel, -down * kRadiansPerPixel);
        },
        true);
}

} // namespace dirt
