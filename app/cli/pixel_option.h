#pragma once

#include "core/frame/settings.h"

#include <array>
#include <optional>
#include <string>

namespace dirt {

/// Throws InputError where the image has no such pixel. \p option: that names it.
void checkPixel(const std::string& option, const std::array<int, 2>& pixel,
                const RenderSettings& settings);

/// Throws InputError where paths have no such event.
void checkEvent(const std::optional<int>& event, const RenderSettings& settings);

} // namespace dirt
