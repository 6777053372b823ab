#pragma once

#include "core/explain/listing.h"
#include "core/explain/path_account.h"
#include "core/explain/ray_trail.h"

#include <string>
#include <vector>

namespace dirt {

/// A ray of a path with its way through the grid, where there is one.
struct ExplainedRay {
    std::string kind; ///< "primary", "indirect" or "shadow"
    Ray ray;
    std::optional<float> maxT;
    std::optional<RayTrail> trail;
};

/// The rays of an event: that which found its point, and the one to the light.
std::vector<ExplainedRay> raysOf(const PathAccount& account, const EventAccount& event);

/// What an account says that its trails do not: the backend's hit is another than the definition's.
/// Empty where they agree.
std::string disagreement(const EventAccount& event, const ExplainedRay& ray);

// The same things for reading; lines end with a newline.

std::string eventText(const Scene& scene, const PathAccount& account, const EventAccount& event);
/// \p grid: of the ray's trail, where it has one.
std::string rayText(const std::optional<Grid>& grid, const ExplainedRay& ray);
std::string entriesText(const Scene& scene, const Grid& grid,
                        const std::vector<TileEntry>& entries);

/// Words for the results of tests, as text and JSON have them.
const char* word(Tested result);
const char* word(Refusal::Reason reason);

} // namespace dirt
