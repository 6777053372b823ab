// The MTL reader.

#include "core/io/mtl.h"
#include "tests/fuzz/fuzzer.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    return dirt::fuzz::readBytes(data, size, [](const std::filesystem::path& file) {
        dirt::LoadReport report;
        for (const dirt::MtlMaterial& material : dirt::readMtl(file, report))
            for (int i = 0; i < 3; ++i) // written so that NaN fails
                if (!(material.material.diffuse[i] >= 0.0f &&
                      material.material.emission[i] >= 0.0f))
                    std::abort();
    });
}
