#pragma once

#include "core/io/exr_parts.h"

#include <filesystem>
#include <vector>

namespace dirt {

/// The parts of a flat EXR file whose channels are 32-bit floats or unsigned integers, bits as they
/// are. Throws InputError ("file: what is wrong") where the file is none such, is damaged, or
/// claims more than its bytes can hold, before memory is taken for it.
std::vector<ExrPart> readExrParts(const std::filesystem::path& file);

} // namespace dirt
