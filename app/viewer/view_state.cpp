#include "app/viewer/view_state.h"

#include <algorithm>

namespace dirt {

void showRay(ViewState& state, double x, double y) {
    const GridSettings& grid = state.settings.grid;
    state.ray = std::array{std::clamp((int) (x * grid.width), 0, grid.width - 1),
                           std::clamp((int) (y * grid.height), 0, grid.height - 1)};
}

} // namespace dirt
