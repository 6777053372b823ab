#pragma once

#include "core/scene/animation.h"
#include "core/scene/camera.h"
#include "core/scene/light.h"
#include "core/scene/material.h"
#include "core/scene/scalar_texture.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace dirt {

/// "No such attribute" in the index arrays of a Mesh.
inline constexpr uint32_t kNoIndex = 0xffffffffu;

/// Corner indices of one triangle into one of a Mesh's attribute arrays.
using Corners = std::array<uint32_t, 3>;

/// All triangles of a scene, in world space; what moves, as it is in the frame at hand. A
/// triangle's index is its primitive id: ids count through objects in file order, then faces, then
/// the ear-clipped triangles of a face.
struct Mesh {
    std::vector<glm::vec3> positions; ///< world space; static transforms already applied
    std::vector<glm::vec3> normals;   ///< unit length, world space; may be empty
    std::vector<glm::vec2> texcoords; ///< OBJ convention: v runs upwards; may be empty
    /// Linear Rec.709, one a position or empty; what reflects diffusely is multiplied by them.
    std::vector<glm::vec3> colors;

    std::vector<Corners> triangles;       ///< into positions
    std::vector<Corners> normalIndices;   ///< into normals or kNoIndex; same length as triangles
    std::vector<Corners> texcoordIndices; ///< into texcoords or kNoIndex; same length as triangles
    std::vector<uint32_t> materials;      ///< per triangle, into Scene::materials
};

/// Of all glossy surfaces of a scene; the values of shaders/shared/microfacet.h.
enum class MicrofacetModel : uint32_t { beckmann, ggx, cooktorrance, phong };

/// What a renderer needs of one scene.
struct Scene {
    std::string name; ///< file name without folder and extension
    /// Where 0 is, in the coordinates of the files: it was taken off all points here, the camera's
    /// and the light's too, before they were rounded to float32. Zero but for scenes that are far
    /// from 0 (see core/scene/origin.h).
    glm::dvec3 origin{0.0};
    Mesh mesh;
    std::vector<Material> materials; ///< never empty
    std::vector<Texture> textures;
    std::vector<ScalarTexture> scalarTextures;
    MicrofacetModel microfacetModel = MicrofacetModel::beckmann;
    std::vector<Spotlight> lights; ///< none or one
    Camera camera;
    glm::vec3 background{0.0f}; ///< radiance of rays that miss
    ToneMapping toneMapping;
    Animation animation; ///< moveScene brings mesh and camera to a frame

    /// A point of the scene in the coordinates of its files.
    glm::dvec3 inFiles(glm::vec3 point) const { return origin + glm::dvec3(point); }
    /// A point of the files in the scene, rounded once.
    glm::vec3 fromFiles(const glm::dvec3& point) const { return glm::vec3(point - origin); }
};

} // namespace dirt
