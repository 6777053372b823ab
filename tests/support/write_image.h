#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace dirt::test {

/// What a file keeps a channel in.
enum class TexelType { uint8, uint16, half, float32 };

/// Writes an image with OpenImageIO, as the ending of \p file says: channels of texels of rows, the
/// first row on top, alpha (of two or four channels) as it is given. Values of integer types are
/// from 0 to 1. Gives the file.
std::string writeImage(const std::filesystem::path& file, int width, int height, int channels,
                       TexelType type, const std::vector<float>& values);

/// The same of bytes as they are.
std::string writeImage(const std::filesystem::path& file, int width, int height, int channels,
                       const std::vector<uint8_t>& texels);

} // namespace dirt::test
