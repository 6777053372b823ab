#pragma once

#include "core/scene/scalar_texture.h"
#include "core/scene/texture.h"

#include <filesystem>
#include <optional>

namespace dirt {

/// Reads an image as a colour texture: integer formats as sRGB with 8 bits, float formats as they
/// are. One channel is grey; alpha is dropped and does not scale the colour. Throws InputError
/// ("file: what is wrong") where the file is damaged, absurdly large or no image, or where a float
/// texel is negative or not finite.
Texture readTexture(const std::filesystem::path& file);

/// Reads an image as data: its first channel, 8-bit formats as 0 to 1, others as floats. Throws
/// InputError as readTexture does; a float texel may be negative.
ScalarTexture readScalarTexture(const std::filesystem::path& file);

/// An image's alpha, if it has any that cuts out a part of the image and leaves one: texels below
/// 1/2 and others. Throws InputError as readTexture does.
std::optional<ScalarTexture> readAlpha(const std::filesystem::path& file);

} // namespace dirt
