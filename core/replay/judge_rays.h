#pragma once

#include "core/replay/replay_input.h"
#include "core/verify/view_scope.h"

#include <string>

namespace dirt {

// What the judges of hits and of shadow rays share.

/// Which rays the dump's views answer for.
ViewScope scopeOf(const Manifest& manifest);

/// Whether the tile in which \p hit is filed lists its primitive. The input has lists.
bool isListed(const ReplayInput& input, const Hit& hit);

/// "filed in view +X, column 1, row 2, which does not list it".
std::string misfiledText(const ReplayInput& input, const Hit& hit);

/// "pixel 3,4".
std::string pixelText(const ReplayInput& input, uint32_t pixel);

/// With nine digits, which tell floats apart.
std::string numberText(double x);

} // namespace dirt
