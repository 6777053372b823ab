#pragma once

#include "core/frame/settings.h"
#include "core/scene/scene.h"

#include <string>
#include <vector>

namespace dirt {

/// What a scene and the choices made for it require of a frame. Which buffers there are follows
/// from this and from nothing else. Emission, background, textures and normals choose between
/// shaders; the passes on the host look at the scene itself.
struct Requirements {
    bool light = false;               ///< a spotlight
    bool shadowRays = false;          ///< whether it is seen is traced: visibility
    uint32_t shadowMap = 0;           ///< texels along a side of its shadow map; 0: it has none
    bool openLight = false;           ///< the light casts no shadows: it needs neither
    bool emission = false;            ///< surfaces that shine
    bool background = false;          ///< radiance where nothing is hit
    bool diffuseTextures = false;     ///< reflectance from a map_Kd
    bool emissionTextures = false;    ///< radiance from a map_Ke
    bool gloss = false;               ///< microfacets: the direction to the viewer matters
    bool reflectanceTextures = false; ///< reflectance of microfacets from a map_Ks
    bool roughnessTextures = false;   ///< their width from a texture
    bool metallicTextures = false;    ///< what of them is a metal's from a texture
    bool bumps = false;               ///< normals from heights
    bool normalMaps = false;          ///< normals from a texture
    bool textureFactors = false;      ///< reflectance from a map_Kd times a factor
    bool textureTransforms = false;   ///< textures with coordinates of their own
    bool textureWraps = false;        ///< textures that do not repeat
    bool vertexColors = false;        ///< reflectance times the vertices' colours
    bool cutOuts = false;             ///< surfaces with holes or one side: candidates are looked up
    bool shadingNormals = false;      ///< interpolated normals
    bool indirect = false;            ///< more than direct light: rays, hits, mask, G[k]
    bool lens = false;                ///< an aperture: primary rays differ by where they pass it
    bool tracedPrimary = false;       ///< rays and hits for the first surface, too
    bool packedShading = false;       ///< surface points are rounded to 32 bytes at most
    bool previousPoint = false;       ///< G[k-1]: for inspection alone, as the rays say from where
                                      ///< their hit is seen

    /// Whether normals for shading are not the triangles' own.
    bool hasShadingNormals() const { return shadingNormals || bumps || normalMaps; }
};

/// \p rasterizes says whether the backend can rasterize direct visibility.
Requirements requirementsOf(const Scene& scene, const RenderSettings& settings, bool rasterizes);

/// One line of the explanation of a set of requirements.
struct RequirementReason {
    std::string name;
    bool required;
    std::string reason; ///< why, or why not
};

/// Every requirement, and what in the scene or the settings decides it.
std::vector<RequirementReason> explain(const Requirements& requirements, const Scene& scene,
                                       const RenderSettings& settings, bool rasterizes);

} // namespace dirt
