#include "backend_cpu/prefetch_texels.h"

#include "core/scene/attributes.h"
#include "shaders/shared/texture_lookup.h"

#include <hwy/cache_control.h>

namespace dirt {

void prefetchTexels(const Scene& scene, uint32_t primitive, float u, float v) {
    const uint32_t map = scene.materials[scene.mesh.materials[primitive]].diffuseMap;
    if (map == kNoTexture) return;
    const auto texcoord = texcoordAt(scene.mesh, primitive, u, v);
    if (!texcoord) return;
    const Texture& texture = scene.textures[map];
    const size_t width = (size_t) texture.width();
    const size_t column = (size_t) texelsAround(texcoord->x, texture.width()).first;
    const TexelPair rows = texelsAround(-texcoord->y, texture.height());
    for (const int row : {rows.first, rows.second}) {
        const size_t first = ((size_t) row * width + column) * 3;
        if (texture.linearTexels().empty())
            hwy::Prefetch(&texture.encodedTexels()[first]);
        else
            hwy::Prefetch(&texture.linearTexels()[first]);
    }
}

} // namespace dirt
