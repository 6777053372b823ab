#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace dirt {

/// A colour texture: 8-bit sRGB or linear float texels, three channels, first row on top.
class Texture {
public:
    Texture() = default;
    /// \p texels holds width * height * 3 sRGB-encoded bytes.
    Texture(std::string file, int width, int height, std::vector<uint8_t> texels);
    /// \p texels holds width * height * 3 linear values.
    Texture(std::string file, int width, int height, std::vector<float> texels);

    /// Linear Rec.709 at \p uv (v upwards), bilinear between texel centres, repeating.
    glm::vec3 sample(glm::vec2 uv) const;

    /// This texture with each linear texel multiplied by \p factor, in float.
    Texture times(glm::vec3 factor) const;

    const std::string& file() const { return file_; }
    int width() const { return width_; }
    int height() const { return height_; }
    /// Three channels a texel, first row on top: sRGB-encoded bytes or linear floats, the other is
    /// empty.
    std::span<const uint8_t> encodedTexels() const { return bytes_; }
    std::span<const float> linearTexels() const { return floats_; }
    /// The linear value of each sRGB-encoded byte.
    static const std::array<float, 256>& decodedBytes();
    size_t bytes() const { return bytes_.size() + floats_.size() * sizeof(float); }

private:
    glm::vec3 texel(int x, int y) const;

    std::string file_;
    int width_ = 0;
    int height_ = 0;
    std::vector<uint8_t> bytes_;
    std::vector<float> floats_;
};

} // namespace dirt
