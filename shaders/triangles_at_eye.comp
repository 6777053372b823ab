#version 450 core
// FillPrimitives: the triangles that hold the eye, which is in no tile (holdsEye of
// core/grid/grid.h).

#include "include/exact_sum.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Triangles {
    float coordinates[];
};
layout(std430, binding = 1) buffer AtEye {
    uint found; // may exceed the length of the list
    uint ids[];
};
layout(location = 0) uniform uint count;
layout(location = 1) uniform uint firstId;

dvec3 crossProduct(dvec3 a, dvec3 b) {
    precise dvec3 n = dvec3(a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y);
    return n;
}

bool holdsEye(vec3 a, vec3 b, vec3 c) {
    for (int i = 0; i < 3; ++i) {
        if (a[i] > 0.0 && b[i] > 0.0 && c[i] > 0.0) return false;
        if (a[i] < 0.0 && b[i] < 0.0 && c[i] < 0.0) return false;
    }
    if (tripleProductExact(a, b, c) != 0.0LF) return false;
    dvec3 ab = crossProduct(dvec3(a), dvec3(b));
    dvec3 bc = crossProduct(dvec3(b), dvec3(c));
    dvec3 ca = crossProduct(dvec3(c), dvec3(a));
    for (int i = 0; i < 3; ++i) {
        bool positive = ab[i] > 0.0LF || bc[i] > 0.0LF || ca[i] > 0.0LF;
        bool negative = ab[i] < 0.0LF || bc[i] < 0.0LF || ca[i] < 0.0LF;
        if (positive && negative) return false;
    }
    return true;
}

void main() {
    uint triangle = gl_GlobalInvocationID.x;
    if (triangle >= count) return;
    vec3 corners[3];
    for (int i = 0; i < 3; ++i) {
        uint at = triangle * 9u + uint(i) * 3u;
        corners[i] = vec3(coordinates[at], coordinates[at + 1u], coordinates[at + 2u]);
    }
    if (!holdsEye(corners[0], corners[1], corners[2])) return;
    uint place = atomicAdd(found, 1u);
    if (place < uint(ids.length())) ids[place] = firstId + triangle;
}
