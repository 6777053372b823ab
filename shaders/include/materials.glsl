// Materials, and texture coordinates by primitive id.

#include "shared/surface.h"

layout(binding = 6) uniform usamplerBuffer materialOf;
layout(binding = 7) uniform usamplerBuffer materials; // four texels each, as bits:
// (Kd, its map), (Ke, its map), (reflectance, metallic, roughness, reflectance's map),
// (opacity, negative of surfaces with one side, scale of heights, map of heights, opacity's map);
// where the scene has some: (factor of Kd's map, normal map), (normal map's scale, map of roughness,
// of metallic, 0)

#if DIRT_TEXTURE_FACTORS || DIRT_NORMAL_MAPS || DIRT_ROUGHNESS_MAPS || DIRT_METALLIC_MAPS
const int kMaterialTexels = 6;
#else
const int kMaterialTexels = 4;
#endif

const uint kNoTexture = 0xffffffffu;

#if DIRT_TEXTURES
#include "include/textures.glsl"

layout(binding = 10) uniform usamplerBuffer texcoordIndices;
layout(binding = 11) uniform samplerBuffer texcoords;
#endif

const uint kNoIndex = 0xffffffffu;

uvec4 materialTexel(uint material, int part) {
    return texelFetch(materials, int(material) * kMaterialTexels + part);
}

bool isPresent(uvec3 corners) {
    return all(notEqual(corners, uvec3(kNoIndex)));
}

/// Whether a primitive is there for rays that meet its front alone.
bool hasOneSide(uint primitive) {
    return (materialTexel(texelFetch(materialOf, int(primitive)).x, 3).x & 0x80000000u) != 0u;
}

/// isThere of core/scene/cut_outs.h: whether a point of a primitive is not cut out.
bool isThere(uint primitive, float u, float v) {
    uvec4 part = materialTexel(texelFetch(materialOf, int(primitive)).x, 3);
    precise float opacity = abs(uintBitsToFloat(part.x));
#if DIRT_TEXTURES
    if (part.w != kNoTexture) {
        uvec3 t = texelFetch(texcoordIndices, int(primitive)).xyz;
        if (isPresent(t)) {
            vec2 a = texelFetch(texcoords, int(t.x)).xy, b = texelFetch(texcoords, int(t.y)).xy;
            vec2 c = texelFetch(texcoords, int(t.z)).xy;
            opacity = opacity * sampleScalar(part.w, interpolate(a, b, c, u, v));
        }
    }
#endif
    return opacity >= 0.5;
}
