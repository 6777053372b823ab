#version 450 core

#include "include/self_test.glsl"

layout(location = 0) in vec3 value;
flat out uvec4 floats, doubles;
flat out vec3 passed;

void main() {
    floats = testFloats(value);
    doubles = testDoubles(value);
    passed = value;
    gl_Position = vec4((float(gl_VertexID) + 0.5) / float(DIRT_CASES) * 2.0 - 1.0, 0.0, 0.0, 1.0);
}
