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

/// A file opened as an image that is not absurd.
struct OpenImage {
    explicit OpenImage(const ImageFile& file) : name(file.name) {
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
        if ((int64_t) spec.width * spec.height > kMaxTexels)
            failAt(name, 0,
                   "an image of " + std::to_string(spec.width) + "x" + std::to_string(spec.height) +
                       " is too large");
    }

    void openBytes(const char* format) {
        memory.emplace(bytes.data(), bytes.size());
        input = OIIO::ImageInput::create(format);
        OIIO::ImageSpec ignored;
        if (input &&
            !(input->set_ioproxy(&*memory) && input->open(name.string(), ignored, kConfig)))
            failAt(name, 0, "no readable image: " + printable(input->geterror()));
    }

    /// Channels \p first to \p end - 1 of every texel.
    template <typename Channel>
    std::vector<Channel> channels(int first, int end, OIIO::TypeDesc type) const {
        const size_t texels = (size_t) spec.width * (size_t) spec.height;
        std::vector<Channel> read(texels * (size_t) (end - first));
        if (!input->read_image(0, 0, first, end, type, read.data()))
            failAt(name, 0, "damaged image: " + printable(input->geterror()));
        return read;
    }

    /// Three channels of every texel.
    template <typename Channel>
    std::vector<Channel> colours(OIIO::TypeDesc type) const {
        if (spec.nchannels >= 3) return channels<Channel>(0, 3, type);
        const auto read = channels<Channel>(0, 1, type);
        std::vector<Channel> grey(read.size() * 3);
        for (size_t i = 0; i < grey.size(); ++i) grey[i] = read[i / 3];
        return grey;
    }

    ScalarTexture scalars(int channel) const {
        if (spec.format == OIIO::TypeDesc::UINT8)
            return ScalarTexture(name.string(), spec.width, spec.height,
                                 channels<uint8_t>(channel, channel + 1, OIIO::TypeDesc::UINT8));
        auto texels = channels<float>(channel, channel + 1, OIIO::TypeDesc::FLOAT);
        for (const float value : texels)
            if (!(std::abs(value) <= FLT_MAX))
                failAt(name, 0, "damaged image: a texel is not finite");
        return ScalarTexture(name.string(), spec.width, spec.height, std::move(texels));
    }

    const std::filesystem::path& name;
    std::string bytes;
    std::optional<OIIO::Filesystem::IOMemReader> memory; ///< of bytes
    std::unique_ptr<OIIO::ImageInput> input;             ///< reads from memory, or the file
    OIIO::ImageSpec spec;
};

} // namespace

Texture readTexture(const ImageFile& file) {
    const OpenImage image(file);
    const std::string name = file.name.string();
    const int width = image.spec.width, height = image.spec.height;
    if (!isFloat(image.spec.format))
        return Texture(name, width, height, image.colours<uint8_t>(OIIO::TypeDesc::UINT8));
    auto texels = image.colours<float>(OIIO::TypeDesc::FLOAT);
    for (const float value : texels)
        if (!(value >= 0.0f && value <= FLT_MAX))
            failAt(file.name, 0, "damaged image: a texel is negative or not finite");
    return Texture(name, width, height, std::move(texels));
}

ScalarTexture readScalarTexture(const ImageFile& file) {
    return OpenImage(file).scalars(0);
}

std::optional<ScalarTexture> readAlpha(const ImageFile& file, float limit) {
    const OpenImage image(file);
    if (image.spec.alpha_channel < 0) return {};
    ScalarTexture alpha = image.scalars(image.spec.alpha_channel);
    bool cut = false, left = false;
    for (int y = 0; y < alpha.height(); ++y)
        for (int x = 0; x < alpha.width(); ++x) (alpha.texel(x, y) < limit ? cut : left) = true;
    if (!cut || !left) return {};
    return alpha;
}

glm::vec3 readMeans(const ImageFile& file) {
    const OpenImage image(file);
    const auto texels = image.colours<float>(OIIO::TypeDesc::FLOAT);
    double sums[3] = {};
    for (size_t i = 0; i < texels.size(); ++i) sums[i % 3] += texels[i];
    const double count = (double) (texels.size() / 3);
    return {(float) (sums[0] / count), (float) (sums[1] / count), (float) (sums[2] / count)};
}

} // namespace dirt
