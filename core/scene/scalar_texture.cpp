#include "core/scene/scalar_texture.h"

#include "shaders/shared/texture_lookup.h"

#include <cassert>
#include <utility>

namespace dirt {

ScalarTexture::ScalarTexture(std::string file, int width, int height, std::vector<uint8_t> texels)
    : file_(std::move(file)), width_(width), height_(height), bytes_(std::move(texels)) {
    assert(bytes_.size() == (size_t) width_ * (size_t) height_);
}

ScalarTexture::ScalarTexture(std::string file, int width, int height, std::vector<float> texels)
    : file_(std::move(file)), width_(width), height_(height), floats_(std::move(texels)) {
    assert(floats_.size() == (size_t) width_ * (size_t) height_);
}

float ScalarTexture::texel(int x, int y) const {
    const size_t i = (size_t) y * (size_t) width_ + (size_t) x;
    return floats_.empty() ? (float) bytes_[i] / 255.0f : floats_[i];
}

float ScalarTexture::sample(glm::vec2 uv) const {
    const TexelPair x = texelsAround(uv.x, width_);
    const TexelPair y = texelsAround(-uv.y, height_); // v upwards, rows downwards
    const float upper = blend(texel(x.first, y.first), texel(x.second, y.first), x.weight);
    const float lower = blend(texel(x.first, y.second), texel(x.second, y.second), x.weight);
    return blend(upper, lower, y.weight);
}

glm::vec2 ScalarTexture::slopes(glm::vec2 uv) const {
    const float u = 0.5f / (float) width_, v = 0.5f / (float) height_;
    return {sample({uv.x + u, uv.y}) - sample({uv.x - u, uv.y}),
            sample({uv.x, uv.y + v}) - sample({uv.x, uv.y - v})};
}

} // namespace dirt
