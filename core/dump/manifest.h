#pragma once

#include "core/io/memory_budget.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dirt {

/// The buffers that a dump can hold, in the order in which they come about.
const std::vector<std::string>& dumpBuffers();

/// The name of the file that holds one of them, of a path event where it has several.
std::string dumpFileName(const std::string& buffer, std::optional<int> event);

/// The lists of "ids" as text, beside that file.
inline constexpr const char* kIdsAsText = "ids.csv";

/// Whether \p file, which is there, is the manifest of a dump, so that another may replace it:
/// other programs' files have that name, too. All files that it lists have to be such as a dump
/// writes. Throws InputError where the file cannot be read or \p memory does not suffice.
bool isDumpManifest(const std::filesystem::path& file, MemoryClaim& memory);

} // namespace dirt
