#pragma once

#include "core/frame/settings.h"
#include "core/io/load.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace dirt::test {

/// The folder of the small scenes and their pictures.
inline std::filesystem::path goldenFolder() {
    return std::filesystem::path(DIRT_SOURCE_DIR) / "tests" / "golden";
}

/// Names of all scenes there.
inline std::vector<std::string> goldenScenes() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(goldenFolder() / "scenes"))
        if (entry.path().extension() == ".scene") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

/// Small pictures, as the scene's file asks; what a file cannot ask for is in its name's end.
inline RenderSettings goldenSettings(const LoadedScene& loaded, int samples) {
    RenderSettings settings;
    settings.grid.width = 192;
    settings.grid.height = 96;
    settings.grid.mode = loaded.settings.view.value_or(settings.grid.mode);
    settings.bounces = loaded.settings.bounces.value_or(settings.bounces);
    settings.visibility = loaded.settings.visibility.value_or(settings.visibility);
    settings.samples = samples;
    const std::string& name = loaded.scene.name;
    if (name.ends_with("_packed")) settings.shading = Shading::packed;
    if (name.ends_with("_mirrors")) settings.rayType = RayType::specular;
    return settings;
}

} // namespace dirt::test
