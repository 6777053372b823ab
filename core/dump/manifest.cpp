#include "core/dump/manifest.h"

#include "core/io/json_value.h"
#include "core/io/text_file.h"

#include <algorithm>
#include <limits>

#include <nlohmann/json.hpp>

namespace dirt {

namespace {

using Json = nlohmann::json;

/// A member that is a text; empty where there is none.
std::string textAt(const Json& json, const char* key) {
    if (!json.is_object() || !json.contains(key) || !json[key].is_string()) return {};
    return json[key].get<std::string>();
}

bool isDumpedFile(const Json& json) {
    const std::string buffer = textAt(json, "buffer");
    const std::vector<std::string>& known = dumpBuffers();
    if (std::find(known.begin(), known.end(), buffer) == known.end()) return false;
    std::optional<int> event;
    if (json.contains("event") && !json["event"].is_null()) {
        if (!json["event"].is_number_unsigned()) return false;
        const auto number = json["event"].get<uint64_t>();
        if (number > (uint64_t) std::numeric_limits<int>::max()) return false;
        event = (int) number;
    }
    const std::string file = textAt(json, "file");
    return file == dumpFileName(buffer, event) || (buffer == "ids" && file == kIdsAsText);
}

} // namespace

const std::vector<std::string>& dumpBuffers() {
    static const std::vector<std::string> buffers{
        "triangles", "depth", "ids",        "shadowmap",  "direct",  "rays",
        "hits",      "mask",  "shadowrays", "visibility", "shading", "image"};
    return buffers;
}

std::string dumpFileName(const std::string& buffer, std::optional<int> event) {
    return buffer + (event ? "." + std::to_string(*event) : "") + ".exr";
}

bool isDumpManifest(const std::filesystem::path& file, MemoryClaim& memory) {
    const std::string text = readOwnBytes(file, memory);
    memory.take(jsonBytes(text), file, "its JSON");
    const Json manifest = Json::parse(text, nullptr, false);
    if (textAt(manifest, "backend").empty() || !manifest.contains("files")) return false;
    const Json& files = manifest["files"];
    return files.is_array() && std::all_of(files.begin(), files.end(), isDumpedFile);
}

} // namespace dirt
