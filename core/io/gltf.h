#pragma once

#include "core/io/gltf_camera.h"
#include "core/io/gltf_data.h"
#include "core/io/gltf_light.h"
#include "core/io/gltf_texture.h"
#include "core/io/load_report.h"
#include "core/io/texture_loader.h"
#include "core/scene/material.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace dirt {

/// What of a glTF 2.0 file matters to a renderer of still surfaces: its triangles, where its nodes
/// place them, its materials, cameras, and a light.
struct GltfFile {
    static constexpr uint32_t kNone = 0xffffffffu;

    /// An image, which is not loaded yet.
    struct Image {
        std::string label;                        ///< its URI, or its place where it is embedded
        std::shared_ptr<const std::string> bytes; ///< of an embedded image file; images share them

        /// As what \p gltf names.
        TextureLoader::Source source(const std::filesystem::path& gltf) const;
    };
    /// A material, whose textures are not loaded yet.
    struct Surface {
        Material material; ///< without textures and microfacets; diffuse is to multiply `colour`
        float metallic, roughness;        ///< that are to multiply metallicRoughness
        float dielectric = 0.04f;         ///< reflectance of what is no metal
        float alphaLimit = 0.0f;          ///< alpha of `colour` below which it is cut out; 0: none
        bool unlit = false;               ///< it emits its base colour
        bool saysOneSided = false;        ///< and is not silent about it
        GltfTextureUse colour;            ///< base colour, and alpha
        GltfTextureUse metallicRoughness; ///< roughness in green, metallic in blue
        GltfTextureUse reflectance;       ///< in alpha, times dielectric
        GltfTextureUse normal;
        GltfTextureUse emission; ///< times the material's
        uint64_t texcoordSet = 0;

        bool hasTexture() const {
            return (colour.image & metallicRoughness.image & reflectance.image & normal.image &
                    emission.image) != kNone;
        }
    };
    /// Triangles of one material.
    struct Primitive {
        std::vector<glm::vec3> positions; ///< finite where a triangle uses them
        std::vector<glm::vec3> normals;   ///< one a position, or none; may hold NaN
        std::vector<glm::vec2> texcoords; ///< one a position, or none; v downwards; may hold NaN
        std::vector<glm::vec3> colors;    ///< linear; one a position, or none; from 0 to 1
        std::vector<std::array<uint32_t, 3>> triangles; ///< into these; in range
        uint32_t surface = kNone;                       ///< kNone: the default material
    };
    /// A mesh, placed by a node.
    struct Instance {
        uint32_t mesh;
        glm::dmat4 toFile;
    };

    std::filesystem::path file;
    std::vector<Image> images;
    std::vector<Surface> surfaces;
    std::vector<std::vector<Primitive>> meshes;
    std::vector<Instance> instances; ///< in the order of the nodes, depth first
    std::vector<GltfCamera> cameras; ///< that nodes place, in the order of the file's `cameras`
    std::optional<GltfSpotlight> spotlight; ///< the first in the order of the nodes
};

/// Reads a glTF 2.0 file, .gltf or .glb, with the buffers it names: what the nodes of its scene
/// place. Members and extensions that are used and have no effect are reported as ignored, each
/// with how often it is there; normals and texture coordinates that are none are warnings, one of
/// each kind. Throws InputError, "file: meshes[3].primitives[0] …", where the file is malformed, a
/// value is of the wrong kind or out of range, an accessor reaches beyond its data, a position that
/// a triangle uses is not finite, geometry lies in an extension that is not known, a node is its
/// own ancestor or has two parents, or there are absurdly many triangles.
///
/// tinygltf is not used here: it takes values of the wrong kind for absent ones, checks no ranges,
/// reads up to eight bytes beyond a .glb whose chunk is too long, and decodes images by itself.
GltfFile readGltf(const std::filesystem::path& file, LoadReport& report);

/// The same; \p memory takes what the result needs, and meanwhile what is needed to read it.
GltfFile readGltf(const std::filesystem::path& file, LoadReport& report, MemoryClaim& memory);

} // namespace dirt
