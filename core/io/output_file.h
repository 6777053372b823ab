#pragma once

#include <cstddef>
#include <span>
#include <string>

namespace dirt {

/// Writes \p bytes to \p path so that the file appears whole or not at all: under a temporary name
/// in the same folder, flushed to the disk, then renamed. Throws InputError "path: why not"; what
/// was at \p path before is then untouched. Refuses to replace what is not a regular file.
void writeFile(const std::string& path, std::span<const std::byte> bytes);

/// The same for text.
void writeFile(const std::string& path, const std::string& text);

/// Throws the InputError that writeFile would end in, as far as that can be known beforehand
/// (missing folder, no permission, a folder of that name), so that no render is in vain.
void checkWritable(const std::string& path);

} // namespace dirt
