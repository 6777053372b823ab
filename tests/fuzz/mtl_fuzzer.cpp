// The MTL reader, and what materials mean in both conventions.

#include "core/io/mtl.h"
#include "core/io/mtl_material.h"
#include "tests/fuzz/fuzzer.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    return dirt::fuzz::readBytes(data, size, [](const std::filesystem::path& file) {
        dirt::LoadReport report;
        for (const dirt::MtlMaterial& source : dirt::readMtl(file).materials)
            for (const auto convention :
                 {dirt::MaterialConvention::demo, dirt::MaterialConvention::wavefront}) {
                const dirt::Material material = dirt::materialOf(source, convention);
                dirt::reportIgnored(source, convention, report);
                const auto isPart = [](float value) { return value >= 0.0f && value <= 1.0f; };
                bool sound = isPart(material.reflectance) && isPart(material.metallic) &&
                             isPart(material.roughness) && isPart(material.opacity);
                for (int i = 0; i < 3; ++i) // written so that NaN fails
                    sound = sound && material.diffuse[i] >= 0.0f && material.emission[i] >= 0.0f;
                if (!sound) std::abort();
            }
    });
}
