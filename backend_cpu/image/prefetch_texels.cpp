#include "backend_cpu/image/prefetch_texels.h"

#include "core/scene/attributes.h"

#include <hwy/cache_control.h>

namespace dirt {

void prefetchTexels(const Scene& scene, uint32_t primitive, float u, float v) {
    const uint32_t map = scene.materials[scene.mesh.materials[primitive]].diffuseMap;
    if (map == kNoTexture) return;
    const auto texcoord = texcoordAt(scene.mesh, primitive, u, v);
    if (!texcoord) return;
    const Texture& texture = scene.textures[map];
    const TextureSampling& sampling = texture.sampling();
    const glm::vec2 at = sampling.imageCoordinates(*texcoord);
    const size_t width = (size_t) texture.width();
    const size_t column =
        (size_t) columnsAround(at.x, texture.width(), (uint32_t) sampling.wrapU).first;
    const TexelPair rows = rowsAround(at.y, texture.height(), (uint32_t) sampling.wrapV);
    for (const int row : {rows.first, rows.second}) {
        const size_t first = ((size_t) row * width + column) * 3;
        if (texture.linearTexels().empty())
            hwy::Prefetch(&texture.encodedTexels()[first]);
        else
            hwy::Prefetch(&texture.linearTexels()[first]);
    }
}

} // namespace dirt
