#include "core/io/mtl_textures.h"

#include "core/io/find_file.h"
#include "core/io/mtl_material.h"

#include <algorithm>
#include <string>

namespace dirt {

namespace {

/// -s and -o, in the order of Blender and of OpenGL's texture matrices: scaled, then moved.
TextureSampling samplingOf(const MtlMap& map) {
    TextureSampling sampling;
    if (map.clamps) sampling.wrapU = sampling.wrapV = Wrap::clamp;
    sampling.transformed = map.scale != glm::vec2(1.0f) || map.offset != glm::vec2(0.0f);
    sampling.rowU = {map.scale.x, 0.0f, map.offset.x};
    sampling.rowV = {0.0f, map.scale.y, map.offset.y};
    return sampling;
}

class MaterialTextures {
public:
    MaterialTextures(const MaterialLibraries::Entry& entry, TextureLoader& textures,
                     LoadReport& report, Material& material)
        : source_(*entry.material), library_(entry.file->file),
          isWavefront_(entry.convention == MaterialConvention::wavefront), textures_(textures),
          report_(report), material_(material) {}

    void add() {
        material_.diffuseMap = reflectance();
        // Kd says nothing of what the texture would have shown; often it is black.
        if (names(MtlUse::diffuse) && material_.diffuseMap == kNoTexture)
            material_.diffuse = Material().diffuse;
        material_.emissionMap = colour(MtlUse::emission);
        if (isWavefront_ && names(MtlUse::emission)) replaceEmission();
        if (isWavefront_)
            gloss();
        else
            material_.reflectanceMap = part(MtlUse::specular);
        relief();
        material_.opacityMap = opacity();
    }

private:
    bool names(MtlUse use) const { return !source_.map(use).file.empty(); }

    /// The file that a texture statement names.
    TextureLoader::Source sourceOf(const MtlMap& map) const {
        const std::filesystem::path folder = library_.parent_path();
        auto file = findFile(folder, map.file);
        // Often it is a path on the machine where the file was written.
        if (!file && isWavefront_)
            file = findFile(folder,
                            std::string_view(map.file).substr(map.file.find_last_of("/\\") + 1));
        return {file ? std::optional<ImageFile>(*file) : std::nullopt, map.file, library_,
                map.line};
    }

    /// The channel that -imfchan says; else the first, or in wavefront, where that is the format's
    /// default, the luminance.
    ImageChannel channelOf(const MtlMap& map) const {
        switch (map.channel) {
        case 'r':
            return ImageChannel::red;
        case 'g':
            return ImageChannel::green;
        case 'b':
            return ImageChannel::blue;
        case 'm':
            return ImageChannel::alpha;
        case 'l':
            return ImageChannel::luminance;
        default:
            return isWavefront_ ? ImageChannel::luminance : ImageChannel::red;
        }
    }

    static TexelEncoding encodingOf(const MtlMap& map) {
        return map.isLinear ? TexelEncoding::linear : TexelEncoding::srgb;
    }

    uint32_t reflectance() {
        const MtlMap& map = source_.map(MtlUse::diffuse);
        if (map.file.empty()) return kNoTexture;
        return textures_.reflectance(sourceOf(map), samplingOf(map), encodingOf(map));
    }

    uint32_t colour(MtlUse use) {
        const MtlMap& map = source_.map(use);
        if (map.file.empty()) return kNoTexture;
        return textures_.colour(sourceOf(map), samplingOf(map), encodingOf(map));
    }

    uint32_t part(MtlUse use) {
        const MtlMap& map = source_.map(use);
        if (map.file.empty()) return kNoTexture;
        return textures_.part(sourceOf(map), samplingOf(map), channelOf(map));
    }

    uint32_t data(MtlUse use) {
        const MtlMap& map = source_.map(use);
        if (map.file.empty()) return kNoTexture;
        return textures_.data(sourceOf(map), samplingOf(map), channelOf(map));
    }

    uint32_t alpha(MtlUse use) {
        const MtlMap& map = source_.map(use);
        return map.file.empty() ? kNoTexture
                                : textures_.alpha(sourceOf(map), 0.5f, samplingOf(map));
    }

    /// The alpha of map_d, else a channel of it; without one, the alpha of map_Kd.
    uint32_t opacity() {
        if (!names(MtlUse::opacity)) return alpha(MtlUse::diffuse);
        if (source_.map(MtlUse::opacity).channel) return data(MtlUse::opacity);
        const uint32_t found = alpha(MtlUse::opacity);
        return found != kNoTexture ? found : data(MtlUse::opacity);
    }

    void replaceEmission() {
        const glm::vec3 ke = material_.emission;
        const bool shines = material_.emissionMap != kNoTexture;
        material_.emission = glm::vec3(shines ? std::max({1.0f, ke.x, ke.y, ke.z}) : 0.0f);
    }

    /// Normals and heights, of which normals count alone.
    void relief() {
        const MtlMap& normal = source_.map(MtlUse::normal);
        const MtlMap& bump = source_.map(MtlUse::bump);
        if (!normal.file.empty()) {
            material_.normalMap =
                textures_.colour(sourceOf(normal), samplingOf(normal), TexelEncoding::linear);
            material_.normalScale = std::max(normal.strength.value_or(1.0f), 0.0f);
            if (!bump.file.empty()) report_.ignore("MTL " + std::string(bump.key) + " beside norm");
        } else if (!bump.file.empty() && !isWavefront_) {
            material_.bumpMap = data(MtlUse::bump);
        } else if (!bump.file.empty()) {
            const auto found = textures_.relief(sourceOf(bump), samplingOf(bump), channelOf(bump));
            material_.bumpMap = found.heights;
            material_.normalMap = found.normals;
            material_.normalScale = std::max(material_.bumpScale, 0.0f);
        }
    }

    /// Reflectance, metallic and roughness in wavefront.
    void gloss() {
        const uint32_t roughness =
            part(names(MtlUse::roughness) ? MtlUse::roughness : MtlUse::exponent);
        if (names(MtlUse::roughness) && names(MtlUse::exponent))
            report_.ignore("MTL map_Ns beside map_Pr");
        if (roughness != kNoTexture) material_.roughness = 1.0f;
        material_.roughnessMap = roughness;

        // A metal's reflectance is Kd, whatever Ks is.
        const bool isMetal = material_.metallic > 0.0f && !names(MtlUse::metalness);
        if (isMetal && names(MtlUse::specular)) report_.ignore("MTL map_Ks of a metal");
        const uint32_t specular = isMetal ? kNoTexture : part(MtlUse::specular);
        const uint32_t metalness = part(MtlUse::metalness);
        if (metalness == kNoTexture && (specular == kNoTexture || material_.metallic > 0.0f))
            return;
        material_.reflectanceMap = specular;
        material_.metallicMap = metalness;
        material_.reflectance =
            specular != kNoTexture ? highestReflectance(source_) : dielectricReflectance(source_);
        if (metalness != kNoTexture) material_.metallic = 1.0f;
    }

    const MtlMaterial& source_;
    const std::filesystem::path& library_;
    const bool isWavefront_;
    TextureLoader& textures_;
    LoadReport& report_;
    Material& material_;
};

} // namespace

void addTextures(const MaterialLibraries::Entry& entry, TextureLoader& textures, LoadReport& report,
                 Material& material) {
    MaterialTextures(entry, textures, report, material).add();
}

} // namespace dirt
