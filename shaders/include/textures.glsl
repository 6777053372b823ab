// Textures: core/scene/texture.h and scalar_texture.h. Texels lie one after the other in words, sRGB
// bytes in one word, colours of floats in three, data in one; bilinear weights of the hardware would have 8 bits.

#include "shared/texture_lookup.h"

layout(binding = 12) uniform usamplerBuffer textureTable; // first word, width, height, 1: colours of floats
layout(binding = 13) uniform samplerBuffer decodedBytes;  // sRGB to linear
layout(binding = 14) uniform usamplerBuffer texels0;
#if DIRT_TEXEL_PIECES > 1
layout(binding = 15) uniform usamplerBuffer texels1;
#endif

const uint kNoTexture = 0xffffffffu;

uint texelWord(uint at) {
#if DIRT_TEXEL_PIECES > 1
    if (at >> DIRT_TEXEL_PIECE_BITS != 0u)
        return texelFetch(texels1, int(at & ((1u << DIRT_TEXEL_PIECE_BITS) - 1u))).x;
#endif
    return texelFetch(texels0, int(at)).x;
}

vec3 texelOf(uvec4 entry, int x, int y) {
    uint texel = uint(y) * entry.y + uint(x);
    if (entry.w != 0u) {
        uint at = entry.x + 3u * texel;
        return vec3(uintBitsToFloat(texelWord(at)), uintBitsToFloat(texelWord(at + 1u)),
                    uintBitsToFloat(texelWord(at + 2u)));
    }
    uint bytes = texelWord(entry.x + texel);
    return vec3(texelFetch(decodedBytes, int(bytes & 0xffu)).x,
                texelFetch(decodedBytes, int(bytes >> 8 & 0xffu)).x,
                texelFetch(decodedBytes, int(bytes >> 16 & 0xffu)).x);
}

/// A value of data at uv (v upwards).
float sampleScalar(uint index, vec2 uv) {
    uvec4 entry = texelFetch(textureTable, int(index));
    TexelPair x = texelsAround(uv.x, int(entry.y));
    TexelPair y = texelsAround(-uv.y, int(entry.z));
    uint first = entry.x + uint(y.first) * entry.y, second = entry.x + uint(y.second) * entry.y;
    float upper = blend(uintBitsToFloat(texelWord(first + uint(x.first))),
                        uintBitsToFloat(texelWord(first + uint(x.second))), x.weight);
    float lower = blend(uintBitsToFloat(texelWord(second + uint(x.first))),
                        uintBitsToFloat(texelWord(second + uint(x.second))), x.weight);
    return blend(upper, lower, y.weight);
}

/// ScalarTexture::slopes.
vec2 slopesOf(uint index, vec2 uv) {
    uvec4 entry = texelFetch(textureTable, int(index));
    precise vec2 texel = vec2(0.5) / vec2(entry.yz);
    precise vec2 low = uv - texel, high = uv + texel;
    precise vec2 slopes =
        vec2(sampleScalar(index, vec2(high.x, uv.y)) - sampleScalar(index, vec2(low.x, uv.y)),
             sampleScalar(index, vec2(uv.x, high.y)) - sampleScalar(index, vec2(uv.x, low.y)));
    return slopes;
}

/// Linear Rec.709 at uv (v upwards).
vec3 sampleTexture(uint index, vec2 uv) {
    uvec4 entry = texelFetch(textureTable, int(index));
    TexelPair x = texelsAround(uv.x, int(entry.y));
    TexelPair y = texelsAround(-uv.y, int(entry.z));
    vec3 upper = blend(texelOf(entry, x.first, y.first), texelOf(entry, x.second, y.first), x.weight);
    vec3 lower =
        blend(texelOf(entry, x.first, y.second), texelOf(entry, x.second, y.second), x.weight);
    return blend(upper, lower, y.weight);
}
