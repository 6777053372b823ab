#include "core/io/exr_parts.h"

#include "core/io/image_encoder.h"

#include <algorithm>
#include <bit>
#include <utility>

#include <OpenImageIO/deepdata.h>

namespace dirt {

namespace {

OIIO::TypeDesc typeOf(const ExrChannel& channel) {
    return channel.type == ExrChannel::Type::uint32 ? OIIO::TypeDesc::UINT : OIIO::TypeDesc::FLOAT;
}

template <typename Part>
OIIO::ImageSpec specOf(const Part& part, const ImageMetadata& metadata) {
    std::vector<std::string> names;
    for (const ExrChannel& channel : part.channels) names.push_back(channel.name);
    OIIO::ImageSpec spec =
        imageSpec(part.width, part.height, std::move(names), OIIO::TypeDesc::FLOAT);
    for (const ExrChannel& channel : part.channels) spec.channelformats.push_back(typeOf(channel));
    describeImage(spec, metadata);
    spec.attribute("compression", "zips");
    if (!part.name.empty()) spec.attribute("oiio:subimagename", part.name);
    return spec;
}

OIIO::DeepData deepDataOf(const DeepExrPart& part, const OIIO::ImageSpec& spec) {
    OIIO::DeepData data(spec);
    for (size_t pixel = 0; pixel < part.counts.size(); ++pixel)
        data.set_samples((int64_t) pixel, (int) part.counts[pixel]);
    const uint32_t* value = part.values.data();
    for (size_t pixel = 0; pixel < part.counts.size(); ++pixel)
        for (uint32_t sample = 0; sample < part.counts[pixel]; ++sample)
            for (int c = 0; c < (int) part.channels.size(); ++c, ++value) {
                if (part.channels[c].type == ExrChannel::Type::uint32)
                    data.set_deep_value((int64_t) pixel, c, (int) sample, *value);
                else
                    data.set_deep_value((int64_t) pixel, c, (int) sample,
                                        std::bit_cast<float>(*value));
            }
    return data;
}

bool writePixels(OIIO::ImageOutput& output, const ExrPart& part, const OIIO::ImageSpec&) {
    return output.write_image(OIIO::TypeDesc::UNKNOWN, part.values.data());
}

bool writePixels(OIIO::ImageOutput& output, const DeepExrPart& part, const OIIO::ImageSpec& spec) {
    return output.write_deep_image(deepDataOf(part, spec));
}

template <typename Part>
void writeParts(const std::string& path, std::span<const Part> parts,
                const ImageMetadata& metadata) {
    std::vector<OIIO::ImageSpec> specs;
    int width = 0, height = 0;
    for (const Part& part : parts) {
        specs.push_back(specOf(part, metadata));
        specs.back().deep = std::is_same_v<Part, DeepExrPart>;
        width = std::max(width, part.width);
        height = std::max(height, part.height);
    }
    // The parts of a file share their display window.
    for (OIIO::ImageSpec& spec : specs) {
        spec.full_width = width;
        spec.full_height = height;
    }
    writeEncodedParts(path, [&](OIIO::ImageOutput& output, const std::string& name) {
        if (!output.open(name, (int) specs.size(), specs.data())) return false;
        for (size_t i = 0; i < parts.size(); ++i) {
            if (i > 0 && !output.open(name, specs[i], OIIO::ImageOutput::AppendSubimage))
                return false;
            if (!writePixels(output, parts[i], specs[i])) return false;
        }
        return output.close();
    });
}

} // namespace

void writeExr(const std::string& path, std::span<const ExrPart> parts,
              const ImageMetadata& metadata) {
    writeParts(path, parts, metadata);
}

void writeExr(const std::string& path, std::span<const DeepExrPart> parts,
              const ImageMetadata& metadata) {
    writeParts(path, parts, metadata);
}

} // namespace dirt
