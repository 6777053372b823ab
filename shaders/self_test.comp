#version 450 core

#include "include/self_test.glsl"

layout(local_size_x = DIRT_CASES) in;
layout(std430, binding = 0) buffer Results {
    uvec4 results[];
};
layout(std430, binding = 1) readonly buffer Values {
    float values[];
};

void main() {
    uint i = gl_LocalInvocationID.x;
    vec3 value = vec3(values[3u * i], values[3u * i + 1u], values[3u * i + 2u]);
    results[i * 8u + 6u] = testFloats(value);
    results[i * 8u + 7u] = testDoubles(value);
}
