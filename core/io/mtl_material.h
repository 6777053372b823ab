#pragma once

#include "core/io/load_report.h"
#include "core/io/material_convention.h"
#include "core/io/mtl.h"
#include "core/scene/material.h"

namespace dirt {

/// Whether a texture of that use counts in the convention.
bool honoursMap(MaterialConvention convention, MtlUse use);

/// What the numbers of an MTL material mean, without its textures.
///
/// demo: Ks, its first component, is F0; Ns of 127 is a mirror; d is the opacity.
///
/// wavefront is what Blender's importer makes of the file (3.4 and later), as far as surfaces have
/// it: the perceptual roughness r is Pr, else 1 - sqrt(Ns / 1000), else 0 for illum 2 and 1
/// otherwise, and the width r^2; specular s is the mean of Ks, else 1 for illum 2 and 0 otherwise,
/// and F0 is 0.08 s; metallic is Pm, else for illum 3 to 8 the mean of Ka, which is how Blender
/// writes it, or 1 without Ka, else 0. In one case it is not: where a reflecting material repeats
/// Kd as Ka, and its Ks is brighter, Ka is but ambient light, and Ks what the mirror reflects; F0
/// is then the mean of Ks. Opacity is d, else 1 - Tr; but Tr 1 alone, which MeshLab and others
/// write for all that is opaque, is 1.
Material materialOf(const MtlMaterial& source, MaterialConvention convention);

/// In wavefront, F0 of the material where it is no metal, and what that is for a specular of 1.
float dielectricReflectance(const MtlMaterial& source);
float highestReflectance(const MtlMaterial& source);

/// Reports what of the material has no effect in the convention.
void reportIgnored(const MtlMaterial& source, MaterialConvention convention, LoadReport& report);

} // namespace dirt
