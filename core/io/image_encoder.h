#pragma once

#include "core/io/image.h"

#include <functional>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

namespace dirt {

/// A flat image in these channels. (The library's constructor ends the process where memory is
/// out.)
OIIO::ImageSpec imageSpec(int width, int height, std::vector<std::string> channels,
                          OIIO::TypeDesc format);

/// Adds \p metadata, and pins what would otherwise differ between equal files.
void describeImage(OIIO::ImageSpec& spec, const ImageMetadata& metadata);

/// Encodes an image into memory, where no disk can fill up unnoticed, then writes the bytes.
/// \p encode opens the output under the name it is given, fills and closes it, and says whether
/// all calls succeeded. Throws InputError.
void writeEncoded(const std::string& path, const char* format,
                  const std::function<bool(OIIO::ImageOutput&, const std::string& name)>& encode);

/// The same for what OpenImageIO writes to files alone: multi-part EXR.
void writeEncodedParts(
    const std::string& path,
    const std::function<bool(OIIO::ImageOutput&, const std::string& name)>& encode);

} // namespace dirt
