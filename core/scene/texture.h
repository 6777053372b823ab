#pragma once

#include <cstdint>
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

    const std::string& file() const { return file_; }
    int width() const { return width_; }
    int height() const { return height_; }
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
