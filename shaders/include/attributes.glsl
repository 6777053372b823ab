// A triangle's attributes, by primitive id, and what Fetch makes of them: core/path/fetch_surface.h.
// DIRT_NORMALS, DIRT_COLORS, DIRT_TEXTURES, DIRT_BUMPS and the others say what the scene has.

#include "include/frame.glsl"
#include "include/triangles.glsl"
#include "include/materials.glsl"
#include "shared/reflection.h"

#if DIRT_NORMALS
layout(binding = 8) uniform usamplerBuffer normalIndices;
layout(binding = 9) uniform samplerBuffer normals;
#endif
#if DIRT_COLORS
layout(binding = 16) uniform usamplerBuffer colorIndices;
layout(binding = 17) uniform samplerBuffer colors;
#endif

struct Attributes {
    Triangle triangle;
    uint material;
#if DIRT_NORMALS
    bool hasNormals;
    vec3 normals[3]; // world axes
#endif
#if DIRT_TEXTURES
    bool hasTexcoords;
    vec2 texcoords[3];
#endif
#if DIRT_COLORS
    vec3 colors[3];
#endif
};

Attributes attributesOf(uint primitive) {
    Attributes attributes;
    attributes.triangle = triangleOf(primitive);
    attributes.material = texelFetch(materialOf, int(primitive)).x;
#if DIRT_NORMALS
    uvec3 n = texelFetch(normalIndices, int(primitive)).xyz;
    attributes.hasNormals = isPresent(n);
    for (int i = 0; i < 3; ++i)
        attributes.normals[i] =
            attributes.hasNormals ? texelFetch(normals, int(n[i])).xyz : vec3(0.0);
#endif
#if DIRT_TEXTURES
    uvec3 t = texelFetch(texcoordIndices, int(primitive)).xyz;
    attributes.hasTexcoords = isPresent(t);
    for (int i = 0; i < 3; ++i)
        attributes.texcoords[i] =
            attributes.hasTexcoords ? texelFetch(texcoords, int(t[i])).xy : vec2(0.0);
#endif
#if DIRT_COLORS
    uvec3 c = texelFetch(colorIndices, int(primitive)).xyz;
    for (int i = 0; i < 3; ++i) attributes.colors[i] = texelFetch(colors, int(c[i])).xyz;
#endif
    return attributes;
}

#if DIRT_BUMPS || DIRT_NORMAL_MAPS
/// Two edges of a triangle, and how an image's coordinates differ along them.
struct Edges {
    vec3 e, f;
    vec2 de, df;
};

Edges edgesOf(Attributes attributes, uint map) {
    Triangle t = attributes.triangle;
    precise vec3 e = t.b - t.a, f = t.c - t.a;
    precise vec2 de = attributes.texcoords[1] - attributes.texcoords[0];
    precise vec2 df = attributes.texcoords[2] - attributes.texcoords[0];
    return Edges(e, f, imageDifference(map, de), imageDifference(map, df));
}
#endif

#if DIRT_BUMPS
/// A normal, turned by the material's heights.
vec3 bumped(Attributes attributes, uvec4 part, vec2 texcoord, vec3 normal) {
    precise vec2 slopes = slopesOf(part.z, texcoord) * uintBitsToFloat(part.y);
    Edges edges = edgesOf(attributes, part.z);
    return bumpedNormal(normal, edges.e, edges.f, edges.de, edges.df, slopes);
}
#endif

#if DIRT_NORMAL_MAPS
/// A normal, turned by the material's normal map.
vec3 mapped(Attributes attributes, uint map, float scale, vec2 texcoord, vec3 normal) {
    vec3 local = normalOfTexel(sampleTexture(map, texcoord), scale);
    Edges edges = edgesOf(attributes, map);
    return mappedNormal(normal, edges.e, edges.f, edges.de, edges.df, local);
}
#endif

/// fetchSurface: the surface point at (u, v), seen along a direction.
SurfacePoint surfaceAt(Attributes attributes, uint primitive, float u, float v, vec3 direction) {
    Triangle t = attributes.triangle;
    uvec4 parts[kMaterialTexels];
    for (int i = 0; i < kMaterialTexels; ++i) parts[i] = materialTexel(attributes.material, i);
    SurfacePoint point;
    point.primitive = primitive;
    point.u = u;
    point.v = v;
    point.position = interpolate(t.a, t.b, t.c, u, v);
    vec3 outward = triangleNormal(t.a, t.b, t.c);
    point.geometricNormal = facing(outward, -direction);
    point.shadingNormal = point.geometricNormal;
    vec3 normal = outward;
#if DIRT_NORMALS
    if (attributes.hasNormals) {
        normal = directionToGrid(interpolate(attributes.normals[0], attributes.normals[1],
                                             attributes.normals[2], u, v));
        point.shadingNormal = shadingNormalFrom(normal, point.geometricNormal);
    }
#endif
    point.diffuse = uintBitsToFloat(parts[0].xyz);
    point.emission = uintBitsToFloat(parts[1].xyz);
    precise float reflectance = uintBitsToFloat(parts[2].x);
    float roughness = uintBitsToFloat(parts[2].z), metallic = uintBitsToFloat(parts[2].y);
#if DIRT_TEXTURES
    if (attributes.hasTexcoords) {
        vec2 texcoord = interpolate(attributes.texcoords[0], attributes.texcoords[1],
                                    attributes.texcoords[2], u, v);
        if (parts[0].w != kNoTexture) {
            precise vec3 diffuse = sampleTexture(parts[0].w, texcoord);
#if DIRT_TEXTURE_FACTORS
            diffuse = diffuse * uintBitsToFloat(parts[4].xyz);
#endif
            point.diffuse = diffuse;
        }
        if (parts[1].w != kNoTexture) {
            precise vec3 emission = point.emission * sampleTexture(parts[1].w, texcoord);
            point.emission = emission;
        }
        if (parts[2].w != kNoTexture)
            reflectance = reflectance * sampleScalar(parts[2].w, texcoord);
#if DIRT_ROUGHNESS_MAPS
        if (parts[5].y != kNoTexture)
            roughness = mappedRoughness(roughness, sampleScalar(parts[5].y, texcoord));
#endif
#if DIRT_METALLIC_MAPS
        if (parts[5].z != kNoTexture)
            metallic = mappedMetallic(metallic, sampleScalar(parts[5].z, texcoord));
#endif
#if DIRT_NORMAL_MAPS
        if (parts[4].w != kNoTexture) {
            // It stands on the side of the surface's own normal, whichever is seen.
            vec3 base = shadingNormalFrom(normal, normal);
            float scale = uintBitsToFloat(parts[5].x);
            normal = mapped(attributes, parts[4].w, scale, texcoord, base);
            point.shadingNormal = shadingNormalFrom(normal, point.geometricNormal);
        }
#endif
#if DIRT_BUMPS
        if (parts[3].z != kNoTexture) { // never where there is a normal map
            // Heights rise on the side of the surface's own normal, whichever is seen.
            vec3 base = shadingNormalFrom(normal, normal);
            normal = bumped(attributes, parts[3], texcoord, base);
            point.shadingNormal = shadingNormalFrom(normal, point.geometricNormal);
        }
#endif
    }
#endif
#if DIRT_COLORS
    precise vec3 coloured =
        point.diffuse *
        interpolate(attributes.colors[0], attributes.colors[1], attributes.colors[2], u, v);
    point.diffuse = coloured;
#endif
    point.diffuse = boundedReflectance(point.diffuse);
    point.emission = boundedEmission(point.emission);
#if DIRT_METALLIC_MAPS
    if (parts[5].z != kNoTexture) reflectance = metalReflectance(reflectance, metallic);
#endif
    point.roughness = 0.0;
    point.gloss = 0u;
    if (reflectance > 0.0) {
        point.roughness = roughness;
        point.gloss = packGloss(reflectance < 1.0 ? reflectance : 1.0, metallic);
    }
    return point;
}
