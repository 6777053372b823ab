#include "core/io/gltf_material.h"

#include "core/io/find_file.h"
#include "shaders/shared/radiance.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <span>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace dirt {

namespace {

/// Three numbers, or with alpha four.
template <typename Vec>
Vec colour(const JsonValue& owner, const char* name, Vec otherwise) {
    const auto values = owner.numbers(name, (size_t) Vec::length());
    if (!values) return otherwise;
    Vec colour;
    for (int c = 0; c < Vec::length(); ++c) {
        if ((*values)[(size_t) c] < 0.0) owner.fail("has a negative " + std::string(name));
        colour[c] = (float) (*values)[(size_t) c];
    }
    return colour;
}

class SurfaceReader {
public:
    SurfaceReader(const GltfData& data, size_t images, GltfIgnored& ignored, FaultCounter& faults)
        : ignored_(ignored), faults_(faults), textures_(data, images, ignored) {}

    GltfFile::Surface read(const JsonValue& source) {
        GltfFile::Surface surface;
        std::optional<uint64_t> set;
        Material& material = surface.material;
        material.name = printable(source.text("name").value_or(""));
        material.diffuse = glm::vec3(1.0f);
        const auto doubleSided = source.boolean("doubleSided");
        material.doubleSided = doubleSided.value_or(false);
        surface.saysOneSided = doubleSided == false;
        surface.metallic = surface.roughness = 1.0f;
        float alpha = 1.0f;
        if (const auto pbr = source.object("pbrMetallicRoughness"))
            alpha = metallicRoughness(*pbr, surface, set);
        alphaMode(source, alpha, surface);
        normal(source, surface, set);
        emission(source, surface, set);
        dielectric(source, surface, set);
        if (extension(source, "KHR_materials_unlit")) makeUnlit(surface);
        surface.texcoordSet = set.value_or(0);
        return surface;
    }

private:
    static std::optional<JsonValue> extension(const JsonValue& source, const char* name) {
        const auto extensions = source.object("extensions");
        return extensions ? extensions->object(name) : std::nullopt;
    }

    /// Takes components above \p most for it.
    void confine(const JsonValue& owner, const char* name, std::span<float> components,
                 float most) {
        const float largest = *std::max_element(components.begin(), components.end());
        if (largest <= most) return;
        const auto message = [&] {
            char text[96];
            std::snprintf(text, sizeof text, " has a %s of %g, taken for %g", name,
                          (double) largest, (double) most);
            return owner.place() + text;
        };
        faults_.add(WarningKind::unusableValue, name, 0, message);
        for (float& component : components) component = std::min(component, most);
    }

    /// Returns the base colour's alpha.
    float metallicRoughness(const JsonValue& pbr, GltfFile::Surface& surface,
                            std::optional<uint64_t>& set) {
        glm::vec4 base = colour(pbr, "baseColorFactor", glm::vec4(1.0f));
        confine(pbr, "baseColorFactor", {&base.x, 4}, 1.0f);
        surface.material.diffuse = base;
        surface.metallic = (float) pbr.number("metallicFactor", 0.0, 1.0).value_or(1.0);
        surface.roughness = (float) pbr.number("roughnessFactor", 0.0, 1.0).value_or(1.0);
        surface.colour = textures_.use(pbr, "baseColorTexture", set);
        surface.metallicRoughness = textures_.use(pbr, "metallicRoughnessTexture", set);
        return base.w;
    }

    /// A surface is cut out where alpha is below the cutoff, here where opacity is below 1/2. What
    /// is to be blended is there where more than half of it would be.
    void alphaMode(const JsonValue& source, float alpha, GltfFile::Surface& surface) {
        const std::string mode = source.text("alphaMode").value_or("OPAQUE");
        auto cutoff = (float) source.number("alphaCutoff", 0.0, 1e30).value_or(0.5);
        if (mode == "BLEND") {
            ignored_.add("material alphaMode BLEND but as a cut-out at 1/2");
            cutoff = 0.5f;
        } else if (mode != "MASK") {
            if (mode != "OPAQUE") ignored_.add("material alphaMode " + mode);
            return;
        }
        if (cutoff == 0.0f) return;
        surface.material.opacity = 0.5f * alpha / cutoff;
        if (alpha > 0.0f) surface.alphaLimit = cutoff / alpha;
    }

    void normal(const JsonValue& source, GltfFile::Surface& surface, std::optional<uint64_t>& set) {
        surface.normal = textures_.use(source, "normalTexture", set);
        if (const auto texture = source.object("normalTexture"))
            surface.material.normalScale =
                (float) texture->number("scale", -1e30, 1e30).value_or(1.0);
    }

    void emission(const JsonValue& source, GltfFile::Surface& surface,
                  std::optional<uint64_t>& set) {
        glm::vec3& emission = surface.material.emission;
        emission = colour(source, "emissiveFactor", glm::vec3(0.0f));
        if (const auto strength = extension(source, "KHR_materials_emissive_strength"))
            emission *= (float) strength->number("emissiveStrength", 0.0, 1e30).value_or(1.0);
        confine(source, "radiance", {&emission.x, 3}, kMostRadiance);
        surface.emission = textures_.use(source, "emissiveTexture", set);
    }

    /// What is no metal reflects ((n - 1) / (n + 1))^2 at normal incidence; KHR_materials_ior says
    /// n, which is else 1.5, and KHR_materials_specular scales it.
    void dielectric(const JsonValue& source, GltfFile::Surface& surface,
                    std::optional<uint64_t>& set) {
        double reflectance = 0.04;
        if (const auto ior = extension(source, "KHR_materials_ior")) {
            const double n = ior->number("ior", 0.0, 1e30).value_or(1.5);
            reflectance = std::pow((n - 1.0) / (n + 1.0), 2.0);
        }
        if (const auto specular = extension(source, "KHR_materials_specular")) {
            const glm::vec3 tint = colour(*specular, "specularColorFactor", glm::vec3(1.0f));
            if (tint.x != tint.y || tint.y != tint.z)
                ignored_.add("material specular specularColorFactor but its mean");
            const double mean = ((double) tint.x + tint.y + tint.z) / 3.0;
            reflectance = std::min(reflectance * mean, 1.0) *
                          specular->number("specularFactor", 0.0, 1.0).value_or(1.0);
            surface.reflectance = textures_.use(*specular, "specularTexture", set);
            // It scales what is no metal, and only a texture tells this apart.
            if (surface.reflectance.isThere() && surface.metallic > 0.0f &&
                !surface.metallicRoughness.isThere()) {
                ignored_.add("material specular specularTexture of a metal");
                surface.reflectance = {};
            }
        }
        surface.dielectric = (float) reflectance;
    }

    /// It has the base colour whatever shines on it. That it lights what is around it is more than
    /// the extension says.
    void makeUnlit(GltfFile::Surface& surface) {
        ignored_.add("material extension KHR_materials_unlit but as emission");
        Material& material = surface.material;
        material.emission = material.diffuse;
        material.diffuse = glm::vec3(0.0f);
        surface.emission = surface.colour;
        surface.normal = surface.metallicRoughness = surface.reflectance = {};
        surface.metallic = surface.dielectric = 0.0f;
        surface.unlit = true;
    }

    GltfIgnored& ignored_;
    FaultCounter& faults_;
    GltfTextures textures_;
};

} // namespace

std::vector<GltfFile::Image> gltfImages(const GltfData& data, MemoryClaim& memory) {
    std::vector<GltfFile::Image> images;
    std::map<uint64_t, std::shared_ptr<const std::string>> ofViews;
    for (const JsonValue& source : data.root().objects("images")) {
        GltfFile::Image& image = images.emplace_back();
        image.label = "images[" + std::to_string(images.size() - 1) + "]";
        const auto uri = source.text("uri");
        const auto view = source.integer("bufferView", JsonValue::kMostIndex);
        if (uri.has_value() == view.has_value()) source.fail("has not one of uri and bufferView");
        if (view) {
            const auto bytes = data.view(*view, source);
            auto& shared = ofViews[*view];
            if (!shared) {
                memory.take(bytes.size(), data.file(), image.label);
                shared = std::make_shared<std::string>((const char*) bytes.data(), bytes.size());
            }
            image.bytes = shared;
        } else if (uri->starts_with("data:")) {
            memory.take(uri->size(), data.file(), image.label);
            image.bytes = std::make_shared<std::string>(*decodeDataUri(*uri, source));
        } else {
            image.label = decodeUri(*uri);
        }
    }
    return images;
}

std::vector<GltfFile::Surface> gltfSurfaces(const GltfData& data, size_t images,
                                            GltfIgnored& ignored, FaultCounter& faults) {
    std::vector<GltfFile::Surface> surfaces;
    SurfaceReader reader(data, images, ignored, faults);
    for (const JsonValue& source : data.root().objects("materials"))
        surfaces.push_back(reader.read(source));
    return surfaces;
}

TextureLoader::Source GltfFile::Image::source(const std::filesystem::path& gltf) const {
    if (bytes) return {ImageFile(gltf / label, bytes), label, gltf};
    const auto file = findFile(gltf.parent_path(), label);
    return {file ? std::optional<ImageFile>(*file) : std::nullopt, label, gltf};
}

} // namespace dirt
