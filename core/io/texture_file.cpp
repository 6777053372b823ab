#include "core/io/texture_file.h"

#include "core/io/load_report.h"
#include "core/io/png_file.h"
#include "core/io/text_file.h"

#include <cfloat>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace dirt {

namespace {

/// Texels of the largest texture that is read: a damaged header must not cost all memory.
constexpr int64_t kMaxTexels = int64_t(1) << 28;

bool isFloat(OIIO::TypeDesc type) {
    return type == OIIO::TypeDesc::HALF || type == OIIO::TypeDesc::FLOAT ||
           type == OIIO::TypeDesc::DOUBLE;
}

/// Without this, colours come back multiplied by alpha.
const OIIO::ImageSpec kConfig = [] {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    return config;
}();

template <typename Channel>
const OIIO::TypeDesc kType = OIIO::TypeDesc::UINT8;
template <>
const OIIO::TypeDesc kType<float> = OIIO::TypeDesc::FLOAT;

} // namespace

/// A file opened as an image that is not absurd, and its texels when they are first asked for.
struct DecodedImage::Pixels {
    explicit Pixels(const ImageFile& file) : name(file.name) {
        bytes = file.bytes ? *file.bytes : readBytes(name);
        if (isPng(bytes)) {
            bytes = essentialPng(bytes, name);
            openBytes("png");
        } else if (!file.bytes) {
            input = OIIO::ImageInput::open(name.string(), &kConfig);
        } else if (bytes.starts_with("\xff\xd8")) {
            openBytes("jpeg");
        } else {
            failAt(name, 0, "is neither PNG nor JPEG");
        }
        if (!input) failAt(name, 0, "no readable image: " + printable(OIIO::geterror()));
        spec = input->spec();
        if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || spec.depth > 1 || spec.deep)
            failAt(name, 0, "not a flat image");
        const int64_t texels = (int64_t) spec.width * spec.height;
        if (texels > kMaxTexels || texels * spec.nchannels > 4 * kMaxTexels)
            failAt(name, 0,
                   "an image of " + std::to_string(spec.width) + "x" + std::to_string(spec.height) +
                       (texels > kMaxTexels ? "" : " with as many channels") + " is too large");
    }

    void openBytes(const char* format) {
        memory.emplace(bytes.data(), bytes.size());
        input = OIIO::ImageInput::create(format);
        OIIO::ImageSpec ignored;
        if (input &&
            !(input->set_ioproxy(&*memory) && input->open(name.string(), ignored, kConfig)))
            failAt(name, 0, "no readable image: " + printable(input->geterror()));
    }

    /// All channels of every texel.
    template <typename Channel>
    const std::vector<Channel>& all() {
        std::vector<Channel>& texels = std::get<std::vector<Channel>>(decoded);
        if (!texels.empty()) return texels;
        std::vector<Channel> read((size_t) spec.width * (size_t) spec.height *
                                  (size_t) spec.nchannels);
        if (!input->read_image(0, 0, 0, spec.nchannels, kType<Channel>, read.data()))
            failAt(name, 0, "damaged image: " + printable(input->geterror()));
        return texels = std::move(read);
    }

    /// Three channels of every texel.
    template <typename Channel>
    std::vector<Channel> colours() {
        const std::vector<Channel>& from = all<Channel>();
        const auto channels = (size_t) spec.nchannels;
        if (channels == 3) return from;
        const size_t step = channels >= 3 ? 1 : 0;
        std::vector<Channel> texels(from.size() / channels * 3);
        for (size_t i = 0, at = 0; i < texels.size(); i += 3, at += channels)
            for (size_t c = 0; c < 3; ++c) texels[i + c] = from[at + c * step];
        return texels;
    }

    template <typename Channel>
    std::vector<Channel> one(int channel) {
        const std::vector<Channel>& from = all<Channel>();
        if (spec.nchannels == 1) return from;
        std::vector<Channel> texels(from.size() / (size_t) spec.nchannels);
        for (size_t i = 0; i < texels.size(); ++i)
            texels[i] = from[i * (size_t) spec.nchannels + (size_t) channel];
        return texels;
    }

    ScalarTexture scalars(int channel) {
        if (spec.format == OIIO::TypeDesc::UINT8)
            return ScalarTexture(name.string(), spec.width, spec.height, one<uint8_t>(channel));
        auto texels = one<float>(channel);
        for (const float value : texels)
            if (!(std::abs(value) <= FLT_MAX))
                failAt(name, 0, "damaged image: a texel is not finite");
        return ScalarTexture(name.string(), spec.width, spec.height, std::move(texels));
    }

    std::filesystem::path name;
    std::string bytes;
    std::optional<OIIO::Filesystem::IOMemReader> memory; ///< of bytes
    std::unique_ptr<OIIO::ImageInput> input;             ///< reads from memory, or the file
    OIIO::ImageSpec spec;
    std::tuple<std::vector<uint8_t>, std::vector<float>> decoded;
};

DecodedImage::DecodedImage(const ImageFile& file) : pixels_(std::make_unique<Pixels>(file)) {}

DecodedImage::~DecodedImage() = default;

Texture readTexture(const DecodedImage& image) {
    DecodedImage::Pixels& pixels = image.pixels();
    const std::string name = pixels.name.string();
    const int width = pixels.spec.width, height = pixels.spec.height;
    if (!isFloat(pixels.spec.format))
        return Texture(name, width, height, pixels.colours<uint8_t>());
    auto texels = pixels.colours<float>();
    for (const float value : texels)
        if (!(value >= 0.0f && value <= FLT_MAX))
            failAt(pixels.name, 0, "damaged image: a texel is negative or not finite");
    return Texture(name, width, height, std::move(texels));
}

ScalarTexture readScalarTexture(const DecodedImage& image) {
    return image.pixels().scalars(0);
}

std::optional<ScalarTexture> readAlpha(const DecodedImage& image, float limit) {
    DecodedImage::Pixels& pixels = image.pixels();
    if (pixels.spec.alpha_channel < 0) return {};
    ScalarTexture alpha = pixels.scalars(pixels.spec.alpha_channel);
    bool cut = false, left = false;
    for (int y = 0; y < alpha.height(); ++y)
        for (int x = 0; x < alpha.width(); ++x) (alpha.texel(x, y) < limit ? cut : left) = true;
    if (!cut || !left) return {};
    return alpha;
}

glm::vec3 readMeans(const DecodedImage& image) {
    const auto texels = image.pixels().colours<float>();
    double sums[3] = {};
    for (size_t i = 0; i < texels.size(); ++i) sums[i % 3] += texels[i];
    const double count = (double) (texels.size() / 3);
    return {(float) (sums[0] / count), (float) (sums[1] / count), (float) (sums[2] / count)};
}

} // namespace dirt
