#include "core/scene/texture.h"

#include "core/scene/srgb.h"
#include "shaders/shared/texture_lookup.h"

#include <cassert>
#include <cmath>
#include <utility>

namespace dirt {

namespace {

/// sRGB byte to linear (IEC 61966-2-1), in double and rounded once.
std::array<float, 256> makeDecodeTable() {
    std::array<float, 256> table;
    for (int i = 0; i < 256; ++i) table[(size_t) i] = (float) decodeSrgb(i / 255.0);
    return table;
}

const std::array<float, 256> kDecode = makeDecodeTable();

} // namespace

Texture::Texture(std::string file, int width, int height, std::vector<uint8_t> texels)
    : file_(std::move(file)), width_(width), height_(height), bytes_(std::move(texels)) {
    assert(bytes_.size() == (size_t) width_ * (size_t) height_ * 3);
}

Texture::Texture(std::string file, int width, int height, std::vector<float> texels)
    : file_(std::move(file)), width_(width), height_(height), floats_(std::move(texels)) {
    assert(floats_.size() == (size_t) width_ * (size_t) height_ * 3);
}

const std::array<float, 256>& Texture::decodedBytes() {
    return kDecode;
}

glm::vec3 Texture::texel(int x, int y) const {
    const size_t i = ((size_t) y * (size_t) width_ + (size_t) x) * 3;
    if (floats_.empty())
        return {kDecode[bytes_[i]], kDecode[bytes_[i + 1]], kDecode[bytes_[i + 2]]};
    return {floats_[i], floats_[i + 1], floats_[i + 2]};
}

glm::vec3 Texture::sample(glm::vec2 uv) const {
    const TexelPair x = texelsAround(uv.x, width_);
    const TexelPair y = texelsAround(-uv.y, height_); // v upwards, rows downwards
    const glm::vec3 upper = blend(texel(x.first, y.first), texel(x.second, y.first), x.weight);
    const glm::vec3 lower = blend(texel(x.first, y.second), texel(x.second, y.second), x.weight);
    return blend(upper, lower, y.weight);
}

Texture Texture::times(glm::vec3 factor) const {
    std::vector<float> texels;
    texels.reserve((size_t) width_ * (size_t) height_ * 3);
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x) {
            const glm::vec3 product = texel(x, y) * factor;
            texels.insert(texels.end(), {product.x, product.y, product.z});
        }
    return Texture(file_, width_, height_, std::move(texels));
}

} // namespace dirt
