#pragma once

#include "app/cli/input.h"
#include "app/cli/json_report.h"
#include "core/dump/dump.h"
#include "core/frame/renderer.h"

#include <vector>

namespace dirt {

/// What makes dumped numbers mean something: the settings, the sample and the grid frame.
Json dumpReport(const Input& input, const Backend& backend, const Executor& executor,
                uint32_t sample, const GridFrame& frame);

/// manifest.json: that, the views, and of each file its channels.
Json dumpManifest(const Input& input, const Backend& backend, const Executor& executor,
                  uint32_t sample, const RenderResult& result,
                  const std::vector<DumpedFile>& files);

/// [X, Y, Z].
Json vectorJson(glm::vec3 v);

} // namespace dirt
