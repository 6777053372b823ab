#include "core/io/gltf_material.h"

#include "core/io/find_file.h"
#include "core/io/number.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace dirt {

namespace {

constexpr uint64_t kHighest = 0xfffffffe;

glm::vec3 colour(const JsonValue& owner, const char* name, size_t components, glm::vec3 otherwise) {
    const auto values = owner.numbers(name, components);
    if (!values) return otherwise;
    for (const double value : *values)
        if (value < 0.0) owner.fail("has a negative " + std::string(name));
    return {(float) (*values)[0], (float) (*values)[1], (float) (*values)[2]};
}

class SurfaceReader {
public:
    SurfaceReader(const GltfData& data, size_t images, GltfIgnored& ignored)
        : images_(images), ignored_(ignored), textures_(data.root().objects("textures")),
          samplers_(data.root().objects("samplers")) {}

    GltfFile::Surface read(const JsonValue& source) {
        GltfFile::Surface surface;
        Material& material = surface.material;
        material.name = printable(source.text("name").value_or(""));
        material.diffuse = glm::vec3(1.0f);
        material.doubleSided = source.boolean("doubleSided").value_or(false);
        surface.metallic = surface.roughness = 1.0f;
        float alpha = 1.0f;
        if (const auto pbr = source.object("pbrMetallicRoughness"))
            alpha = metallicRoughness(*pbr, surface);
        setMetallicRoughness(material, surface.metallic, surface.roughness);
        alphaMode(source, alpha, surface);
        emission(source, surface);
        return surface;
    }

private:
    /// Returns the base colour's alpha.
    float metallicRoughness(const JsonValue& pbr, GltfFile::Surface& surface) {
        surface.material.diffuse = colour(pbr, "baseColorFactor", 4, glm::vec3(1.0f));
        surface.metallic = (float) pbr.number("metallicFactor", 0.0, 1.0).value_or(1.0);
        surface.roughness = (float) pbr.number("roughnessFactor", 0.0, 1.0).value_or(1.0);
        if (const auto texture = pbr.object("baseColorTexture")) {
            surface.colourImage = imageOf(*texture);
            surface.texcoordSet = texture->integer("texCoord", kHighest).value_or(0);
        }
        if (const auto texture = pbr.object("metallicRoughnessTexture")) {
            surface.roughnessImage = imageOf(*texture);
            ignored_.add("material metallicRoughnessTexture but for its means");
        }
        const auto factor = pbr.numbers("baseColorFactor", 4);
        return factor ? (float) (*factor)[3] : 1.0f;
    }

    /// A surface is cut out where alpha is below the cutoff, here where opacity is below 1/2.
    void alphaMode(const JsonValue& source, float alpha, GltfFile::Surface& surface) {
        const std::string mode = source.text("alphaMode").value_or("OPAQUE");
        const auto cutoff = (float) source.number("alphaCutoff", 0.0, 1e30).value_or(0.5);
        if (mode != "OPAQUE" && mode != "MASK") ignored_.add("material alphaMode " + mode);
        if (mode != "MASK" || cutoff == 0.0f) return;
        surface.material.opacity = 0.5f * alpha / cutoff;
        if (alpha > 0.0f) surface.alphaLimit = cutoff / alpha;
    }

    void emission(const JsonValue& source, GltfFile::Surface& surface) {
        glm::vec3& emission = surface.material.emission;
        emission = colour(source, "emissiveFactor", 3, glm::vec3(0.0f));
        if (const auto extensions = source.object("extensions")) {
            if (const auto strength = extensions->object("KHR_materials_emissive_strength"))
                emission *= (float) strength->number("emissiveStrength", 0.0, 1e30).value_or(1.0);
        }
        if (!fitsFloat(glm::dvec3(emission))) source.fail("shines beyond float32");
        const auto texture = source.object("emissiveTexture");
        if (!texture) return;
        surface.emissionImage = imageOf(*texture);
        const uint64_t set = texture->integer("texCoord", kHighest).value_or(0);
        if (surface.colourImage == GltfFile::kNone)
            surface.texcoordSet = set;
        else if (set != surface.texcoordSet)
            ignored_.add("emissiveTexture texCoord");
    }

    /// The image of a reference to a texture; kNone where it has none that can be read.
    uint32_t imageOf(const JsonValue& reference) {
        const uint64_t index = reference.requiredInteger("index", kHighest);
        const JsonValue& texture = JsonValue::at(textures_, index, reference, "textures");
        if (const auto sampler = texture.integer("sampler", kHighest))
            for (const char* name : {"wrapS", "wrapT"})
                if (JsonValue::at(samplers_, *sampler, texture, "samplers")
                        .integer(name, kHighest)
                        .value_or(kRepeat) != kRepeat)
                    ignored_.add("sampler " + std::string(name));
        const auto source = texture.integer("source", kHighest);
        if (!source) return GltfFile::kNone; // in an extension alone
        if (*source >= images_) texture.fail("refers to an image that is not there");
        return (uint32_t) *source;
    }

    static constexpr uint64_t kRepeat = 10497;

    size_t images_;
    GltfIgnored& ignored_;
    std::vector<JsonValue> textures_, samplers_;
};

} // namespace

std::vector<GltfFile::Image> gltfImages(const GltfData& data) {
    std::vector<GltfFile::Image> images;
    for (const JsonValue& source : data.root().objects("images")) {
        GltfFile::Image& image = images.emplace_back();
        image.label = "images[" + std::to_string(images.size() - 1) + "]";
        const auto uri = source.text("uri");
        const auto view = source.integer("bufferView", kHighest);
        if (uri.has_value() == view.has_value()) source.fail("has not one of uri and bufferView");
        if (view) {
            const auto bytes = data.view(*view, source);
            image.bytes.emplace((const char*) bytes.data(), bytes.size());
        } else if (auto bytes = decodeDataUri(*uri, source)) {
            image.bytes = std::move(*bytes);
        } else {
            image.label = decodeUri(*uri);
        }
    }
    return images;
}

std::vector<GltfFile::Surface> gltfSurfaces(const GltfData& data, size_t images,
                                            GltfIgnored& ignored) {
    std::vector<GltfFile::Surface> surfaces;
    SurfaceReader reader(data, images, ignored);
    for (const JsonValue& source : data.root().objects("materials"))
        surfaces.push_back(reader.read(source));
    return surfaces;
}

TextureLoader::Source GltfFile::Image::source(const std::filesystem::path& gltf) const {
    if (bytes) return {ImageFile(gltf / label, *bytes), label, gltf};
    const auto file = findFile(gltf.parent_path(), label);
    return {file ? std::optional<ImageFile>(*file) : std::nullopt, label, gltf};
}

void setMetallicRoughness(Material& material, float metallic, float roughness) {
    material.metallic = metallic;
    material.roughness = roughness * roughness;
    material.reflectance = 0.04f + 0.96f * metallic;
}

} // namespace dirt
