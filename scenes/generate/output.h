#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenes/generate/model.h"

namespace dirt::generate {

/// Writes a model's OBJ, MTL and textures, and its scene text, into a folder, which is created.
/// Every file appears whole: it is written under a temporary name, then renamed. Returns the paths.
std::vector<std::filesystem::path> writeModel(const Model& model, const std::string& name,
                                              const std::string& sceneText,
                                              const std::filesystem::path& directory);

} // namespace dirt::generate
