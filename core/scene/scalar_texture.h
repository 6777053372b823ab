#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace dirt {

/// A texture of data, one number a texel: 8-bit, where 255 is 1, or float; first row on top.
class ScalarTexture {
public:
    ScalarTexture() = default;
    /// \p texels holds width * height bytes.
    ScalarTexture(std::string file, int width, int height, std::vector<uint8_t> texels);
    /// \p texels holds width * height values.
    ScalarTexture(std::string file, int width, int height, std::vector<float> texels);

    /// The value at \p uv (v upwards), bilinear between texel centres, repeating.
    float sample(glm::vec2 uv) const;

    /// How the value grows along u and v at \p uv, over one texel each.
    glm::vec2 slopes(glm::vec2 uv) const;

    const std::string& file() const { return file_; }
    int width() const { return width_; }
    int height() const { return height_; }
    size_t bytes() const { return bytes_.size() + floats_.size() * sizeof(float); }

    float texel(int x, int y) const;

private:
    std::string file_;
    int width_ = 0;
    int height_ = 0;
    std::vector<uint8_t> bytes_;
    std::vector<float> floats_;
};

} // namespace dirt
