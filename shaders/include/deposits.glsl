// What a rasterized triangle leaves with the hit records that name it.

#include "include/attributes.glsl"
#include "include/hit_groups.glsl"

layout(std430, binding = 9) buffer DepositsBlock {
    uint deposits[]; // of each group: attributes as bits, DIRT_DEPOSIT words
};

const uint kHasNormals = 0x80000000u, kHasTexcoords = 0x40000000u;

/// Leaves a triangle's attributes with the records of a group.
void deposit(uint group, Attributes attributes) {
    atomicAdd(fetches[group], 1u);
    uint at = group * DIRT_DEPOSIT;
    vec3 corners[3] = vec3[3](attributes.triangle.a, attributes.triangle.b, attributes.triangle.c);
    for (uint k = 0u; k < 9u; ++k) deposits[at + k] = floatBitsToUint(corners[k / 3u][k % 3u]);
    uint material = attributes.material;
    uint end = at + 10u;
#if DIRT_NORMALS
    if (attributes.hasNormals) material |= kHasNormals;
    for (uint k = 0u; k < 9u; ++k)
        deposits[end + k] = floatBitsToUint(attributes.normals[k / 3u][k % 3u]);
    end += 9u;
#endif
#if DIRT_TEXTURES
    if (attributes.hasTexcoords) material |= kHasTexcoords;
    for (uint k = 0u; k < 6u; ++k)
        deposits[end + k] = floatBitsToUint(attributes.texcoords[k / 2u][k % 2u]);
    end += 6u;
#endif
#if DIRT_COLORS
    for (uint k = 0u; k < 9u; ++k)
        deposits[end + k] = floatBitsToUint(attributes.colors[k / 3u][k % 3u]);
#endif
    deposits[at + 9u] = material;
}

/// What has been left with a group.
Attributes deposited(uint group) {
    uint at = group * DIRT_DEPOSIT;
    vec3 corners[3];
    for (uint k = 0u; k < 9u; ++k) corners[k / 3u][k % 3u] = uintBitsToFloat(deposits[at + k]);
    Attributes attributes;
    attributes.triangle = Triangle(corners[0], corners[1], corners[2]);
    uint material = deposits[at + 9u];
    attributes.material = material & ~(kHasNormals | kHasTexcoords);
    uint end = at + 10u;
#if DIRT_NORMALS
    attributes.hasNormals = (material & kHasNormals) != 0u;
    for (uint k = 0u; k < 9u; ++k)
        attributes.normals[k / 3u][k % 3u] = uintBitsToFloat(deposits[end + k]);
    end += 9u;
#endif
#if DIRT_TEXTURES
    attributes.hasTexcoords = (material & kHasTexcoords) != 0u;
    for (uint k = 0u; k < 6u; ++k)
        attributes.texcoords[k / 2u][k % 2u] = uintBitsToFloat(deposits[end + k]);
    end += 6u;
#endif
#if DIRT_COLORS
    for (uint k = 0u; k < 9u; ++k)
        attributes.colors[k / 3u][k % 3u] = uintBitsToFloat(deposits[end + k]);
#endif
    return attributes;
}
