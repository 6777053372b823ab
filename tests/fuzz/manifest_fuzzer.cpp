// Manifests of dumps: whatever is taken for one names such files alone as a dump writes.

#include "core/dump/manifest.h"
#include "core/io/text_file.h"
#include "tests/fuzz/fuzzer.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace {

/// Known buffers, a number where there are several, and nothing that leads out of the folder.
bool isOfDump(const std::string& name) {
    if (name == dirt::kIdsAsText) return true;
    const size_t end = name.find('.');
    const auto& buffers = dirt::dumpBuffers();
    if (std::find(buffers.begin(), buffers.end(), name.substr(0, end)) == buffers.end())
        return false;
    std::string rest = name.substr(end);
    if (!rest.ends_with(".exr")) return false;
    rest.resize(rest.size() - 4);
    return rest.empty() || rest.find_first_not_of("0123456789", 1) == std::string::npos;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    return dirt::fuzz::readBytes(data, size, [](const std::filesystem::path& file) {
        dirt::MemoryClaim memory(dirt::MemoryBudget(64'000'000));
        if (!dirt::isDumpManifest(file, memory)) return;
        const auto manifest = nlohmann::json::parse(dirt::readOwnBytes(file));
        for (const auto& dumped : manifest.at("files"))
            if (!isOfDump(dumped.at("file").get<std::string>())) std::abort();
    });
}
