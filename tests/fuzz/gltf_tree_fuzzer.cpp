// The glTF reader on files that are sound JSON: trees that are edited as trees, so that it is the
// reader's own checks that are met, not the parser's.

#include "tests/fuzz/gltf_read.h"

#include <algorithm>
#include <cstring>
#include <random>
#include <vector>

#include <nlohmann/json.hpp>

namespace {

using Json = nlohmann::ordered_json;

/// All values of a tree, parents before their children.
void gather(Json& json, std::vector<Json*>& values) {
    values.push_back(&json);
    if (json.is_structured())
        for (Json& child : json) gather(child, values);
}

/// A value that readers stumble over.
Json awkward(std::mt19937& random) {
    switch (random() % 14) {
    case 0:
        return nullptr;
    case 1:
        return -1;
    case 2:
        return 0;
    case 3:
        return 4294967295u;
    case 4:
        return 18446744073709551615u;
    case 5:
        return 1e308;
    case 6:
        return 0.5;
    case 7:
        return true;
    case 8:
        return "";
    case 9:
        return Json::array();
    case 10:
        return Json::object();
    case 11:
        return "data:application/octet-stream;base64,AAAA";
    case 12:
        return (unsigned) (5120 + random() % 7); // a component type
    default:
        return (unsigned) (random() % 40);
    }
}

void edit(Json& root, std::mt19937& random) {
    std::vector<Json*> values;
    gather(root, values);
    Json& target = *values[random() % values.size()];
    const Json other = *values[random() % values.size()];
    switch (random() % 6) {
    case 0:
        target = awkward(random);
        return;
    case 1: // one tree in another's place
        target = other;
        return;
    case 2:
        if (target.is_array())
            target.push_back(target.empty() ? other : target[random() % target.size()]);
        return;
    case 3:
        if (target.is_structured() && !target.empty()) {
            auto child = target.begin();
            std::advance(child, random() % target.size());
            target.erase(child);
        }
        return;
    case 4: { // a member of another object
        if (!target.is_object() || !other.is_object() || other.empty()) return;
        auto member = other.begin();
        std::advance(member, random() % other.size());
        target[member.key()] = member.value();
        return;
    }
    default:
        if (target.is_number_integer()) target = target.get<int64_t>() + (int) (random() % 5) - 2;
        if (target.is_number_float()) target = -target.get<double>();
    }
}

} // namespace

extern "C" size_t LLVMFuzzerMutate(uint8_t* data, size_t size, size_t most);

extern "C" size_t LLVMFuzzerCustomMutator(uint8_t* data, size_t size, size_t most, unsigned seed) {
    std::mt19937 random(seed);
    Json root = Json::parse(data, data + size, nullptr, false);
    if (root.is_discarded()) root = {{"asset", {{"version", "2.0"}}}};
    for (unsigned edits = 1 + random() % 3; edits > 0; --edits) edit(root, random);
    const std::string text = root.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (text.size() > most) return size;
    std::memcpy(data, text.data(), text.size());
    return text.size();
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    return dirt::fuzz::readBytes(data, size, dirt::fuzz::readGltfWhole);
}
