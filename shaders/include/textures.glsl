// Textures: core/scene/texture.h and scalar_texture.h. Texels lie one after the other in words, bytes
// of colours in one word, colours of floats in three, data in one; bilinear weights of the hardware
// would have 8 bits. DIRT_TEXTURE_WRAPS and DIRT_TEXTURE_TRANSFORMS: TextureSampling has some;
// DIRT_LINEAR_BYTES: bytes of some textures are data.

#include "shared/texture_lookup.h"

// Of each texture first word, width, height, and in bits 0: colours of floats, 1: linear bytes,
// 4 and 5: wrap along u, 6 and 7: along v, 8: transformed. With transforms its two rows follow.
layout(binding = 12) uniform usamplerBuffer textureTable;
layout(binding = 13) uniform samplerBuffer decodedBytes; // sRGB to linear; then those that are linear
layout(binding = 14) uniform usamplerBuffer texels0;
#if DIRT_TEXEL_PIECES > 1
layout(binding = 15) uniform usamplerBuffer texels1;
#endif

uint texelWord(uint at) {
#if DIRT_TEXEL_PIECES > 1
    if (at >> DIRT_TEXEL_PIECE_BITS != 0u)
        return texelFetch(texels1, int(at & ((1u << DIRT_TEXEL_PIECE_BITS) - 1u))).x;
#endif
    return texelFetch(texels0, int(at)).x;
}

#if DIRT_TEXTURE_TRANSFORMS
const int kTableTexels = 3;
#else
const int kTableTexels = 1;
#endif

uvec4 textureEntry(uint index) {
    return texelFetch(textureTable, int(index) * kTableTexels);
}

#if DIRT_TEXTURE_TRANSFORMS
vec3 transformRow(uint index, int row) {
    return uintBitsToFloat(texelFetch(textureTable, int(index) * kTableTexels + 1 + row).xyz);
}
#endif

/// TextureSampling::imageCoordinates.
vec2 imageCoordinates(uint index, uvec4 entry, vec2 uv) {
#if DIRT_TEXTURE_TRANSFORMS
    if ((entry.w & 0x100u) != 0u)
        return transformTexcoord(uv, transformRow(index, 0), transformRow(index, 1));
#endif
    return uv;
}

/// TextureSampling::imageDifference.
vec2 imageDifference(uint index, vec2 uv) {
#if DIRT_TEXTURE_TRANSFORMS
    if ((textureEntry(index).w & 0x100u) != 0u)
        return transformDifference(uv, transformRow(index, 0), transformRow(index, 1));
#endif
    return uv;
}

TexelPair columnsOf(uvec4 entry, float u) {
#if DIRT_TEXTURE_WRAPS
    return columnsAround(u, int(entry.y), entry.w >> 4u & 3u);
#else
    return texelsAround(u, int(entry.y));
#endif
}

TexelPair rowsOf(uvec4 entry, float v) {
#if DIRT_TEXTURE_WRAPS
    return rowsAround(v, int(entry.z), entry.w >> 6u & 3u);
#else
    return texelsAround(-v, int(entry.z));
#endif
}

vec3 texelOf(uvec4 entry, int x, int y) {
    uint texel = uint(y) * entry.y + uint(x);
    if ((entry.w & 1u) != 0u) {
        uint at = entry.x + 3u * texel;
        return vec3(uintBitsToFloat(texelWord(at)), uintBitsToFloat(texelWord(at + 1u)),
                    uintBitsToFloat(texelWord(at + 2u)));
    }
    uint bytes = texelWord(entry.x + texel);
#if DIRT_LINEAR_BYTES
    uint table = (entry.w & 2u) << 7u; // 256 where bytes are linear
#else
    const uint table = 0u;
#endif
    return vec3(texelFetch(decodedBytes, int(table + (bytes & 0xffu))).x,
                texelFetch(decodedBytes, int(table + (bytes >> 8 & 0xffu))).x,
                texelFetch(decodedBytes, int(table + (bytes >> 16 & 0xffu))).x);
}

/// A value of data at uv of its image (v upwards).
float scalarOf(uvec4 entry, vec2 uv) {
    TexelPair x = columnsOf(entry, uv.x);
    TexelPair y = rowsOf(entry, uv.y);
    uint first = entry.x + uint(y.first) * entry.y, second = entry.x + uint(y.second) * entry.y;
    float upper = blend(uintBitsToFloat(texelWord(first + uint(x.first))),
                        uintBitsToFloat(texelWord(first + uint(x.second))), x.weight);
    float lower = blend(uintBitsToFloat(texelWord(second + uint(x.first))),
                        uintBitsToFloat(texelWord(second + uint(x.second))), x.weight);
    return blend(upper, lower, y.weight);
}

/// A value of data at uv of a mesh (v upwards).
float sampleScalar(uint index, vec2 uv) {
    uvec4 entry = textureEntry(index);
    return scalarOf(entry, imageCoordinates(index, entry, uv));
}

/// ScalarTexture::slopes.
vec2 slopesOf(uint index, vec2 uv) {
    uvec4 entry = textureEntry(index);
    precise vec2 at = imageCoordinates(index, entry, uv);
    precise vec2 texel = vec2(0.5) / vec2(entry.yz);
    precise vec2 low = at - texel, high = at + texel;
    precise vec2 slopes =
        vec2(scalarOf(entry, vec2(high.x, at.y)) - scalarOf(entry, vec2(low.x, at.y)),
             scalarOf(entry, vec2(at.x, high.y)) - scalarOf(entry, vec2(at.x, low.y)));
    return slopes;
}

/// Linear Rec.709, or data, at uv of a mesh (v upwards).
vec3 sampleTexture(uint index, vec2 uv) {
    uvec4 entry = textureEntry(index);
    vec2 at = imageCoordinates(index, entry, uv);
    TexelPair x = columnsOf(entry, at.x);
    TexelPair y = rowsOf(entry, at.y);
    vec3 upper = blend(texelOf(entry, x.first, y.first), texelOf(entry, x.second, y.first), x.weight);
    vec3 lower =
        blend(texelOf(entry, x.first, y.second), texelOf(entry, x.second, y.second), x.weight);
    return blend(upper, lower, y.weight);
}
