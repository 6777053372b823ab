#pragma once

#include "core/explain/explained_ray.h"
#include "core/explain/listing.h"

#include <string>
#include <vector>

namespace dirt {

// What is told of a pixel, for reading; lines end with a newline.

std::string eventText(const Scene& scene, const PathAccount& account, const EventAccount& event);
/// \p grid: of the ray's trail, where it has one.
std::string rayText(const std::optional<Grid>& grid, const ExplainedRay& ray);
/// Its first line alone: what it found, after how much work.
std::string rayLine(const ExplainedRay& ray);
/// "tile (3, 4) of view 1, depths 0.5 .. 2, 8 bins".
std::string tileLine(const Grid& grid, int view, int column, int row);
std::string entriesText(const Scene& scene, const Grid& grid,
                        const std::vector<TileEntry>& entries);

/// Words for the results of tests, as text and JSON have them.
const char* word(Tested result);
const char* word(Refusal::Reason reason);

} // namespace dirt
