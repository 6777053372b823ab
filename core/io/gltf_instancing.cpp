#include "core/io/gltf_instancing.h"

#include "core/io/gltf_transform.h"

#include <algorithm>
#include <cmath>

namespace dirt {

namespace {

std::vector<float> read(const GltfData& data, const JsonValue& attributes, const char* name,
                        size_t components) {
    const auto accessor = attributes.integer(name, JsonValue::kMostIndex);
    if (!accessor) return {};
    std::vector<float> values = data.floats(*accessor, attributes, components);
    if (!std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); }))
        attributes.fail("have a " + std::string(name) + " that is not finite");
    return values;
}

} // namespace

std::optional<std::vector<glm::dmat4>> gltfInstances(const GltfData& data, const JsonValue& node) {
    const auto extensions = node.object("extensions");
    const auto instancing =
        extensions ? extensions->object("EXT_mesh_gpu_instancing") : std::nullopt;
    if (!instancing) return std::nullopt;
    const JsonValue attributes = instancing->required("attributes");
    const auto translations = read(data, attributes, "TRANSLATION", 3);
    const auto rotations = read(data, attributes, "ROTATION", 4);
    const auto scales = read(data, attributes, "SCALE", 3);
    const size_t counts[] = {translations.size() / 3, rotations.size() / 4, scales.size() / 3};
    const size_t count = *std::max_element(std::begin(counts), std::end(counts));
    for (const size_t n : counts)
        if (n != 0 && n != count) attributes.fail("have not all as many elements");

    // These, and what they become.
    data.memory().take(count * 2 * sizeof(glm::dmat4), data.file(), attributes.place());
    std::vector<glm::dmat4> instances;
    instances.reserve(count);
    for (size_t i = 0; i < count; ++i) {
        glm::dvec3 translation(0.0), scale(1.0);
        glm::dquat rotation(1.0, 0.0, 0.0, 0.0);
        if (const float* t = translations.data() + 3 * i; !translations.empty())
            translation = {t[0], t[1], t[2]};
        if (const float* r = rotations.data() + 4 * i; !rotations.empty())
            rotation = {r[3], r[0], r[1], r[2]};
        if (const float* s = scales.data() + 3 * i; !scales.empty()) scale = {s[0], s[1], s[2]};
        instances.push_back(gltfTransform(attributes, translation, rotation, scale));
    }
    return instances;
}

} // namespace dirt
