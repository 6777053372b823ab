#pragma once

#include "core/io/load_report.h"
#include "core/io/material_libraries.h"
#include "core/io/texture_loader.h"
#include "core/scene/material.h"

namespace dirt {

/// Loads the textures that an MTL material names and lets \p material, which materialOf has made of
/// it, have them. Where one is not there or damaged, the numbers count; but for the textures of Kd
/// and, in wavefront, of Ke: Kd is then that of a material that says nothing, and nothing shines.
///
/// In wavefront every texture replaces its number, as in Blender. (But Ke above 1 multiplies
/// map_Ke.) There map_bump is a normal map where the image is one (see isNormalMap), and a file
/// that is not found is looked for by its name alone beside the MTL file.
void addTextures(const MaterialLibraries::Entry& entry, TextureLoader& textures, LoadReport& report,
                 Material& material);

} // namespace dirt
