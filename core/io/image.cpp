#include "core/io/image.h"

#include "core/base/error.h"
#include "core/io/image_encoder.h"
#include "core/io/image_reader.h"
#include "core/io/text_file.h"

#include <filesystem>

#include <OpenImageIO/imageio.h>

namespace dirt {

namespace {

void encode(const std::string& path, const char* format, OIIO::ImageSpec spec,
            const ImageMetadata& metadata, const void* pixels) {
    describeImage(spec, metadata);
    writeEncoded(path, format, [&](OIIO::ImageOutput& output, const std::string& name) {
        return output.open(name, spec) && output.write_image(spec.format, pixels) && output.close();
    });
}

} // namespace

ImageFormat imageFormat(const std::string& path) {
    const std::string extension = lowerCase(std::filesystem::path(path).extension().string());
    if (extension == ".png") return ImageFormat::png;
    if (extension == ".exr") return ImageFormat::exr;
    throw InputError(path + ": an image's name has to end in .png or .exr");
}

void writePng(const std::string& path, int width, int height, std::span<const uint8_t> rgb,
              const ImageMetadata& metadata) {
    encode(path, "png", imageSpec(width, height, {"R", "G", "B"}, OIIO::TypeDesc::UINT8), metadata,
           rgb.data());
}

void writeExr(const std::string& path, const Image& image, const ImageMetadata& metadata) {
    static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
    OIIO::ImageSpec spec =
        imageSpec(image.width, image.height, {"R", "G", "B"}, OIIO::TypeDesc::FLOAT);
    spec.attribute("compression", "zip");
    spec.attribute("oiio:ColorSpace", "linear");
    encode(path, "openexr", std::move(spec), metadata, image.pixels.data());
}

Image readImage(const std::string& path) {
    ImageReader reader(readBytes(path), path);
    const OIIO::ImageSpec& spec = reader.spec();
    int first = spec.channelindex("R");
    const bool colored =
        first >= 0 && spec.channelindex("G") == first + 1 && spec.channelindex("B") == first + 2;
    if (!colored) first = spec.channelindex("Y");
    if (first < 0 || spec.channelformat(first).basetype == OIIO::TypeDesc::UINT)
        throw InputError(path + ": not an image: it has no channels R, G, B or Y");
    const int channels = colored ? 3 : 1;
    std::vector<float> values((size_t) spec.width * (size_t) spec.height * (size_t) channels);
    reader.read(first, first + channels, OIIO::TypeDesc::FLOAT, values.data());

    Image image{spec.width, spec.height, std::vector<glm::vec3>((size_t) spec.width * spec.height)};
    for (size_t i = 0; i < image.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) image.pixels[i][c] = values[i * channels + (colored ? c : 0)];
    return image;
}

ImageMetadata readMetadata(const std::string& path) {
    const ImageReader reader(readBytes(path), path);
    ImageMetadata metadata;
    for (const OIIO::ParamValue& value : reader.spec().extra_attribs)
        if (value.name().string().rfind("dirt:", 0) == 0)
            metadata.emplace_back(value.name().string(), value.get_string());
    return metadata;
}

} // namespace dirt
