// core/trace/holes.h in GLSL: whether a ray that meets a triangle hits it.

#include "include/materials.glsl"
#include "include/sides.glsl"

bool isHit(vec3 direction, uint primitive, float u, float v) {
    if (hasOneSide(primitive) && directionSide(direction, triangleOf(primitive)) > 0) return false;
    return isThere(primitive, u, v);
}
