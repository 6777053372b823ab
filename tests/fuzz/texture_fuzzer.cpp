// The readers of textures. What the image libraries do inside is seen only where it touches memory
// through functions that the sanitizer replaces: they are not instrumented.

#include "core/io/texture_file.h"
#include "tests/fuzz/fuzzer.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    return dirt::fuzz::readBytes(data, size, [](const std::filesystem::path& file) {
        const dirt::DecodedImage image(file);
        const dirt::ScalarTexture scalars = dirt::readScalarTexture(image);
        const dirt::Texture colours = dirt::readTexture(image);
        if (colours.width() != scalars.width() || colours.height() != scalars.height())
            std::abort();
        dirt::readAlpha(image);
    });
}
