#pragma once

#include "core/io/gltf_data.h"
#include "core/io/gltf_members.h"
#include "core/scene/texture_sampling.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace dirt {

/// How a material uses an image of a glTF file.
struct GltfTextureUse {
    static constexpr uint32_t kNone = 0xffffffffu;

    uint32_t image = kNone; ///< into the file's images
    TextureSampling sampling;

    bool isThere() const { return image != kNone; }
};

/// Reads what materials say of textures: image, sampler, transform, and the set of texture
/// coordinates, of which one counts for each material.
class GltfTextures {
public:
    GltfTextures(const GltfData& data, size_t images, GltfIgnored& ignored);

    /// The texture that \p owner, a part of a material, names; none where it names none, or one
    /// whose image only an extension has. The first that there is sets the material's \p set; what
    /// wants another is ignored. Throws InputError where something is malformed or not there.
    GltfTextureUse use(const JsonValue& owner, const char* name, std::optional<uint64_t>& set);

private:
    Wrap wrap(const JsonValue& sampler, const char* name);
    TextureSampling samplingOf(const JsonValue& reference, const JsonValue& texture);

    size_t images_;
    std::vector<JsonValue> textures_, samplers_;
    GltfIgnored& ignored_;
};

} // namespace dirt
