#include "core/io/read_exr_parts.h"

#include "core/io/exr_header.h"
#include "core/io/image_codec.h"
#include "core/io/load_report.h"
#include "core/io/text_file.h"

#include <memory>
#include <string_view>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

namespace dirt {

namespace {

/// More a dump has not: six views of fourteen levels.
constexpr int kMaxParts = 1024;

/// Deflate, which dumps use, makes at most 258 bytes of two bits. Other methods make more of blocks
/// that are all alike: so much, 16 MB, a file may claim whatever its length.
constexpr uint64_t kValuesPerByte = 258, kFreeValues = 1 << 22;

/// Name, size and channels. \p budget: values that the file's bytes may still stand for.
ExrPart describe(const std::filesystem::path& file, const OIIO::ImageSpec& spec, uint64_t& budget) {
    const std::string name = spec.get_string_attribute("oiio:subimagename");
    const std::string part = name.empty() ? "" : "part " + printable(name) + ": ";
    if (spec.deep)
        failAt(file, 0, part + "is deep: samples without a bound to their number are not read");
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1)
        failAt(file, 0, part + "is no flat image");
    const uint64_t pixels = (uint64_t) spec.width * (uint64_t) spec.height;
    if (pixels > budget / (uint64_t) spec.nchannels)
        failAt(file, 0,
               part + "claims " + std::to_string(spec.width) + "x" + std::to_string(spec.height) +
                   " pixels, which the file cannot hold");
    budget -= pixels * (uint64_t) spec.nchannels;
    ExrPart described{name, spec.width, spec.height, {}, {}};
    for (int c = 0; c < spec.nchannels; ++c) {
        const OIIO::TypeDesc type = spec.channelformat(c);
        if (type != OIIO::TypeDesc::UINT && type != OIIO::TypeDesc::FLOAT)
            failAt(file, 0,
                   part + "channel " + printable(spec.channel_name(c)) +
                       " has neither 32-bit floats nor 32-bit integers");
        described.channels.push_back({spec.channel_name(c), type == OIIO::TypeDesc::UINT
                                                                ? ExrChannel::Type::uint32
                                                                : ExrChannel::Type::float32});
    }
    return described;
}

} // namespace

std::vector<ExrPart> readExrParts(const std::filesystem::path& file) {
    std::string bytes = readBytes(file);
    const ImageCodec* codec = codecOf(bytes);
    if (!codec || std::string_view(codec->name) != "openexr") failAt(file, 0, "is no EXR file");
    if (const auto fault = exrHeaderFault(bytes)) failAt(file, 0, "damaged image: " + *fault);
    uint64_t budget = kFreeValues + kValuesPerByte * bytes.size();
    OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
    const auto input = OIIO::ImageInput::create("openexr");
    OIIO::ImageSpec spec;
    const auto damaged = [&] {
        failAt(file, 0, "damaged image: " + printable(input ? input->geterror() : ""));
    };
    if (!input || !input->set_ioproxy(&memory) || !input->open(file.string(), spec)) damaged();
    std::vector<ExrPart> parts;
    for (int part = 0; input->seek_subimage(part, 0); ++part) {
        if (part == kMaxParts) failAt(file, 0, "has too many parts");
        spec = input->spec(part, 0);
        ExrPart& read = parts.emplace_back(describe(file, spec, budget));
        read.values.resize((size_t) spec.width * (size_t) spec.height * (size_t) spec.nchannels);
        // Channels of 32 bits each: as they are.
        if (!input->read_image(part, 0, 0, spec.nchannels, OIIO::TypeDesc::UNKNOWN,
                               read.values.data()))
            damaged();
    }
    (void) input->geterror(); // of the part after the last
    return parts;
}

} // namespace dirt
