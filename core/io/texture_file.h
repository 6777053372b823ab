#pragma once

#include "core/scene/texture.h"

#include <filesystem>

namespace dirt {

/// Reads an image as a colour texture: integer formats as sRGB with 8 bits, float formats as they
/// are. One channel is grey; alpha is dropped and does not scale the colour. Throws InputError
/// ("file: what is wrong") where the file is damaged, absurdly large or no image, or where a float
/// texel is negative or not finite.
Texture readTexture(const std::filesystem::path& file);

} // namespace dirt
