#include "core/io/texture_file.h"

#include "core/io/load_report.h"
#include "core/io/png_file.h"
#include "core/io/text_file.h"

#include <cfloat>
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

template <typename Channel>
std::vector<Channel> readChannels(OIIO::ImageInput& input, OIIO::TypeDesc type,
                                  const std::filesystem::path& file) {
    const OIIO::ImageSpec& spec = input.spec();
    const size_t texels = (size_t) spec.width * (size_t) spec.height;
    const int channels = spec.nchannels < 3 ? 1 : 3;
    std::vector<Channel> read(texels * (size_t) channels);
    if (!input.read_image(0, 0, 0, channels, type, read.data()))
        failAt(file, 0, "damaged image: " + printable(input.geterror()));
    if (channels == 3) return read;

    std::vector<Channel> grey(texels * 3);
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

Texture readTexture(const std::filesystem::path& file) {
    const OpenImage image(file);
    const auto& input = image.input;
    if (!input) failAt(file, 0, "no readable image: " + printable(OIIO::geterror()));

    const OIIO::ImageSpec spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || spec.depth > 1 || spec.deep)
        failAt(file, 0, "not a flat image");
    if ((int64_t) spec.width * spec.height > kMaxTexels)
        failAt(file, 0,
               "an image of " + std::to_string(spec.width) + "x" + std::to_string(spec.height) +
                   " is too large");

    if (!isFloat(spec.format)) {
        auto texels = readChannels<uint8_t>(*input, OIIO::TypeDesc::UINT8, file);
        return Texture(file.string(), spec.width, spec.height, std::move(texels));
    }
    auto texels = readChannels<float>(*input, OIIO::TypeDesc::FLOAT, file);
    for (const float value : texels)
        if (!(value >= 0.0f && value <= FLT_MAX))
            failAt(file, 0, "damaged image: a texel is negative or not finite");
    return Texture(file.string(), spec.width, spec.height, std::move(texels));
}

} // namespace dirt
