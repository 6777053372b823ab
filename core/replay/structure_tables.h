#pragma once

#include "core/replay/replay_input.h"

namespace dirt {

/// Depth bounds of \p file for the views of \p input, as a grid without lists. \p hasPyramid:
/// whether the levels above the tiles were there; else they are made of the tiles'. Throws
/// InputError where a cell is missing, or is there twice.
Grid readDepth(const std::filesystem::path& file, ReplayInput& input, bool& hasPyramid);

/// The list entries of \p file, sorted. Throws InputError where one is of no tile, bin or triangle
/// that there is.
std::vector<DumpedEntry> readEntries(const std::filesystem::path& file, ReplayInput& input);

/// The lists of \p entries, which are sorted, in \p grid; each entry once.
void fillLists(const std::vector<DumpedEntry>& entries, Grid& grid);

} // namespace dirt
