#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace dirt {

/// The regular file that \p name, as written in a scene or material file, means below \p folder:
/// backslashes separate folders too, and where a part of the name is not there, one that differs
/// in the case of ASCII letters is taken (the first in byte order). Nothing where there is none. The
/// name is noted as one of an input.
std::optional<std::filesystem::path> findFile(const std::filesystem::path& folder,
                                              std::string_view name);

/// Notes the file that \p name means there as an input, whether it is read or not.
void noteNamedFile(const std::filesystem::path& folder, std::string_view name);

} // namespace dirt
