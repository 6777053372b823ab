// The surface points of the path state, G[k] and G[k+1]: in full; or packed (DIRT_POINT_WORDS of a
// point), without the words that the scene has no need of (core/frame/point_buffer.h).

#include "include/paths.glsl"
#include "include/triangles.glsl"
#include "shared/packed_point.h"

#ifndef DIRT_POINT_WORDS

SurfacePoint currentPoint(uint i) {
    return current[i];
}
SurfacePoint nextPoint(uint i) {
    return next[i];
}
bool foundCurrent(uint i) {
    return current[i].primitive != kNoPrimitive;
}
bool foundNext(uint i) {
    return next[i].primitive != kNoPrimitive;
}
vec3 currentDiffuse(uint i) {
    return current[i].diffuse;
}
uint currentGloss(uint i) {
    return current[i].gloss;
}
vec3 nextEmission(uint i) {
    return next[i].emission;
}
void clearCurrent(uint i) {
    current[i] = kNoPoint;
}
void clearNext(uint i) {
    next[i] = kNoPoint;
}
void setNext(uint i, SurfacePoint point) {
    next[i] = point;
}

#else

layout(std430, binding = 2) buffer CurrentBlock {
    uint current[]; // G[k]
};
layout(std430, binding = 3) buffer NextBlock {
    uint next[]; // G[k+1]
};

PackedPoint recordOf(uint words[DIRT_POINT_WORDS]) {
    PackedPoint record = PackedPoint(words[0], words[1], words[2], words[3], words[4],
                                     kNormalOfTriangle, 0u, 0u);
#ifdef DIRT_POINT_NORMAL
    record.normal = words[DIRT_POINT_NORMAL];
#endif
#ifdef DIRT_POINT_EMISSION
    record.emission = words[DIRT_POINT_EMISSION];
#endif
#ifdef DIRT_POINT_GLOSS
    record.gloss = words[DIRT_POINT_GLOSS];
#endif
    return record;
}

uint[DIRT_POINT_WORDS] wordsOf(PackedPoint record) {
    uint words[DIRT_POINT_WORDS];
    words[0] = record.primitive;
    words[1] = record.u;
    words[2] = record.v;
    words[3] = record.diffuse;
    words[4] = record.roughness;
#ifdef DIRT_POINT_NORMAL
    words[DIRT_POINT_NORMAL] = record.normal;
#endif
#ifdef DIRT_POINT_EMISSION
    words[DIRT_POINT_EMISSION] = record.emission;
#endif
#ifdef DIRT_POINT_GLOSS
    words[DIRT_POINT_GLOSS] = record.gloss;
#endif
    return words;
}

PackedPoint packedCurrent(uint i) {
    uint words[DIRT_POINT_WORDS];
    for (uint k = 0u; k < DIRT_POINT_WORDS; ++k) words[k] = current[i * DIRT_POINT_WORDS + k];
    return recordOf(words);
}
PackedPoint packedNext(uint i) {
    uint words[DIRT_POINT_WORDS];
    for (uint k = 0u; k < DIRT_POINT_WORDS; ++k) words[k] = next[i * DIRT_POINT_WORDS + k];
    return recordOf(words);
}

const PackedPoint kNothing =
    PackedPoint(kNoPrimitive, 0u, 0u, 0u, 0u, kNormalOfTriangle, 0u, 0u);

void setCurrentWords(uint i, PackedPoint record) {
    uint words[DIRT_POINT_WORDS] = wordsOf(record);
    for (uint k = 0u; k < DIRT_POINT_WORDS; ++k) current[i * DIRT_POINT_WORDS + k] = words[k];
}
void setNextWords(uint i, PackedPoint record) {
    uint words[DIRT_POINT_WORDS] = wordsOf(record);
    for (uint k = 0u; k < DIRT_POINT_WORDS; ++k) next[i * DIRT_POINT_WORDS + k] = words[k];
}

SurfacePoint unpacked(PackedPoint record) {
    if (record.primitive == kNoPrimitive) return kNoPoint;
    Triangle t = triangleOf(record.primitive);
    return unpackPoint(record, t.a, t.b, t.c);
}

SurfacePoint currentPoint(uint i) {
    return unpacked(packedCurrent(i));
}
SurfacePoint nextPoint(uint i) {
    return unpacked(packedNext(i));
}
bool foundCurrent(uint i) {
    return current[i * DIRT_POINT_WORDS] != kNoPrimitive;
}
bool foundNext(uint i) {
    return next[i * DIRT_POINT_WORDS] != kNoPrimitive;
}
vec3 currentDiffuse(uint i) {
    return diffuseOf(packedCurrent(i));
}
uint currentGloss(uint i) {
    return packedCurrent(i).gloss;
}
vec3 nextEmission(uint i) {
    return emissionOf(packedNext(i));
}
void clearCurrent(uint i) {
    setCurrentWords(i, kNothing);
}
void clearNext(uint i) {
    setNextWords(i, kNothing);
}
void setNext(uint i, SurfacePoint point) {
    Triangle t = triangleOf(point.primitive);
    setNextWords(i, packPoint(point, t.a, t.b, t.c));
}

#endif
