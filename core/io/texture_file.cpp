#include "core/io/texture_file.h"

#include "core/io/load_report.h"
#include "core/io/png_file.h"
#include "core/io/text_file.h"

#include <cfloat>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace dirt {

namespace {

/// Texels of the largest texture that is read: a damaged header must not cost all memory.
constexpr int64_t kMaxTexels = int64_t(1) << 28;

/// Channels \p first to \p end - 1 of every texel.
template <typename Channel>
std::vector<Channel> readChannels(OIIO::ImageInput& input, int first, int end, OIIO::TypeDesc type,
                                  const std::filesystem::path& file) {
    const OIIO::ImageSpec& spec = input.spec();
    const size_t texels = (size_t) spec.width * (size_t) spec.height;
    std::vector<Channel> read(texels * (size_t) (end - first));
    if (!input.read_image(0, 0, first, end, type, read.data()))
        failAt(file, 0, "damaged image: " + printable(input.geterror()));
    return read;
}

template <typename Channel>
std::vector<Channel> readColour(OIIO::ImageInput& input, OIIO::TypeDesc type,
                                const std::filesystem::path& file) {
    const OIIO::ImageSpec& spec = input.spec();
    if (spec.nchannels >= 3) return readChannels<Channel>(input, 0, 3, type, file);
    const auto read = readChannels<Channel>(input, 0, 1, type, file);
    std::vector<Channel> grey(read.size() * 3);
    for (size_t i = 0; i < grey.size(); ++i) grey[i] = read[i / 3];
    return grey;
}

bool isFloat(OIIO::TypeDesc type) {
    return type == OIIO::TypeDesc::HALF || type == OIIO::TypeDesc::FLOAT ||
           type == OIIO::TypeDesc::DOUBLE;
}

/// A file opened as an image; no input where it is none.
struct OpenImage {
    explicit OpenImage(const std::filesystem::path& file) {
        // Without this, colours come back multiplied by alpha.
        OIIO::ImageSpec config;
        config.attribute("oiio:UnassociatedAlpha", 1);
        const std::string all = readBytes(file);
        if (!isPng(all)) {
            input = OIIO::ImageInput::open(file.string(), &config);
            return;
        }
        bytes = essentialPng(all, file);
        memory.emplace(bytes.data(), bytes.size());
        input = OIIO::ImageInput::create("png");
        OIIO::ImageSpec spec;
        if (input && !(input->set_ioproxy(&*memory) && input->open(file.string(), spec, config)))
            failAt(file, 0, "no readable image: " + printable(input->geterror()));
    }

    std::string bytes;
    std::optional<OIIO::Filesystem::IOMemReader> memory; ///< of bytes
    std::unique_ptr<OIIO::ImageInput> input;             ///< reads from memory, or the file
};

} // namespace

namespace {

/// The header of an image that is not absurd.
OIIO::ImageSpec checkedSpec(const OpenImage& image, const std::filesystem::path& file) {
    const auto& input = image.input;
    if (!input) failAt(file, 0, "no readable image: " + printable(OIIO::geterror()));

    const OIIO::ImageSpec spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || spec.depth > 1 || spec.deep)
        failAt(file, 0, "not a flat image");
    if ((int64_t) spec.width * spec.height > kMaxTexels)
        failAt(file, 0,
               "an image of " + std::to_string(spec.width) + "x" + std::to_string(spec.height) +
                   " is too large");
    return spec;
}

ScalarTexture readScalar(const OpenImage& image, const OIIO::ImageSpec& spec, int channel,
                         const std::filesystem::path& file) {
    if (spec.format == OIIO::TypeDesc::UINT8)
        return ScalarTexture(
            file.string(), spec.width, spec.height,
            readChannels<uint8_t>(*image.input, channel, channel + 1, OIIO::TypeDesc::UINT8, file));
    auto texels =
        readChannels<float>(*image.input, channel, channel + 1, OIIO::TypeDesc::FLOAT, file);
    for (const float value : texels)
        if (!(std::abs(value) <= FLT_MAX)) failAt(file, 0, "damaged image: a texel is not finite");
    return ScalarTexture(file.string(), spec.width, spec.height, std::move(texels));
}

} // namespace

ScalarTexture readScalarTexture(const std::filesystem::path& file) {
    const OpenImage image(file);
    return readScalar(image, checkedSpec(image, file), 0, file);
}

std::optional<ScalarTexture> readAlpha(const std::filesystem::path& file) {
    const OpenImage image(file);
    const OIIO::ImageSpec spec = checkedSpec(image, file);
    if (spec.alpha_channel < 0) return {};
    ScalarTexture alpha = readScalar(image, spec, spec.alpha_channel, file);
    bool cut = false, left = false;
    for (int y = 0; y < spec.height; ++y)
        for (int x = 0; x < spec.width; ++x) (alpha.texel(x, y) < 0.5f ? cut : left) = true;
    if (!cut || !left) return {};
    return alpha;
}

Texture readTexture(const std::filesystem::path& file) {
    const OpenImage image(file);
    const auto& input = image.input;
    const OIIO::ImageSpec spec = checkedSpec(image, file);
    if (!isFloat(spec.format)) {
        auto texels = readColour<uint8_t>(*input, OIIO::TypeDesc::UINT8, file);
        return Texture(file.string(), spec.width, spec.height, std::move(texels));
    }
    auto texels = readColour<float>(*input, OIIO::TypeDesc::FLOAT, file);
    for (const float value : texels)
        if (!(value >= 0.0f && value <= FLT_MAX))
            failAt(file, 0, "damaged image: a texel is negative or not finite");
    return Texture(file.string(), spec.width, spec.height, std::move(texels));
}

} // namespace dirt
