#pragma once

#include "core/io/gltf_data.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dirt {

/// Geometry of a primitive that KHR_draco_mesh_compression held.
struct DracoMesh {
    std::vector<uint32_t> corners; ///< three a triangle
    /// By the names of glTF: components a vertex, and all values.
    std::map<std::string, std::pair<size_t, std::vector<float>>> attributes;

    /// The first \p components of each vertex; nothing where the attribute was not compressed.
    std::optional<std::vector<float>> values(const std::string& name, size_t components) const;
};

/// What of \p primitive is compressed; nothing where none is, or where this program was built
/// without Draco. Throws InputError where it cannot be read.
std::optional<DracoMesh> readDraco(const GltfData& data, const JsonValue& primitive);

} // namespace dirt
