#include "core/io/gltf_texture.h"

#include "core/io/number.h"

#include <cmath>

namespace dirt {

namespace {

constexpr uint64_t kNearest = 9728, kRepeat = 10497, kClampToEdge = 33071, kMirroredRepeat = 33648;

std::optional<JsonValue> transformOf(const JsonValue& reference) {
    const auto extensions = reference.object("extensions");
    return extensions ? extensions->object("KHR_texture_transform") : std::nullopt;
}

/// The extension scales, turns and moves coordinates whose v runs downwards, in this order; it
/// turns counterclockwise as seen with v downwards. Here v runs upwards, before and after.
void addTransform(const JsonValue& transform, TextureSampling& sampling) {
    glm::dvec2 scale(1.0), offset(0.0);
    if (const auto s = transform.numbers("scale", 2)) scale = {(*s)[0], (*s)[1]};
    if (const auto o = transform.numbers("offset", 2)) offset = {(*o)[0], (*o)[1]};
    const double turn = transform.number("rotation", -1e30, 1e30).value_or(0.0);
    const double c = std::cos(turn), s = std::sin(turn);
    // Downwards u' = uu u + uv v + offset.x and v' = vu u + vv v + offset.y.
    const double uu = c * scale.x, uv = s * scale.y, vu = -s * scale.x, vv = c * scale.y;
    const glm::dvec3 rowU(uu, -uv, uv + offset.x), rowV(-vu, vv, 1.0 - vv - offset.y);
    if (!fitsFloat(rowU) || !fitsFloat(rowV)) transform.fail("leaves float32");
    sampling.transformed = true;
    sampling.rowU = glm::vec3(rowU);
    sampling.rowV = glm::vec3(rowV);
    if (sampling.rowU == TextureSampling().rowU && sampling.rowV == TextureSampling().rowV)
        sampling.transformed = false;
}

} // namespace

GltfTextures::GltfTextures(const GltfData& data, size_t images, GltfIgnored& ignored)
    : images_(images), textures_(data.root().objects("textures")),
      samplers_(data.root().objects("samplers")), ignored_(ignored) {
    for (const JsonValue& sampler : samplers_)
        if (sampler.integer("magFilter", JsonValue::kMostIndex) == kNearest)
            ignored_.add("sampler magFilter NEAREST");
}

GltfTextureUse GltfTextures::use(const JsonValue& owner, const char* name,
                                 std::optional<uint64_t>& set) {
    GltfTextureUse result;
    const auto reference = owner.object(name);
    if (!reference) return result;
    const uint64_t index = reference->requiredInteger("index", JsonValue::kMostIndex);
    const JsonValue& texture = JsonValue::at(textures_, index, *reference, "textures");
    const auto source = texture.integer("source", JsonValue::kMostIndex);
    if (!source) { // an image of an extension, or none
        ignored_.add("texture without source");
        return result;
    }
    if (*source >= images_) texture.fail("refers to an image that is not there");
    uint64_t wanted = reference->integer("texCoord", JsonValue::kMostIndex).value_or(0);
    if (const auto transform = transformOf(*reference))
        wanted = transform->integer("texCoord", JsonValue::kMostIndex).value_or(wanted);
    if (!set) set = wanted;
    if (*set != wanted) ignored_.add("texture texCoord that is not the material's first");
    result.image = (uint32_t) *source;
    result.sampling = samplingOf(*reference, texture);
    return result;
}

Wrap GltfTextures::wrap(const JsonValue& sampler, const char* name) {
    const uint64_t mode = sampler.integer(name, JsonValue::kMostIndex).value_or(kRepeat);
    if (mode == kClampToEdge) return Wrap::clamp;
    if (mode == kMirroredRepeat) return Wrap::mirror;
    if (mode != kRepeat) ignored_.add("sampler " + std::string(name) + " " + std::to_string(mode));
    return Wrap::repeat;
}

TextureSampling GltfTextures::samplingOf(const JsonValue& reference, const JsonValue& texture) {
    TextureSampling sampling;
    if (const auto index = texture.integer("sampler", JsonValue::kMostIndex)) {
        const JsonValue& sampler = JsonValue::at(samplers_, *index, texture, "samplers");
        sampling.wrapU = wrap(sampler, "wrapS");
        sampling.wrapV = wrap(sampler, "wrapT");
    }
    if (const auto transform = transformOf(reference)) addTransform(*transform, sampling);
    return sampling;
}

} // namespace dirt
