#pragma once

#include "core/scene/texel_range.h"
#include "core/scene/texture_sampling.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace dirt {

/// A texture of data, one number a texel: 8-bit, where 255 is 1, or float; first row on top. Copies
/// share their texels.
class ScalarTexture {
public:
    ScalarTexture() = default;
    /// \p texels holds width * height bytes.
    ScalarTexture(std::string file, int width, int height, std::vector<uint8_t> texels);
    /// \p texels holds width * height values.
    ScalarTexture(std::string file, int width, int height, std::vector<float> texels);

    /// This texture, sharing its texels, looked up as \p sampling says.
    ScalarTexture with(const TextureSampling& sampling) const;

    /// The value at \p uv of a mesh (v upwards), bilinear between texel centres.
    float sample(glm::vec2 uv) const;

    /// How the value grows along the image's u and v at \p uv of a mesh, over one texel each.
    glm::vec2 slopes(glm::vec2 uv) const;

    const std::string& file() const { return file_; }
    int width() const { return width_; }
    int height() const { return height_; }
    const TextureSampling& sampling() const { return sampling_; }
    const TexelRange& range() const { return range_; }
    /// Of the texels, whoever shares them.
    size_t bytes() const { return bytes_.size_bytes() + floats_.size_bytes(); }
    /// The same of textures that share their texels, and of no others.
    const void* identity() const { return texels_.get(); }

    float texel(int x, int y) const;

private:
    float sampleImage(glm::vec2 uv) const;

    std::string file_;
    int width_ = 0;
    int height_ = 0;
    TextureSampling sampling_;
    TexelRange range_;
    std::shared_ptr<const void> texels_; ///< keeps what the spans show
    std::span<const uint8_t> bytes_;
    std::span<const float> floats_;
};

} // namespace dirt
