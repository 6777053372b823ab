#pragma once

#include "app/cli/input.h"
#include "core/frame/backend.h"

#include <nlohmann/json.hpp>

namespace dirt {

/// JSON object that keeps the order in which its keys were set.
using Json = nlohmann::ordered_json;

/// What every report says of its run: scene, triangles, settings, backend, threads and, of the
/// backend's last build, the passes, the memory and the list entries.
Json reportOf(const Input& input, const Backend& backend, const Executor& executor);

} // namespace dirt
