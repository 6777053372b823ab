#include "core/replay/dumped_view.h"

#include "core/verify/exact_clip.h"
#include "shaders/shared/margins.h"

namespace dirt {

View withGuardBand(View view, int tile, double part) {
    const TileSize size = tileSize(view, tile);
    const auto widen = [](const std::vector<float>& at, double guard, std::vector<float>& lo,
                          std::vector<float>& hi) {
        lo.clear();
        hi.clear();
        for (size_t i = 0; i + 1 < at.size(); ++i) {
            lo.push_back((float) (at[i] - guard));
            hi.push_back((float) (at[i + 1] + guard));
        }
    };
    widen(view.s, size.x * part, view.sLo, view.sHi);
    widen(view.t, size.y * part, view.tLo, view.tHi);
    return view;
}

Camera dumpedCamera(std::optional<float> fov) {
    Camera camera;
    camera.verticalFov = fov.value_or(camera.verticalFov);
    return camera;
}

void addGuardBands(std::vector<View>& views, const GridSettings& settings,
                   std::optional<float> fov) {
    std::vector<View> made;
    if (!views.empty() && (settings.mode == ViewMode::full || fov))
        made = makeViews(settings, dumpedCamera(fov));
    for (View& view : views) {
        view = withGuardBand(std::move(view), settings.tile, kGuardBand);
        for (const View& other : made)
            if (other.axisX == view.axisX && other.axisY == view.axisY &&
                other.axisW == view.axisW && other.signW == view.signW && other.s == view.s &&
                other.t == view.t)
                view = other;
    }
}

} // namespace dirt
