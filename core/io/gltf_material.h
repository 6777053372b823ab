#pragma once

#include "core/io/gltf.h"
#include "core/io/gltf_members.h"

namespace dirt {

/// The file's images and materials, each in their order.
std::vector<GltfFile::Image> gltfImages(const GltfData& data);
std::vector<GltfFile::Surface> gltfSurfaces(const GltfData& data, size_t images,
                                            GltfIgnored& ignored);

} // namespace dirt
