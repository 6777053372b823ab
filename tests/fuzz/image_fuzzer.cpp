// Images as `dirt compare` reads them, with what their attributes say.

#include "core/io/image.h"
#include "tests/fuzz/fuzzer.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    return dirt::fuzz::readBytes(data, size, [](const std::filesystem::path& file) {
        const dirt::Image image = dirt::readImage(file);
        if (image.pixels.size() != (size_t) image.width * (size_t) image.height) std::abort();
        dirt::readMetadata(file);
    });
}
