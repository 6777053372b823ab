#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenes/generate/model.h"

namespace dirt::generate {

/// A scene file, named without its extension.
struct SceneFile {
    std::string name;
    std::string text;
};

/// Writes a model's OBJ, MTL and textures, and its scenes, into a folder, which is created.
/// Every file appears whole: it is written under a temporary name, then renamed. Returns the paths.
std::vector<std::filesystem::path> writeModel(const Model& model, const std::string& name,
                                              const std::vector<SceneFile>& scenes,
                                              const std::filesystem::path& directory);

} // namespace dirt::generate
