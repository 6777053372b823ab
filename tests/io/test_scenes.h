#pragma once

#include <cstdlib>
#include <filesystem>

namespace dirt {

/// Folder of the real scenes: $DIRT_SCENES, else ../shared/scenes beside the repository. It need
/// not be there.
inline std::filesystem::path scenesFolder() {
    if (const char* folder = std::getenv("DIRT_SCENES")) return folder;
    return std::filesystem::path(DIRT_SOURCE_DIR) / "../shared/scenes";
}

/// Folder of other programs' models: $DIRT_MODELS, else ../shared/models beside the repository. It
/// need not be there.
inline std::filesystem::path modelsFolder() {
    if (const char* folder = std::getenv("DIRT_MODELS")) return folder;
    return std::filesystem::path(DIRT_SOURCE_DIR) / "../shared/models";
}

/// Folder of the 2017 demo's scene and material files: $DIRT_DEMO2017, else ../shared/demo2017
/// beside the repository. It need not be there.
inline std::filesystem::path demoFolder() {
    if (const char* folder = std::getenv("DIRT_DEMO2017")) return folder;
    return std::filesystem::path(DIRT_SOURCE_DIR) / "../shared/demo2017";
}

} // namespace dirt
