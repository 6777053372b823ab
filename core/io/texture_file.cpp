#include "core/io/texture_file.h"

#include "core/io/image_reader.h"
#include "core/io/load_report.h"
#include "core/io/text_file.h"
#include "core/scene/srgb.h"
#include "shaders/shared/radiance.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <OpenImageIO/imageio.h>

namespace dirt {

namespace {

bool isFloat(OIIO::TypeDesc type) {
    return type == OIIO::TypeDesc::HALF || type == OIIO::TypeDesc::FLOAT ||
           type == OIIO::TypeDesc::DOUBLE;
}

template <typename Channel>
const OIIO::TypeDesc kType = OIIO::TypeDesc::UINT8;
template <>
const OIIO::TypeDesc kType<float> = OIIO::TypeDesc::FLOAT;

} // namespace

/// An opened image, and its texels when they are first asked for.
struct DecodedImage::Pixels {
    Pixels(const ImageFile& file, const MemoryBudget& budget)
        : memory(budget),
          reader(file.bytes ? file.bytes
                            : std::make_shared<const std::string>(readBytes(file.name, memory)),
                 file.name),
          name(reader.name()), spec(reader.spec()) {}

    uint64_t texels() const { return (uint64_t) spec.width * (uint64_t) spec.height; }

    /// Takes so many bytes a texel of what is made of the image and kept.
    void keep(uint64_t bytes) const { memory.budget().spend(texels() * bytes, name, sizeText()); }
    std::string sizeText() const {
        return "an image of " + std::to_string(spec.width) + "x" + std::to_string(spec.height) +
               " texels";
    }

    /// All channels of every texel.
    template <typename Channel>
    const std::vector<Channel>& all() {
        std::vector<Channel>& texels = std::get<std::vector<Channel>>(decoded);
        if (!texels.empty()) return texels;
        // The decoder has all samples once, too.
        memory.take(this->texels() * (uint64_t) spec.nchannels *
                        (sizeof(Channel) + spec.format.size()),
                    name, sizeText());
        std::vector<Channel> read((size_t) spec.width * (size_t) spec.height *
                                  (size_t) spec.nchannels);
        reader.read(0, spec.nchannels, kType<Channel>, read.data());
        return texels = std::move(read);
    }

    /// Three channels of every texel, to be kept.
    template <typename Channel>
    std::vector<Channel> colours() {
        const std::vector<Channel>& from = all<Channel>();
        keep(3 * sizeof(Channel));
        const auto channels = (size_t) spec.nchannels;
        if (channels == 3) return from;
        const size_t step = channels >= 3 ? 1 : 0;
        std::vector<Channel> texels(from.size() / channels * 3);
        for (size_t i = 0, at = 0; i < texels.size(); i += 3, at += channels)
            for (size_t c = 0; c < 3; ++c) texels[i + c] = from[at + c * step];
        return texels;
    }

    /// Takes numbers beyond two ends for the nearer end, and a NaN for 0, and says so in `fault`.
    std::vector<float> confined(std::vector<float> texels, float least, float most) {
        size_t count = 0;
        for (float& value : texels) {
            if (value >= least && value <= most) continue;
            value = std::isnan(value) ? 0.0f : std::clamp(value, least, most);
            ++count;
        }
        if (count == 0) return texels;
        char text[160];
        if (least < 0.0f)
            std::snprintf(text, sizeof text,
                          "%zu numbers are not finite: a NaN is taken for 0, an infinity for %g",
                          count, (double) most);
        else
            std::snprintf(text, sizeof text,
                          "%zu numbers are not from 0 to %g: the nearest is taken, for a NaN 0",
                          count, (double) most);
        fault = text;
        return texels;
    }

    std::vector<float> finite(std::vector<float> texels) {
        return confined(std::move(texels), -FLT_MAX, FLT_MAX);
    }

    template <typename Channel>
    std::vector<Channel> one(int channel) {
        const std::vector<Channel>& from = all<Channel>();
        keep(sizeof(Channel));
        if (spec.nchannels == 1) return from;
        std::vector<Channel> texels(from.size() / (size_t) spec.nchannels);
        for (size_t i = 0; i < texels.size(); ++i)
            texels[i] = from[i * (size_t) spec.nchannels + (size_t) channel];
        return texels;
    }

    ScalarTexture scalars(int channel) {
        if (spec.format == OIIO::TypeDesc::UINT8)
            return ScalarTexture(name.string(), spec.width, spec.height, one<uint8_t>(channel));
        return ScalarTexture(name.string(), spec.width, spec.height, finite(one<float>(channel)));
    }

    MemoryClaim memory;
    ImageReader reader;
    const std::filesystem::path& name;
    const OIIO::ImageSpec& spec;
    std::tuple<std::vector<uint8_t>, std::vector<float>> decoded;
    std::string fault; ///< of what was read last
};

DecodedImage::DecodedImage(const ImageFile& file, const MemoryBudget& budget)
    : pixels_(std::make_unique<Pixels>(file, budget)) {}

DecodedImage::~DecodedImage() = default;

std::string DecodedImage::takeFault() const {
    return std::exchange(pixels_->fault, {});
}

Texture readTexture(const DecodedImage& image) {
    DecodedImage::Pixels& pixels = image.pixels();
    const std::string name = pixels.name.string();
    const int width = pixels.spec.width, height = pixels.spec.height;
    if (pixels.spec.format == OIIO::TypeDesc::UINT8)
        return Texture(name, width, height, pixels.colours<uint8_t>());
    auto texels = pixels.colours<float>();
    if (!isFloat(pixels.spec.format)) // of more bits than a byte's curve keeps
        for (float& value : texels) value = (float) decodeSrgb(value);
    return Texture(name, width, height, pixels.confined(std::move(texels), 0.0f, kMostRadiance));
}

Texture readDataTexture(const DecodedImage& image) {
    DecodedImage::Pixels& pixels = image.pixels();
    const std::string name = pixels.name.string();
    const int width = pixels.spec.width, height = pixels.spec.height;
    if (pixels.spec.format == OIIO::TypeDesc::UINT8)
        return Texture(name, width, height, pixels.colours<uint8_t>(), TexelEncoding::linear);
    return Texture(name, width, height, pixels.finite(pixels.colours<float>()));
}

namespace {

/// Whether the three colours are the same everywhere in an 8-bit image, or it has one alone.
bool isGrey(DecodedImage::Pixels& pixels) {
    if (pixels.spec.nchannels < 3) return true;
    if (pixels.spec.format != OIIO::TypeDesc::UINT8) return false;
    const auto& texels = pixels.all<uint8_t>();
    for (size_t i = 0; i < texels.size(); i += (size_t) pixels.spec.nchannels)
        if (texels[i] != texels[i + 1] || texels[i] != texels[i + 2]) return false;
    return true;
}

/// See isNormalMap; \p scale brings channels to [0, 1].
template <typename Channel>
bool pointsOutwards(const std::vector<Channel>& texels, size_t channels, double scale) {
    double fromGrey = 0.0, fromUnit = 0.0, height = 0.0;
    for (size_t i = 0; i < texels.size(); i += channels) {
        glm::dvec3 v;
        for (int c = 0; c < 3; ++c) v[c] = 2.0 * scale * (double) texels[i + (size_t) c] - 1.0;
        const double square = glm::dot(v, v), sum = v.x + v.y + v.z;
        fromGrey += square - sum * sum / 3.0;
        fromUnit += (std::sqrt(square) - 1.0) * (std::sqrt(square) - 1.0);
        height += v.z;
    }
    return height > 0.0 && fromUnit < fromGrey;
}

} // namespace

bool isNormalMap(const DecodedImage& image) {
    DecodedImage::Pixels& pixels = image.pixels();
    const auto channels = (size_t) pixels.spec.nchannels;
    if (channels < 3) return false;
    if (pixels.spec.format == OIIO::TypeDesc::UINT8)
        return pointsOutwards(pixels.all<uint8_t>(), channels, 1.0 / 255.0);
    return pointsOutwards(pixels.all<float>(), channels, 1.0);
}

ScalarTexture readScalarTexture(const DecodedImage& image, ImageChannel channel) {
    DecodedImage::Pixels& pixels = image.pixels();
    const std::string name = pixels.name.string();
    const int width = pixels.spec.width, height = pixels.spec.height;
    const bool weighted = channel == ImageChannel::luminance || channel == ImageChannel::mean;
    if (weighted && isGrey(pixels)) return pixels.scalars(0);
    if (weighted) {
        const glm::vec3 weights = channel == ImageChannel::mean
                                      ? glm::vec3(1.0f / 3.0f)
                                      : glm::vec3(0.2126f, 0.7152f, 0.0722f);
        const auto colours = pixels.finite(pixels.colours<float>());
        std::vector<float> texels(colours.size() / 3);
        for (size_t i = 0; i < texels.size(); ++i)
            texels[i] = std::clamp(colours[3 * i] * weights.x + colours[3 * i + 1] * weights.y +
                                       colours[3 * i + 2] * weights.z,
                                   -FLT_MAX, FLT_MAX);
        return ScalarTexture(name, width, height, std::move(texels));
    }
    if (channel == ImageChannel::alpha) {
        if (pixels.spec.alpha_channel >= 0) return pixels.scalars(pixels.spec.alpha_channel);
        return ScalarTexture(name, 1, 1, std::vector<uint8_t>{255});
    }
    return pixels.scalars(pixels.spec.nchannels >= 3 ? (int) channel : 0);
}

namespace {

/// Of all texels.
std::pair<float, float> leastAndMost(const ScalarTexture& texture) {
    std::pair<float, float> range(texture.texel(0, 0), texture.texel(0, 0));
    for (int y = 0; y < texture.height(); ++y)
        for (int x = 0; x < texture.width(); ++x) {
            range.first = std::min(range.first, texture.texel(x, y));
            range.second = std::max(range.second, texture.texel(x, y));
        }
    return range;
}

} // namespace

std::optional<ScalarTexture> readAlpha(const DecodedImage& image) {
    DecodedImage::Pixels& pixels = image.pixels();
    if (pixels.spec.alpha_channel < 0) return {};
    ScalarTexture alpha = pixels.scalars(pixels.spec.alpha_channel);
    const auto [least, most] = leastAndMost(alpha);
    if (least == most) return {};
    return alpha;
}

bool cutsOut(const ScalarTexture& alpha, float limit) {
    const auto [least, most] = leastAndMost(alpha);
    return least < limit && most >= limit;
}

} // namespace dirt
