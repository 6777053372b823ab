#pragma once

#include "app/cli/input.h"

#include <cstddef>
#include <functional>
#include <string>

namespace dirt {

/// Files that are read, of how many: models at first, then textures. None of none: it is not known
/// yet.
struct LoadingProgress {
    size_t done = 0, of = 0;
};

/// "loading FILE: 3 of 12 files".
std::string loadingText(const std::string& file, const LoadingProgress& progress);

/// Who looks at a scene while it is loaded.
struct LoadingWatch {
    /// On any thread, one call at a time. What it throws ends the loading.
    LoadProgress progress;
    /// Draws what is there so far, on the thread that waits for all of it, unless \p isOver: then
    /// no one will look at it. What it throws ends the drawing. Empty: nothing is drawn.
    std::function<void(Input part, const std::function<bool()>& isOver)> draw{};
};

/// openInput, beside which parts of the scene are drawn: files are read on other threads, as many
/// as \p options say, and at least twice as long as pictures take. Throws what openInput does.
Input openWatched(const CommonOptions& options, const LoadingWatch& watch);

} // namespace dirt
