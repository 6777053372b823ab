#include "core/scene/cut_outs.h"

#include "core/scene/attributes.h"

namespace dirt {

bool isThere(const Scene& scene, uint32_t primitive, float u, float v) {
    const Material& material = scene.materials[scene.mesh.materials[primitive]];
    float opacity = material.opacity;
    if (material.opacityMap != kNoTexture)
        if (const auto texcoord = texcoordAt(scene.mesh, primitive, u, v))
            opacity *= scene.scalarTextures[material.opacityMap].sample(*texcoord);
    return opacity >= 0.5f;
}

} // namespace dirt
