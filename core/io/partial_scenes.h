#pragma once

#include "core/io/load.h"

#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

namespace dirt {

/// Shows whoever watches a load the models that are there, each time that a further file has been
/// read and something is left to read: what all files give is soon there without it.
class PartialScenes {
public:
    /// The scene of those models that are there.
    using Make = std::function<LoadedScene(const std::vector<bool>& there)>;

    /// \p watcher and \p make are called by what after() returns.
    PartialScenes(const PartialLoad& watcher, size_t models, Make make)
        : watcher_(watcher), make_(std::move(make)), there_(watcher.show ? models : 0) {}

    /// A model may be used from now on; on any thread.
    void add(size_t model) {
        if (!there_.empty()) there_[model] = true;
    }

    /// \p progress, and what is shown after it; this must outlive it.
    LoadProgress after(const LoadProgress& progress);

private:
    void offer();

    const PartialLoad& watcher_;
    const Make make_;
    std::vector<std::atomic<bool>> there_;
    std::ptrdiff_t shown_ = 0; ///< models in the last scene
    bool failed_ = false;
};

} // namespace dirt
