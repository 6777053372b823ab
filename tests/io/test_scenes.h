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

/// Folder of the 2017 demo's scene and material files, beside that of the scenes.
inline std::filesystem::path demoFolder() {
    return scenesFolder() / "../demo2017";
}

} // namespace dirt
