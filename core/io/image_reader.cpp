#include "core/io/image_reader.h"

#include "core/io/exr_header.h"
#include "core/io/image_codec.h"
#include "core/io/image_encoder.h"
#include "core/io/load_report.h"
#include "core/io/png_decoder.h"

#include <utility>
#include <vector>

#include <OpenImageIO/filesystem.h>

namespace dirt {

namespace {

/// Texels of the largest image that is read, and a quarter of its samples.
constexpr int64_t kMaxTexels = int64_t(1) << 28;

/// What a file may claim whatever its length: a header is longer than a few texels.
constexpr uint64_t kFreeSamples = 1 << 16;

/// Without this, colours come back multiplied by alpha.
const OIIO::ImageSpec kConfig = [] {
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    return config;
}();

} // namespace

/// What reads one kind of file.
class ImageReader::Source {
public:
    virtual ~Source() = default;
    /// False: error says why.
    virtual bool read(int first, int end, OIIO::TypeDesc type, void* texels) = 0;

    OIIO::ImageSpec spec;
    std::string error;
};

/// By libpng itself, whose errors OpenImageIO lets through to standard error.
class ImageReader::PngSource : public Source {
public:
    explicit PngSource(const std::string& bytes) : decoder_(bytes) {
        const PngHeader& header = decoder_.header();
        std::vector<std::string> names = {"R", "G", "B", "A"};
        names.resize((size_t) header.channels);
        if (header.channels == 1) names = {"Y"};
        spec = imageSpec(header.width, header.height, std::move(names),
                         header.bits == 8 ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::UINT16);
        if (header.channels % 2 == 0) spec.alpha_channel = header.channels - 1;
        for (const auto& [key, text] : decoder_.texts()) spec.attribute(key, text);
    }

    bool read(int first, int end, OIIO::TypeDesc type, void* texels) override {
        if (decoded_.empty()) decoded_ = decoder_.decode();
        const OIIO::stride_t sample = (OIIO::stride_t) spec.format.size();
        const OIIO::stride_t texel = sample * spec.nchannels;
        return OIIO::convert_image(end - first, spec.width, spec.height, 1,
                                   decoded_.data() + first * sample, spec.format, texel,
                                   texel * spec.width, OIIO::AutoStride, texels, type,
                                   OIIO::AutoStride, OIIO::AutoStride, OIIO::AutoStride);
    }

private:
    PngDecoder decoder_;
    std::vector<uint8_t> decoded_;
};

class ImageReader::OtherSource : public Source {
public:
    /// \p bytes have to outlive this. Where it does not open, error is not empty.
    OtherSource(const char* format, const std::string& bytes, const std::string& name)
        : memory_(const_cast<char*>(bytes.data()), bytes.size()),
          input_(OIIO::ImageInput::create(format)) {
        if (!input_)
            error = std::string("this OpenImageIO cannot read ") + format;
        else if (!input_->set_ioproxy(&memory_) || !input_->open(name, spec, kConfig))
            error = input_->geterror() + " "; // which may be empty
    }

    bool read(int first, int end, OIIO::TypeDesc type, void* texels) override {
        if (input_->read_image(0, 0, first, end, type, texels)) return true;
        error = input_->geterror();
        return false;
    }

private:
    OIIO::Filesystem::IOMemReader memory_;
    std::unique_ptr<OIIO::ImageInput> input_;
};

ImageReader::ImageReader(std::shared_ptr<const std::string> bytes, std::filesystem::path name)
    : name_(std::move(name)), bytes_(std::move(bytes)) {
    const ImageCodec* codec = codecOf(*bytes_);
    if (!codec)
        failAt(name_, 0, std::string("is none of the images that are read: ") + kCodecNames);
    if (std::string_view(codec->name) == "png") {
        try {
            source_ = std::make_unique<PngSource>(*bytes_);
        } catch (const PngError& error) {
            failAt(name_, 0, "damaged image: " + printable(error.what()));
        }
    } else {
        if (std::string_view(codec->name) == "openexr")
            if (const auto fault = exrHeaderFault(*bytes_))
                failAt(name_, 0, "damaged image: " + *fault);
        source_ = std::make_unique<OtherSource>(codec->name, *bytes_, name_.string());
        if (!source_->error.empty())
            failAt(name_, 0, "no readable image: " + printable(source_->error));
    }
    checkHeader(codec->samplesPerByte);
}

ImageReader::~ImageReader() = default;

const OIIO::ImageSpec& ImageReader::spec() const {
    return source_->spec;
}

void ImageReader::checkHeader(uint64_t samplesPerByte) const {
    const OIIO::ImageSpec& spec = source_->spec;
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || spec.depth > 1 || spec.deep)
        failAt(name_, 0, "not a flat image");
    const int64_t texels = (int64_t) spec.width * spec.height;
    const std::string size = "an image of " + std::to_string(spec.width) + "x" +
                             std::to_string(spec.height) +
                             (texels > kMaxTexels ? "" : " with as many channels");
    if (texels > kMaxTexels || texels * spec.nchannels > 4 * kMaxTexels)
        failAt(name_, 0, size + " is too large");
    if ((uint64_t) texels * (uint64_t) spec.nchannels >
        kFreeSamples + samplesPerByte * bytes_->size())
        failAt(name_, 0,
               "damaged image: " + std::to_string(bytes_->size()) + " bytes cannot hold the " +
                   std::to_string(spec.width) + "x" + std::to_string(spec.height) +
                   " texels of its header");
}

void ImageReader::read(int first, int end, OIIO::TypeDesc type, void* texels) {
    try {
        if (!source_->read(first, end, type, texels))
            failAt(name_, 0, "damaged image: " + printable(source_->error));
    } catch (const PngError& error) {
        failAt(name_, 0, "damaged image: " + printable(error.what()));
    }
}

} // namespace dirt
