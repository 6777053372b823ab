#pragma once

#include <string>

namespace dirt::generate {

/// The scene file of a generated model, naming the OBJ by `modelPath`. One text serves the files
/// in the repository and the ones that are generated. Throws std::runtime_error for unknown names.
std::string sceneText(const std::string& name, const std::string& modelPath);

} // namespace dirt::generate
