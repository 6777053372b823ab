#pragma once

#include "app/cli/explain_text.h"
#include "app/cli/json_report.h"

namespace dirt {

/// What explain_text.h says, as JSON.
Json eventJson(const EventAccount& event, const std::vector<ExplainedRay>& rays);
Json rayJson(const ExplainedRay& ray);
Json hitJson(const Hit& hit);
Json entriesJson(const std::vector<TileEntry>& entries);

} // namespace dirt
