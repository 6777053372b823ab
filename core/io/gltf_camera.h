#pragma once

#include "core/io/gltf_data.h"
#include "core/scene/camera.h"

#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

namespace dirt {

/// A camera that a node of a glTF file places.
struct GltfCamera {
    std::string name;                 ///< the node's, else the camera's; printable
    size_t index = 0;                 ///< in the file's `cameras`
    double verticalFov = 0.0;         ///< degrees
    std::optional<double> halfHeight; ///< of what it shows, where it is orthographic
    glm::dmat4 toFile{1.0};           ///< looks along -Z, up is +Y

    /// As it stands after \p toWorld: eye, direction and field of view. Throws InputError of
    /// \p file where it has no place or no direction.
    Camera placed(const glm::dmat4& toWorld, const std::filesystem::path& file) const;
};

/// The file's cameras, which are not placed yet. Throws InputError where a field of view is no
/// angle between 0 and 180 degrees.
std::vector<GltfCamera> gltfCameras(const GltfData& data);

} // namespace dirt
