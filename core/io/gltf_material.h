#pragma once

#include "core/io/gltf.h"
#include "core/io/gltf_members.h"

namespace dirt {

/// The file's images and materials, each in their order. \p memory takes what the images need.
std::vector<GltfFile::Image> gltfImages(const GltfData& data, MemoryClaim& memory);
std::vector<GltfFile::Surface> gltfSurfaces(const GltfData& data, size_t images,
                                            GltfIgnored& ignored, FaultCounter& faults);

} // namespace dirt
