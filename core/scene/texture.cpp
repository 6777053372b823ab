#include "core/scene/texture.h"

#include "core/scene/srgb.h"

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

std::array<float, 256> makeLinearTable() {
    std::array<float, 256> table;
    for (int i = 0; i < 256; ++i) table[(size_t) i] = (float) i / 255.0f;
    return table;
}

const std::array<float, 256> kDecode = makeDecodeTable(), kLinear = makeLinearTable();

} // namespace

Texture::Texture(std::string file, int width, int height, std::vector<uint8_t> texels,
                 TexelEncoding encoding)
    : file_(std::move(file)), width_(width), height_(height), encoding_(encoding),
      decoded_(decodedBytes(encoding).data()) {
    assert(texels.size() == (size_t) width_ * (size_t) height_ * 3);
    const auto shared = std::make_shared<const std::vector<uint8_t>>(std::move(texels));
    texels_ = shared;
    bytes_ = *shared;
}

Texture::Texture(std::string file, int width, int height, std::vector<float> texels)
    : file_(std::move(file)), width_(width), height_(height) {
    assert(texels.size() == (size_t) width_ * (size_t) height_ * 3);
    const auto shared = std::make_shared<const std::vector<float>>(std::move(texels));
    texels_ = shared;
    floats_ = *shared;
    if (!floats_.empty()) range_ = TexelRange(floats_);
}

Texture Texture::with(const TextureSampling& sampling) const {
    Texture texture = *this;
    texture.sampling_ = sampling;
    return texture;
}

const std::array<float, 256>& Texture::decodedBytes(TexelEncoding encoding) {
    return encoding == TexelEncoding::srgb ? kDecode : kLinear;
}

glm::vec3 Texture::texel(int x, int y) const {
    const size_t i = ((size_t) y * (size_t) width_ + (size_t) x) * 3;
    if (floats_.empty())
        return {decoded_[bytes_[i]], decoded_[bytes_[i + 1]], decoded_[bytes_[i + 2]]};
    return {floats_[i], floats_[i + 1], floats_[i + 2]};
}

glm::vec3 Texture::sample(glm::vec2 uv) const {
    const glm::vec2 at = sampling_.imageCoordinates(uv);
    const TexelPair x = columnsAround(at.x, width_, (uint32_t) sampling_.wrapU);
    const TexelPair y = rowsAround(at.y, height_, (uint32_t) sampling_.wrapV);
    const glm::vec3 upper = blend(texel(x.first, y.first), texel(x.second, y.first), x.weight);
    const glm::vec3 lower = blend(texel(x.first, y.second), texel(x.second, y.second), x.weight);
    return blend(upper, lower, y.weight);
}

} // namespace dirt
