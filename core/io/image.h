#pragma once

#include "core/base/image.h"

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace dirt {

/// Attributes that an image file carries, "dirt:…" by convention. Numbers of 64 bits as text.
using ImageMetadata = std::vector<std::pair<std::string, std::string>>;

/// Formats that images are written in.
enum class ImageFormat { png, exr };

/// The format that a file name's extension asks for, in any letter case. Throws InputError for any
/// other.
ImageFormat imageFormat(const std::string& path);

/// Writes display-encoded 8-bit R, G, B, row-major, as PNG. The file appears whole or not at all,
/// and equal input gives equal bytes. Throws InputError where it cannot be written.
void writePng(const std::string& path, int width, int height, std::span<const uint8_t> rgb,
              const ImageMetadata& metadata);

/// Writes R, G, B as 32-bit float, zip-compressed EXR, in the same way.
void writeExr(const std::string& path, const Image& image, const ImageMetadata& metadata);

/// Reads the channels R, G, B, or Y, of an image as stored: EXR is linear, 8-bit values come out in
/// [0, 1] without decoding. One channel becomes grey. Throws InputError.
Image readImage(const std::string& path);

/// The string attributes of an image file whose names begin with "dirt:".
ImageMetadata readMetadata(const std::string& path);

} // namespace dirt
