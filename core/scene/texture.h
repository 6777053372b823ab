#pragma once

#include "core/scene/texel_range.h"
#include "core/scene/texture_sampling.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace dirt {

/// What a byte stands for.
enum class TexelEncoding {
    srgb,  ///< a colour, by the curve of sRGB
    linear ///< data: 255 is 1
};

/// A texture of three channels: 8-bit or linear float texels, first row on top. Copies share their
/// texels.
class Texture {
public:
    Texture() = default;
    /// \p texels holds width * height * 3 bytes.
    Texture(std::string file, int width, int height, std::vector<uint8_t> texels,
            TexelEncoding encoding = TexelEncoding::srgb);
    /// \p texels holds width * height * 3 linear values.
    Texture(std::string file, int width, int height, std::vector<float> texels);

    /// This texture, sharing its texels, looked up as \p sampling says.
    Texture with(const TextureSampling& sampling) const;

    /// Linear Rec.709, or data, at \p uv of a mesh (v upwards), bilinear between texel centres.
    glm::vec3 sample(glm::vec2 uv) const;

    const std::string& file() const { return file_; }
    int width() const { return width_; }
    int height() const { return height_; }
    const TextureSampling& sampling() const { return sampling_; }
    TexelEncoding encoding() const { return encoding_; }
    /// Three channels a texel, first row on top: bytes or linear floats, the other is empty.
    std::span<const uint8_t> encodedTexels() const { return bytes_; }
    std::span<const float> linearTexels() const { return floats_; }
    /// The linear value of each byte.
    static const std::array<float, 256>& decodedBytes(TexelEncoding encoding);
    const TexelRange& range() const { return range_; }
    /// Of the texels, whoever shares them.
    size_t bytes() const { return bytes_.size_bytes() + floats_.size_bytes(); }
    /// The same of textures that share their texels, and of no others.
    const void* identity() const { return texels_.get(); }

private:
    glm::vec3 texel(int x, int y) const;

    std::string file_;
    int width_ = 0;
    int height_ = 0;
    TexelEncoding encoding_ = TexelEncoding::srgb;
    TextureSampling sampling_;
    TexelRange range_;
    std::shared_ptr<const void> texels_; ///< keeps what the spans show
    std::span<const uint8_t> bytes_;
    std::span<const float> floats_;
    const float* decoded_ = nullptr; ///< decodedBytes
};

} // namespace dirt
