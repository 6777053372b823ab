#pragma once

#include "app/cli/input.h"

#include <string>

namespace dirt {

/// The options, each after a blank, that make the same structure of the same scene again with the
/// backends of \p options: whatever shapes it, said or not.
std::string structureOptions(const Input& input, const CommonOptions& options);

/// A point of \p scene as --eye and --target have it: X,Y,Z in the coordinates of its files.
std::string pointOption(const Scene& scene, glm::vec3 point);

} // namespace dirt
