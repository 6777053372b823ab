#include "tests/support/write_image.h"

#include <stdexcept>

#include <OpenImageIO/imageio.h>

namespace dirt::test {

namespace {

OIIO::TypeDesc typeOf(TexelType type) {
    switch (type) {
    case TexelType::uint8:
        return OIIO::TypeDesc::UINT8;
    case TexelType::uint16:
        return OIIO::TypeDesc::UINT16;
    case TexelType::half:
        return OIIO::TypeDesc::HALF;
    case TexelType::float32:
        return OIIO::TypeDesc::FLOAT;
    }
    return {};
}

std::string write(const std::filesystem::path& file, OIIO::ImageSpec spec, OIIO::TypeDesc given,
                  const void* texels) {
    spec.attribute("oiio:UnassociatedAlpha", 1);
    if (spec.nchannels % 2 == 0) spec.alpha_channel = spec.nchannels - 1;
    const auto output = OIIO::ImageOutput::create(file.string());
    if (!output || !output->open(file.string(), spec) || !output->write_image(given, texels) ||
        !output->close())
        throw std::runtime_error(file.string() + ": " +
                                 (output ? output->geterror() : OIIO::geterror()));
    return file.string();
}

} // namespace

std::string writeImage(const std::filesystem::path& file, int width, int height, int channels,
                       TexelType type, const std::vector<float>& values) {
    return write(file, {width, height, channels, typeOf(type)}, OIIO::TypeDesc::FLOAT,
                 values.data());
}

std::string writeImage(const std::filesystem::path& file, int width, int height, int channels,
                       const std::vector<uint8_t>& texels) {
    return write(file, {width, height, channels, OIIO::TypeDesc::UINT8}, OIIO::TypeDesc::UINT8,
                 texels.data());
}

} // namespace dirt::test
