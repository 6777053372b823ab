#include "app/cli/pixel_option.h"

#include "core/base/error.h"

namespace dirt {

void checkPixel(const std::string& option, const std::array<int, 2>& pixel,
                const RenderSettings& settings) {
    const GridSettings& grid = settings.grid;
    if (pixel[0] >= grid.width || pixel[1] >= grid.height)
        throw InputError(option + " " + std::to_string(pixel[0]) + "," + std::to_string(pixel[1]) +
                         ": the image has " + std::to_string(grid.width) + "x" +
                         std::to_string(grid.height) + " pixels");
}

void checkEvent(const std::optional<int>& event, const RenderSettings& settings) {
    if (event && *event >= settings.bounces)
        throw InputError("--event " + std::to_string(*event) + ": the path events of " +
                         std::to_string(settings.bounces) + " bounces are 0 to " +
                         std::to_string(settings.bounces - 1));
}

} // namespace dirt
