#pragma once

#include "core/io/gltf_data.h"
#include "core/io/gltf_members.h"
#include "core/scene/light.h"

#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

namespace dirt {

/// A spotlight of KHR_lights_punctual that a node of a glTF file places.
struct GltfSpotlight {
    glm::vec3 color{1.0f};  ///< linear
    double intensity = 1.0; ///< candela, taken as power per solid angle
    double inner = 0.0;     ///< angles from the axis, radians
    double outer = 0.0;
    glm::dmat4 toFile{1.0}; ///< shines along -Z

    /// As it stands after \p toWorld, which, like all scales, does not change its intensity. Throws
    /// InputError of \p file where it has no place, no direction, or no power in float32.
    Spotlight placed(const glm::dmat4& toWorld, const std::filesystem::path& file) const;
};

/// The lights of the file, by the numbers that nodes give, and which of them shines.
class GltfLights {
public:
    GltfLights(const GltfData& data, GltfIgnored& ignored);

    /// Takes note of the light of a node that is visible: of the first spotlight there is, or else
    /// of one more that is ignored.
    void place(const JsonValue& node, const glm::dmat4& toFile);

    const std::optional<GltfSpotlight>& spotlight() const { return spotlight_; }

private:
    std::vector<JsonValue> lights_;
    GltfIgnored& ignored_;
    std::optional<GltfSpotlight> spotlight_;
};

} // namespace dirt
