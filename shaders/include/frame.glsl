// The frame's parameters, and what every pass makes of them alike.

#include "shared/frame_parameters.h"

layout(std140, binding = 1) uniform FrameBlock {
    FrameParameters frame;
};

/// Direction of the ray from the eye through the sample's point of a pixel.
vec3 directionThrough(uvec2 pixel) {
    precise float x = float(pixel.x) + frame.offsetX;
    precise float y = float(pixel.y) + frame.offsetY;
    return cameraDirection(frame.plane, x, y);
}

/// GridFrame::directionToGrid.
vec3 directionToGrid(vec3 p) {
    if (frame.single == 0u) return p;
    precise vec3 turned =
        vec3((frame.right.x * p.x + frame.right.y * p.y) + frame.right.z * p.z,
             (frame.down.x * p.x + frame.down.y * p.y) + frame.down.z * p.z,
             (frame.forward.x * p.x + frame.forward.y * p.y) + frame.forward.z * p.z);
    return turned;
}
