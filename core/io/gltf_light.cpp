#include "core/io/gltf_light.h"

#include "core/io/number.h"

#include <cfloat>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace dirt {

namespace {

constexpr double kPi = std::numbers::pi;

std::optional<JsonValue> punctual(const JsonValue& object) {
    const auto extensions = object.object("extensions");
    return extensions ? extensions->object("KHR_lights_punctual") : std::nullopt;
}

GltfSpotlight readSpotlight(const JsonValue& source) {
    GltfSpotlight light;
    if (const auto color = source.numbers("color", 3))
        for (int i = 0; i < 3; ++i) {
            if ((*color)[(size_t) i] < 0.0) source.fail("has a negative color");
            light.color[i] = (float) (*color)[(size_t) i];
        }
    light.intensity = source.number("intensity", 0.0, FLT_MAX).value_or(1.0);
    light.outer = kPi / 4.0;
    const auto spot = source.object("spot");
    if (!spot) return light;
    light.outer = spot->number("outerConeAngle", 0.0, kPi / 2.0).value_or(light.outer);
    light.inner = spot->number("innerConeAngle", 0.0, light.outer).value_or(0.0);
    if (light.outer == 0.0) spot->fail("has an outerConeAngle of 0");
    return light;
}

} // namespace

Spotlight GltfSpotlight::placed(const glm::dmat4& toWorld,
                                const std::filesystem::path& file) const {
    const glm::dmat4 matrix = toWorld * toFile;
    const glm::dvec3 position(matrix[3]);
    // As far away as the origin, see GltfCamera.
    const double far = glm::length(position) > 0.0 ? glm::length(position) : 1.0;
    const glm::dvec3 target = position - far * glm::normalize(glm::dvec3(matrix[2]));
    // 1 - cos without its cancellation.
    const double flux = intensity * 4.0 * kPi * std::pow(std::sin(0.5 * outer), 2.0);
    if (!fitsFloat(position) || !fitsFloat(target))
        failAt(file, 0, "the spotlight has no place or no direction");
    Spotlight light;
    light.position = glm::vec3(position);
    light.target = glm::vec3(target);
    light.color = color;
    light.flux = roundedFlux(flux);
    light.aperture = (float) (outer * 360.0 / kPi);
    light.penumbra = (float) (inner * 360.0 / kPi);
    light.exponent = 2.0f; // the extension's falloff: linear in the cosine, squared
    return light;
}

GltfLights::GltfLights(const GltfData& data, GltfIgnored& ignored) : ignored_(ignored) {
    if (const auto extension = punctual(data.root())) lights_ = extension->objects("lights");
}

void GltfLights::place(const JsonValue& node, const glm::dmat4& toFile) {
    const auto reference = punctual(node);
    if (!reference) return;
    const uint64_t index = reference->requiredInteger("light", JsonValue::kMostIndex);
    const JsonValue& source = JsonValue::at(lights_, index, *reference, "lights");
    const std::string type = source.text("type").value_or("");
    if (type != "spot") {
        ignored_.add("light of type " + type);
    } else if (spotlight_) {
        ignored_.add("light of type spot after the first");
    } else {
        spotlight_ = readSpotlight(source);
        spotlight_->toFile = toFile;
    }
}

} // namespace dirt
