#include "core/io/image_encoder.h"

#include "core/base/error.h"
#include "core/io/memory_file.h"
#include "core/io/output_file.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <OpenImageIO/filesystem.h>

namespace dirt {

namespace {

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
    throw InputError(path + ": cannot write: " + reason.substr(0, reason.find('\n')));
}

std::unique_ptr<OIIO::ImageOutput> create(const std::string& path, const char* format) {
    auto output = OIIO::ImageOutput::create(format);
    if (!output) fail(path, OIIO::geterror());
    return output;
}

} // namespace

OIIO::ImageSpec imageSpec(int width, int height, std::vector<std::string> channels,
                          OIIO::TypeDesc format) {
    OIIO::ImageSpec spec(format);
    spec.width = spec.full_width = width;
    spec.height = spec.full_height = height;
    spec.nchannels = (int) channels.size();
    spec.channelnames = std::move(channels);
    return spec;
}

void describeImage(OIIO::ImageSpec& spec, const ImageMetadata& metadata) {
    for (const auto& [name, value] : metadata) spec.attribute(name, value);
    // Or else the time of writing and the library's version would get into the file.
    spec.attribute("DateTime", "2016:06:20 00:00:00");
    spec.attribute("Software", "dirt");
}

void writeEncoded(const std::string& path, const char* format,
                  const std::function<bool(OIIO::ImageOutput&, const std::string&)>& encode) {
    OIIO::Filesystem::IOVecOutput memory;
    const auto output = create(path, format);
    if (!output->set_ioproxy(&memory)) fail(path, "OpenImageIO cannot encode into memory");
    // Each call may report success and leave an error behind all the same.
    if (!encode(*output, path) || output->has_error()) fail(path, output->geterror());
    writeFile(path, std::as_bytes(std::span(memory.buffer())));
}

void writeEncodedParts(const std::string& path,
                       const std::function<bool(OIIO::ImageOutput&, const std::string&)>& encode) {
    const MemoryFile memory;
    const auto output = create(path, "openexr");
    const bool done = encode(*output, memory.name()) && !output->has_error();
    if (memory.cutShort()) fail(path, std::strerror(EFBIG));
    if (!done) fail(path, output->geterror());
    writeFile(path, memory.contents());
}

} // namespace dirt
