#pragma once

#include "core/io/gltf.h"
#include "core/io/texture_loader.h"

namespace dirt {

/// A surface of \p gltf as a scene's material; \p textures loads what it uses.
Material loadGltfMaterial(const GltfFile& gltf, size_t surface, TextureLoader& textures);

} // namespace dirt
