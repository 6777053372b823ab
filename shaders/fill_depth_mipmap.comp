#version 450 core
// FillDepthMipmap: one level of the min-max depth pyramid from the level below, in all views.

layout(local_size_x = 8, local_size_y = 8) in;
layout(rg32f, binding = 0) readonly uniform image2DArray below;
layout(rg32f, binding = 1) writeonly uniform image2DArray level;

void main() {
    ivec3 cell = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(cell, imageSize(level)))) return;
    ivec2 last = imageSize(below).xy - 1; // where the level below has one row or column only
    vec2 bounds = vec2(-3.40282347e38); // (-near, far)
    for (int child = 0; child < 4; ++child) {
        ivec2 at = min(cell.xy * 2 + ivec2(child & 1, child >> 1), last);
        bounds = max(bounds, imageLoad(below, ivec3(at, cell.z)).xy);
    }
    imageStore(level, cell, vec4(bounds, 0.0, 0.0));
}
