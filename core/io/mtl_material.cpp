#include "core/io/mtl_material.h"

#include <algorithm>
#include <cmath>

namespace dirt {

namespace {

float mean(glm::vec3 colour) {
    return (colour.x + colour.y + colour.z) / 3.0f;
}

/// Whether the illumination model is one of those with a highlight and nothing more.
bool hasHighlight(const MtlMaterial& source) {
    return source.illumination == 2;
}

bool reflects(const MtlMaterial& source) {
    return source.illumination >= 3 && source.illumination <= 8;
}

/// Glass and refraction.
bool refracts(const MtlMaterial& source) {
    const int model = source.illumination.value_or(0);
    return model == 4 || model == 6 || model == 7 || model == 9;
}

/// Whether Ks is what a mirror reflects.
bool isSpecularMirror(const MtlMaterial& source) {
    return reflects(source) && !source.metalness && source.map(MtlUse::metalness).file.empty() &&
           source.ambient && source.specular && source.ambient == source.diffuse &&
           mean(*source.specular) > mean(*source.diffuse);
}

float opacityOf(const MtlMaterial& source) {
    if (source.opacity) return *source.opacity;
    const float transparency = source.transparency.value_or(0.0f);
    return transparency < 1.0f ? 1.0f - transparency : 1.0f;
}

Material demoMaterial(const MtlMaterial& source) {
    Material material;
    material.diffuse = source.diffuse.value_or(material.diffuse);
    material.emission = source.emission.value_or(material.emission);
    if (source.specular) material.reflectance = source.specular->x;
    if (source.exponent) material.roughness = 1.0f - std::min(*source.exponent, 127.0f) / 127.0f;
    material.opacity = source.opacity.value_or(1.0f);
    material.metallic = source.metallic.value_or(0.0f);
    return material;
}

Material wavefrontMaterial(const MtlMaterial& source) {
    Material material;
    material.diffuse = source.diffuse.value_or(material.diffuse);
    material.emission = source.emission.value_or(material.emission);
    material.opacity = opacityOf(source);

    float roughness = hasHighlight(source) ? 0.0f : 1.0f;
    if (source.exponent)
        roughness = 1.0f - std::sqrt(std::min(*source.exponent, 1000.0f) / 1000.0f);
    if (source.roughness) roughness = *source.roughness;
    material.roughness = roughness * roughness;

    float metallic = 0.0f;
    if (reflects(source) && !isSpecularMirror(source))
        metallic = source.ambient ? mean(*source.ambient) : 1.0f;
    if (source.metalness) metallic = *source.metalness;
    material.metallic = metallic;
    const float dielectric = dielectricReflectance(source);
    material.reflectance = dielectric + (1.0f - dielectric) * metallic;
    return material;
}

} // namespace

float highestReflectance(const MtlMaterial& source) {
    return isSpecularMirror(source) ? 1.0f : 0.08f;
}

float dielectricReflectance(const MtlMaterial& source) {
    float specular = hasHighlight(source) ? 1.0f : 0.0f;
    if (source.specular) specular = mean(*source.specular);
    return highestReflectance(source) * specular;
}

bool honoursMap(MaterialConvention convention, MtlUse use) {
    if (convention == MaterialConvention::wavefront) return true;
    return use != MtlUse::exponent && use != MtlUse::roughness && use != MtlUse::metalness;
}

Material materialOf(const MtlMaterial& source, MaterialConvention convention) {
    Material material =
        convention == MaterialConvention::demo ? demoMaterial(source) : wavefrontMaterial(source);
    material.name = printable(source.name);
    material.bumpScale = source.bumpScale.value_or(material.bumpScale);
    return material;
}

void reportIgnored(const MtlMaterial& source, MaterialConvention convention, LoadReport& report) {
    const bool demo = convention == MaterialConvention::demo;
    if (source.ambient && (demo || !reflects(source))) report.ignore("MTL Ka");
    if (demo && source.illumination) report.ignore("MTL illum");
    if (demo && source.transparency) report.ignore("MTL Tr");
    if (demo && source.roughness) report.ignore("MTL Pr");
    if (demo && source.metalness) report.ignore("MTL Pm");
    if (!demo && source.metallic) report.ignore("MTL metallic");
    if (!demo && source.transparency) {
        if (source.opacity && (*source.opacity < 0.5f) != (*source.transparency > 0.5f))
            report.ignore("MTL Tr, which contradicts d");
        if (!source.opacity && *source.transparency >= 1.0f)
            report.ignore("MTL Tr 1, taken as opaque");
    }
    if (!demo && refracts(source))
        report.ignore("MTL illum " + std::to_string(*source.illumination) + ", its transparency");
    if (!demo && source.illumination > 9)
        report.ignore("MTL illum " + std::to_string(*source.illumination));
    for (const MtlMap& map : source.maps)
        if (!map.file.empty() && !honoursMap(convention, (MtlUse) (&map - source.maps.data())))
            report.ignore("MTL " + std::string(map.key));
}

} // namespace dirt
