#version 450 core

#include "include/self_test.glsl"

layout(std430, binding = 0) writeonly buffer Results {
    uvec4 results[]; // floats and doubles of the vertex, geometry, fragment and compute stage
};
flat in uvec4 vertexFloats, vertexDoubles, geometryFloats, geometryDoubles;
flat in vec3 value;
flat in int index;

void main() {
    results[index * 8] = vertexFloats;
    results[index * 8 + 1] = vertexDoubles;
    results[index * 8 + 2] = geometryFloats;
    results[index * 8 + 3] = geometryDoubles;
    results[index * 8 + 4] = testFloats(value);
    results[index * 8 + 5] = testDoubles(value);
}
