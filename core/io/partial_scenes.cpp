#include "core/io/partial_scenes.h"

#include <algorithm>
#include <exception>
#include <utility>

namespace dirt {

LoadProgress PartialScenes::after(const LoadProgress& progress) {
    if (!watcher_.show) return progress;
    return [this, progress](size_t done, size_t total) {
        if (progress) progress(done, total);
        if (done < total) offer();
    };
}

void PartialScenes::offer() {
    const std::vector<bool> there(there_.begin(), there_.end());
    const std::ptrdiff_t count = std::count(there.begin(), there.end(), true);
    if (failed_ || count == shown_ || (watcher_.wanted && !watcher_.wanted())) return;
    shown_ = count;
    LoadedScene part;
    try {
        part = make_(there);
    } catch (const std::exception&) { // the load itself will say what is wrong, if it matters
        failed_ = true;
        return;
    }
    if (!part.scene.mesh.triangles.empty()) watcher_.show(std::move(part));
}

} // namespace dirt
