#include "core/trace/holes.h"

#include "core/trace/determinant.h"

namespace dirt {

bool isHit(const FrameGeometry& geometry, glm::vec3 direction, uint32_t primitive, float u,
           float v) {
    if (!geometry.cutOuts) return true;
    const Scene& scene = *geometry.cutOuts;
    if (!scene.materials[scene.mesh.materials[primitive]].doubleSided) {
        const Triangle& t = geometry.triangles[primitive];
        if (directionSide(direction, t.a, t.b, t.c) > 0) return false;
    }
    return isThere(scene, primitive, u, v);
}

} // namespace dirt
