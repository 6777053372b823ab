#pragma once

#include "shaders/shared/texture_lookup.h"

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace dirt {

/// What is beyond the image's border: the values of shaders/shared/texture_lookup.h.
enum class Wrap : uint32_t {
    repeat, ///< the image again
    mirror, ///< its mirror image, then the image again
    clamp   ///< the texels of the border
};

/// How a texture is looked up at a mesh's texture coordinates. Both the mesh's and the image's run
/// to the right and *upwards*; the image is [0, 1] x [0, 1], its first row on top.
///
/// A reader whose formats have v run downwards (glTF's KHR_texture_transform) turns that over at
/// both ends: with v_mesh = 1 - v_file, and of the file's image coordinates the same.
struct TextureSampling {
    Wrap wrapU = Wrap::repeat, wrapV = Wrap::repeat;
    /// Whether the rows below count; else they are the identity.
    bool transformed = false;
    /// The image's u is rowU.x u + rowU.y v + rowU.z, its v likewise; finite.
    glm::vec3 rowU{1.0f, 0.0f, 0.0f}, rowV{0.0f, 1.0f, 0.0f};

    bool operator==(const TextureSampling&) const = default;

    /// Where in the image \p uv of a mesh lies.
    glm::vec2 imageCoordinates(glm::vec2 uv) const {
        return transformed ? transformTexcoord(uv, rowU, rowV) : uv;
    }
    /// \p uv, a difference of a mesh's coordinates, as one of the image's.
    glm::vec2 imageDifference(glm::vec2 uv) const {
        return transformed ? transformDifference(uv, rowU, rowV) : uv;
    }
};

} // namespace dirt
