#version 450 core

#include "include/self_test.glsl"

layout(points) in;
layout(points, max_vertices = 1) out;
flat in uvec4 floats[], doubles[];
flat in vec3 passed[];
flat out uvec4 vertexFloats, vertexDoubles, geometryFloats, geometryDoubles;
flat out vec3 value;
flat out int index;

void main() {
    vertexFloats = floats[0];
    vertexDoubles = doubles[0];
    value = passed[0];
    geometryFloats = testFloats(value);
    geometryDoubles = testDoubles(value);
    index = gl_PrimitiveIDIn;
    gl_Position = gl_in[0].gl_Position;
    EmitVertex();
    EndPrimitive();
}
