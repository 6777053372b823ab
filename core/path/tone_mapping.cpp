#include "core/path/tone_mapping.h"

#include "shaders/shared/tone_curve.h"

#include <cmath>

namespace dirt {

namespace {

uint8_t toByte(float value) {
    if (!(value > 0.0f)) return 0; // NaN, too
    if (value > 1.0f) return 255;
    return (uint8_t) (value * 255.0f + 0.5f);
}

} // namespace

DisplayEncoding::DisplayEncoding(const ToneMapping& toneMapping)
    : gain_((float) std::pow(10.0, (double) toneMapping.key)),
      scale_(1.0f / naturalLog(1.0001f + gain_ * toneMapping.white)) {}

glm::vec3 DisplayEncoding::operator()(glm::vec3 radiance) const {
    return toneMap(radiance, gain_, scale_);
}

std::vector<uint8_t> DisplayEncoding::bytes(std::span<const glm::vec3> radiance) const {
    std::vector<uint8_t> result;
    result.reserve(radiance.size() * 3);
    for (const glm::vec3& pixel : radiance) {
        const glm::vec3 display = (*this)(pixel);
        for (int channel = 0; channel < 3; ++channel) result.push_back(toByte(display[channel]));
    }
    return result;
}

} // namespace dirt
