#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace dirt {

/// A procedural scene that can be generated.
struct GeneratorInfo {
    std::string name;
    std::string description;
    double defaultDetail; ///< triangles
    double minDetail;
    double maxDetail;
    std::vector<std::string> scenes; ///< scene files over the one model
};

/// All generators, by name.
std::vector<GeneratorInfo> generators();

/// Writes scene files, NAME.obj, NAME.mtl and textures into a folder and returns their paths.
/// `detail` is about the number of triangles wished. The same arguments give the same bytes.
/// Throws std::runtime_error for an unknown name, a detail out of range, or a failure to write.
std::vector<std::filesystem::path> generateScene(const std::string& name, double detail,
                                                 const std::filesystem::path& directory);

} // namespace dirt
