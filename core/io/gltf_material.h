#pragma once

#include "core/io/gltf.h"

namespace dirt {

/// The file's images and materials, each in their order.
std::vector<GltfFile::Image> gltfImages(const GltfData& data, LoadReport& report);
std::vector<GltfFile::Surface> gltfSurfaces(const GltfData& data, size_t images,
                                            LoadReport& report);

} // namespace dirt
