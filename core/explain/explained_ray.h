#pragma once

#include "core/explain/path_account.h"
#include "core/explain/ray_trail.h"

#include <optional>
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

} // namespace dirt
