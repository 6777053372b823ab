#pragma once

#include "core/grid/grid.h"
#include "core/replay/manifest.h"
#include "core/trace/ray.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dirt {

/// An entry of a dumped id buffer.
struct DumpedEntry {
    uint32_t view, tile, bin, id;
    auto operator<=>(const DumpedEntry&) const = default;
};

/// Rays of a path event and the hits that an engine found with them, one of each a pixel.
struct DumpedHits {
    int event = 0;
    std::vector<Ray> rays;
    std::vector<Hit> hits;
    bool filed = false; ///< the hits say which tile lists them
};

/// Shadow rays of a path event, one a pixel, and what Visibility answered.
struct DumpedShadows {
    int event = 0;
    std::vector<Ray> rays;
    std::vector<float> tMax;       ///< what is hit before blocks a ray
    std::vector<uint8_t> occluded; ///< 1: something is in between
    /// What is, where the dump says so: of each occluded ray a primitive, of others none. Its t is
    /// not read.
    std::vector<Hit> blockers;
    bool named = false; ///< it says so
    bool filed = false; ///< and which tile lists the blocker
};

/// A dump: its buffers, checked for what would make them no buffers at all, and not judged.
struct ReplayInput {
    Manifest manifest;
    FrameGeometry geometry;
    bool hasPyramid = false; ///< levels above the tiles' bounds were dumped
    bool hasLists = false;
    /// The structure, where depth bounds were dumped: its pyramid is made of them where none was
    /// dumped, its lists hold each entry once, and are empty where none were dumped.
    std::optional<Grid> grid;
    std::vector<DumpedEntry> entries; ///< as dumped, sorted
    std::vector<DumpedHits> events;   ///< in the order of events
    std::vector<DumpedShadows> shadows;
    std::vector<std::string> ignored; ///< what the dump holds and has no effect, each once
};

/// Reads the dump in \p folder. Throws InputError, with file and line or pixel.
ReplayInput readReplay(const std::filesystem::path& folder);

} // namespace dirt
