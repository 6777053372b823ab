#pragma once

#include "core/grid/view.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dirt {

/// A file of a dump that replay reads.
struct ManifestFile {
    std::filesystem::path file;
    std::string buffer;
    std::optional<int> event;
};

/// What manifest.json says of a dump (docs/porting.md has the keys).
struct Manifest {
    std::filesystem::path file;
    GridSettings settings;
    std::optional<float> fov;        ///< vertical, degrees
    std::optional<size_t> triangles; ///< how many there are
    bool cutOuts = false;            ///< hits depend on materials, which a dump does not have
    std::vector<View> views;         ///< empty: the structure has none
    std::vector<std::string> viewNames;
    std::optional<std::vector<uint32_t>> atEye;
    std::vector<ManifestFile> files;
};

/// Reads manifest.json of \p folder. Keys and buffers without effect are added to \p ignored, each
/// once. Throws InputError where something is missing, or is not a grid's.
Manifest readManifest(const std::filesystem::path& folder, std::vector<std::string>& ignored);

} // namespace dirt
