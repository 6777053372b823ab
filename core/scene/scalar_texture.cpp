#include "core/scene/scalar_texture.h"

#include <cassert>
#include <utility>

namespace dirt {

ScalarTexture::ScalarTexture(std::string file, int width, int height, std::vector<uint8_t> texels)
    : file_(std::move(file)), width_(width), height_(height) {
    assert(texels.size() == (size_t) width_ * (size_t) height_);
    const auto shared = std::make_shared<const std::vector<uint8_t>>(std::move(texels));
    texels_ = shared;
    bytes_ = *shared;
}

ScalarTexture::ScalarTexture(std::string file, int width, int height, std::vector<float> texels)
    : file_(std::move(file)), width_(width), height_(height) {
    assert(texels.size() == (size_t) width_ * (size_t) height_);
    const auto shared = std::make_shared<const std::vector<float>>(std::move(texels));
    texels_ = shared;
    floats_ = *shared;
    if (!floats_.empty()) range_ = TexelRange(floats_);
}

ScalarTexture ScalarTexture::with(const TextureSampling& sampling) const {
    ScalarTexture texture = *this;
    texture.sampling_ = sampling;
    return texture;
}

float ScalarTexture::texel(int x, int y) const {
    const size_t i = (size_t) y * (size_t) width_ + (size_t) x;
    return floats_.empty() ? (float) bytes_[i] / 255.0f : floats_[i];
}

/// At \p uv of the image.
float ScalarTexture::sampleImage(glm::vec2 uv) const {
    const TexelPair x = columnsAround(uv.x, width_, (uint32_t) sampling_.wrapU);
    const TexelPair y = rowsAround(uv.y, height_, (uint32_t) sampling_.wrapV);
    const float upper = blend(texel(x.first, y.first), texel(x.second, y.first), x.weight);
    const float lower = blend(texel(x.first, y.second), texel(x.second, y.second), x.weight);
    return blend(upper, lower, y.weight);
}

float ScalarTexture::sample(glm::vec2 uv) const {
    return sampleImage(sampling_.imageCoordinates(uv));
}

glm::vec2 ScalarTexture::slopes(glm::vec2 uv) const {
    const glm::vec2 at = sampling_.imageCoordinates(uv);
    const float u = 0.5f / (float) width_, v = 0.5f / (float) height_;
    return {sampleImage({at.x + u, at.y}) - sampleImage({at.x - u, at.y}),
            sampleImage({at.x, at.y + v}) - sampleImage({at.x, at.y - v})};
}

} // namespace dirt
