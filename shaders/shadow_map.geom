#version 450 core
// ShadowMap: proposes the texels that a triangle may cover, as a rectangle. The fragment shader
// decides.

#include "include/frame.glsl"

layout(triangles) in;
layout(triangle_strip, max_vertices = 4) out;

in vec3 position[];

flat out uint primitive;

void emit(vec2 place) {
    primitive = uint(gl_PrimitiveIDIn);
    gl_Position = vec4(place / float(frame.shadowMap.resolution) * 2.0 - 1.0, 0.0, 1.0);
    EmitVertex();
}

void main() {
    ivec4 texels;
    if (!shadowFootprint(frame.light, frame.shadowMap, position[0], position[1], position[2],
                         texels))
        return;
    // The rasterizer looks at the texels' centres.
    vec2 low = vec2(texels.xy), high = vec2(texels.zw + 1);
    emit(low);
    emit(vec2(high.x, low.y));
    emit(vec2(low.x, high.y));
    emit(high);
    EndPrimitive();
}
