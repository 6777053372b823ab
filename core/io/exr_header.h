#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dirt {

/// What is wrong with the headers of an OpenEXR file's parts, as far as it would cost memory that
/// the file's length does not warrant: sizes of attributes, previews, texts and tables of chunks,
/// which the library believes ("OpenEXR File Layout", openexr.com). Nothing: it may be read.
std::optional<std::string> exrHeaderFault(std::string_view bytes);

} // namespace dirt
