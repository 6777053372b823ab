// A triangle's attributes, by primitive id, and what Fetch makes of them: core/path/surface.h.
// DIRT_NORMALS, DIRT_TEXTURES and DIRT_GLOSS say what the scene has.

#include "include/frame.glsl"
#include "include/triangles.glsl"
#include "shared/layouts.h"
#include "shared/reflection.h"
#include "shared/surface.h"
#if DIRT_TEXTURES
#include "include/textures.glsl"
#endif

layout(binding = 6) uniform usamplerBuffer materialOf;
layout(binding = 7) uniform usamplerBuffer materials; // (Kd, map), (Ke, 0), (Ks, metallic,
                                                      // roughness, 0) as bits
#if DIRT_NORMALS
layout(binding = 8) uniform usamplerBuffer normalIndices;
layout(binding = 9) uniform samplerBuffer normals;
#endif
#if DIRT_TEXTURES
layout(binding = 10) uniform usamplerBuffer texcoordIndices;
layout(binding = 11) uniform samplerBuffer texcoords;
#endif

const uint kNoIndex = 0xffffffffu;

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
};

bool present(uvec3 corners) {
    return all(notEqual(corners, uvec3(kNoIndex)));
}

Attributes attributesOf(uint primitive) {
    Attributes attributes;
    attributes.triangle = triangleOf(primitive);
    attributes.material = texelFetch(materialOf, int(primitive)).x;
#if DIRT_NORMALS
    uvec3 n = texelFetch(normalIndices, int(primitive)).xyz;
    attributes.hasNormals = present(n);
    for (int i = 0; i < 3; ++i)
        attributes.normals[i] =
            attributes.hasNormals ? texelFetch(normals, int(n[i])).xyz : vec3(0.0);
#endif
#if DIRT_TEXTURES
    uvec3 t = texelFetch(texcoordIndices, int(primitive)).xyz;
    attributes.hasTexcoords = present(t);
    for (int i = 0; i < 3; ++i)
        attributes.texcoords[i] =
            attributes.hasTexcoords ? texelFetch(texcoords, int(t[i])).xy : vec2(0.0);
#endif
    return attributes;
}

vec3 shadingNormal(Attributes attributes, vec3 geometric, float u, float v) {
#if DIRT_NORMALS
    if (attributes.hasNormals) {
        vec3 normal = interpolate(attributes.normals[0], attributes.normals[1],
                                  attributes.normals[2], u, v);
        return shadingNormalFrom(directionToGrid(normal), geometric);
    }
#endif
    return geometric;
}

vec3 diffuseReflectance(Attributes attributes, float u, float v) {
    uvec4 material = texelFetch(materials, int(attributes.material) * 3);
#if DIRT_TEXTURES
    if (material.w != kNoTexture && attributes.hasTexcoords)
        return sampleTexture(material.w, interpolate(attributes.texcoords[0],
                                                     attributes.texcoords[1],
                                                     attributes.texcoords[2], u, v));
#endif
    return uintBitsToFloat(material.xyz);
}

/// fetchSurface: the surface point at (u, v), seen along a direction.
SurfacePoint surfaceAt(Attributes attributes, uint primitive, float u, float v, vec3 direction) {
    Triangle t = attributes.triangle;
    SurfacePoint point = SurfacePoint(vec3(0.0), primitive, vec3(0.0), u, vec3(0.0), v, vec3(0.0),
                                      0.0, vec3(0.0), 0u);
    point.position = interpolate(t.a, t.b, t.c, u, v);
    point.geometricNormal = facing(triangleNormal(t.a, t.b, t.c), -direction);
    point.shadingNormal = shadingNormal(attributes, point.geometricNormal, u, v);
    point.diffuse = diffuseReflectance(attributes, u, v);
#if DIRT_EMISSION
    point.emission = uintBitsToFloat(texelFetch(materials, int(attributes.material) * 3 + 1).xyz);
#endif
#if DIRT_GLOSS
    vec3 gloss =
        uintBitsToFloat(texelFetch(materials, int(attributes.material) * 3 + 2).xyz);
    if (gloss.x > 0.0) {
        point.roughness = gloss.z;
        point.gloss = packGloss(gloss.x, gloss.y);
    }
#endif
    return point;
}
