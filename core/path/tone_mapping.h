#pragma once

#include "core/scene/camera.h"

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace dirt {

/// The display encoding of radiance: the value of HSV goes through the tone curve.
class DisplayEncoding {
public:
    explicit DisplayEncoding(const ToneMapping& toneMapping);

    /// Display values; above 1 where the radiance is beyond white.
    glm::vec3 operator()(glm::vec3 radiance) const;

    /// 8-bit R, G, B for every pixel, clamped and rounded to nearest.
    std::vector<uint8_t> bytes(std::span<const glm::vec3> radiance) const;

private:
    float gain_, scale_;
};

} // namespace dirt
