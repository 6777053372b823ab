#pragma once

#include "app/cli/dump_options.h"
#include "app/cli/input.h"

namespace dirt {

/// Throws InputError where --pixel leaves other options without effect, or has no file to go to.
void checkPixelOptions(const DumpOptions& options);

/// Writes what the buffers of a dump have of one pixel, and what its rays found on their way, as
/// one JSON object. Returns the exit status.
int dumpPixel(const DumpOptions& options, const Input& input, Backend& backend,
              const Executor& executor);

} // namespace dirt
