#pragma once

#include <filesystem>
#include <string>

namespace dirt {

/// Whether the bytes begin as PNG files do.
bool isPng(const std::string& bytes);

/// The chunks of a PNG file that decide its pixels: IHDR, PLTE, tRNS, IDAT and IEND. \p file is for
/// messages. Throws InputError where the file ends early or a chunk's checksum is wrong.
///
/// libpng prints such errors on standard error by itself, and its opinion of colour profiles and
/// dates as well: it only gets to see what is sound and needed.
std::string essentialPng(const std::string& bytes, const std::filesystem::path& file);

} // namespace dirt
