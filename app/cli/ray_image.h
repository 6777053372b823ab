#pragma once

#include "core/preview/ray_picture.h"

#include <string>

namespace dirt {

/// Throws InputError where no picture of rays can be written to \p path.
void checkRayImage(const std::string& path);

/// Writes one, with what it shows as the attribute "dirt:rays". Throws InputError.
void writeRayImage(const std::string& path, const Picture& picture, const std::string& title);

} // namespace dirt
