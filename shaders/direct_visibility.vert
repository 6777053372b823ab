#version 450 core
// DirectVisibility: the triangle buffer's corners as the image plane sees them, such that a pixel's
// centre is the sample's point. In double: of a narrow view float would lose parts of pixels.

#include "include/frame.glsl"

layout(location = 0) in vec3 corner;
layout(location = 2) uniform dmat3 toClip; // x, y and w from the grid frame, as rows

void main() {
    dvec3 p = dvec3(corner);
    dvec3 clip = toClip * p;
    gl_Position = vec4(clip.x, clip.y, 0.0, clip.z); // clipped at w = 0 alone
}
