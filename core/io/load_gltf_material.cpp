#include "core/io/load_gltf_material.h"

namespace dirt {

namespace {

class MaterialLoader {
public:
    MaterialLoader(const GltfFile& gltf, const GltfFile::Surface& surface, TextureLoader& textures)
        : gltf_(gltf), surface_(surface), textures_(textures), material_(surface.material) {}

    Material load() {
        baseColour();
        microfacets();
        const GltfTextureUse& emission = surface_.emission;
        if (emission.isThere()) {
            material_.emissionMap = textures_.colour(sourceOf(emission), emission.sampling);
            // Without the texture there is no telling which part of the surface shines; what is
            // unlit has its colour all the same.
            if (material_.emissionMap == kNoTexture && !surface_.unlit)
                material_.emission = glm::vec3(0.0f);
        }
        const GltfTextureUse& normal = surface_.normal;
        if (normal.isThere())
            material_.normalMap =
                textures_.colour(sourceOf(normal), normal.sampling, TexelEncoding::linear);
        return material_;
    }

private:
    TextureLoader::Source sourceOf(const GltfTextureUse& use) const {
        return gltf_.images[use.image].source(gltf_.file);
    }

    void baseColour() {
        const GltfTextureUse& colour = surface_.colour;
        if (!colour.isThere()) return;
        if (!surface_.unlit) {
            material_.diffuseMap = textures_.reflectance(sourceOf(colour), colour.sampling);
            material_.diffuseMapFactor = material_.diffuse;
        }
        if (surface_.alphaLimit > 0.0f)
            material_.opacityMap =
                textures_.alpha(sourceOf(colour), surface_.alphaLimit, colour.sampling);
    }

    /// The distribution is as wide as the roughness squared. Fresnel's term begins at the
    /// dielectric's reflectance, and where it is metal at 1 times the base colour.
    void microfacets() {
        const GltfTextureUse& both = surface_.metallicRoughness;
        material_.roughness = surface_.roughness * surface_.roughness;
        material_.metallic = surface_.metallic;
        if (both.isThere()) {
            material_.roughnessMap =
                textures_.part(sourceOf(both), both.sampling, ImageChannel::green);
            if (surface_.metallic > 0.0f)
                material_.metallicMap =
                    textures_.part(sourceOf(both), both.sampling, ImageChannel::blue);
        }
        material_.reflectance = surface_.dielectric;
        if (material_.metallicMap == kNoTexture)
            material_.reflectance += (1.0f - surface_.dielectric) * surface_.metallic;
        const GltfTextureUse& scaled = surface_.reflectance;
        if (scaled.isThere())
            material_.reflectanceMap =
                textures_.part(sourceOf(scaled), scaled.sampling, ImageChannel::alpha);
    }

    const GltfFile& gltf_;
    const GltfFile::Surface& surface_;
    TextureLoader& textures_;
    Material material_;
};

} // namespace

Material loadGltfMaterial(const GltfFile& gltf, size_t surface, TextureLoader& textures) {
    return MaterialLoader(gltf, gltf.surfaces[surface], textures).load();
}

} // namespace dirt
