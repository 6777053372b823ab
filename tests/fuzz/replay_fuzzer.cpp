// Dumps of other engines: a folder of text files in one input, each after a line "=== NAME".

#include "core/base/executor.h"
#include "core/replay/replay.h"
#include "tests/fuzz/fuzzer.h"

#include <array>
#include <fstream>
#include <string_view>

namespace {

constexpr std::string_view kFile = "=== ";
/// A dump has no others; what an input names besides is left out.
constexpr std::array<std::string_view, 7> kNames = {
    "manifest.json", "triangles.csv", "depth.csv",       "ids.csv",
    "rays.1.csv",    "hits.1.csv",    "shadowrays.1.csv"};

/// A folder in memory, of this process.
const std::filesystem::path& folder() {
    static const std::filesystem::path path = [] {
        std::string name = "/dev/shm/dirt-replay-fuzzer-XXXXXX";
        if (!mkdtemp(name.data())) std::abort();
        return name;
    }();
    return path;
}

void unpack(std::string_view text) {
    for (const std::string_view name : kNames) std::filesystem::remove(folder() / name);
    while (text.starts_with(kFile)) {
        text.remove_prefix(kFile.size());
        const size_t line = std::min(text.find('\n'), text.size());
        const std::string_view name = text.substr(0, line);
        text.remove_prefix(std::min(line + 1, text.size()));
        const size_t end = std::min(text.find("\n=== "), text.size());
        const std::string_view content = text.substr(0, std::min(end + 1, text.size()));
        for (const std::string_view known : kNames)
            if (name == known) std::ofstream(folder() / known, std::ios::binary) << content;
        text.remove_prefix(content.size());
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    unpack({reinterpret_cast<const char*>(data), size});
    try {
        const dirt::ReplayInput input = dirt::readReplay(folder());
        dirt::SerialExecutor executor;
        const auto passes = dirt::judgeDump(input, executor);
        if (dirt::verdictText(passes).empty()) std::abort();
    } catch (const dirt::InputError& error) {
        const std::string line = error.what();
        if (line.rfind(folder().string() + "/", 0) != 0 ||
            line.find_first_of("\r\n") != std::string::npos) {
            std::fprintf(stderr, "not one line that names the file: %s\n", line.c_str());
            std::abort();
        }
    }
    return 0;
}
