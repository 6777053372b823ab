#pragma once

#include "app/cli/input.h"
#include "core/frame/backend.h"

#include <span>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace dirt {

/// JSON object that keeps the order in which its keys were set.
using Json = nlohmann::ordered_json;

Json vectorJson(glm::dvec3 v);

/// What every report says of its run: scene, triangles, settings, backend, threads, the
/// passes of the \p build, and the backend's memory and list entries as they are.
Json reportOf(const Input& input, const Backend& backend, const Executor& executor,
              std::span<const PassTime> build);

} // namespace dirt
