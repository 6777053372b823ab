#pragma once

#include "tests/support/temporary_folder.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace dirt::test {

using Json = nlohmann::ordered_json;

/// Writes small glTF files: whatever \p json says, and one buffer that grows with each accessor.
class GltfWriter {
public:
    Json json = {{"asset", {{"version", "2.0"}}},
                 {"buffers", Json::array()},
                 {"bufferViews", Json::array()},
                 {"accessors", Json::array()},
                 {"meshes", Json::array()},
                 {"nodes", Json::array()},
                 {"scenes", Json::array({{{"nodes", Json::array()}}})}};
    std::string bytes; ///< of the buffer

    /// Appends a buffer view; returns its index.
    size_t view(const std::string& data) {
        bytes.resize((bytes.size() + 3) / 4 * 4);
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", data.size()}});
        bytes += data;
        return json["bufferViews"].size() - 1;
    }
    /// Appends an accessor with a view of its own; returns its index.
    template <typename Value>
    size_t accessor(const char* type, int componentType, size_t components,
                    const std::vector<Value>& values) {
        const std::string data((const char*) values.data(), values.size() * sizeof(Value));
        json["accessors"].push_back({{"bufferView", view(data)},
                                     {"componentType", componentType},
                                     {"count", values.size() / components},
                                     {"type", type}});
        return json["accessors"].size() - 1;
    }
    size_t vec3(const std::vector<float>& values) { return accessor("VEC3", 5126, 3, values); }
    size_t vec2(const std::vector<float>& values) { return accessor("VEC2", 5126, 2, values); }
    template <typename Index>
    size_t indices(const std::vector<Index>& values) {
        const int type = sizeof(Index) == 1 ? 5121 : sizeof(Index) == 2 ? 5123 : 5125;
        return accessor("SCALAR", type, 1, values);
    }
    /// Appends a mesh of one primitive; returns its index.
    size_t mesh(const Json& primitive) {
        json["meshes"].push_back({{"primitives", Json::array({primitive})}});
        return json["meshes"].size() - 1;
    }
    /// Appends a node, at the root of the scene; returns its index.
    size_t node(const Json& value) {
        json["nodes"].push_back(value);
        json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
        return json["nodes"].size() - 1;
    }
    /// A triangle in the plane z = 0, at a node; returns its mesh.
    size_t triangle() {
        const size_t index =
            mesh({{"attributes", {{"POSITION", vec3({0, 0, 0, 1, 0, 0, 0, 1, 0})}}}});
        node({{"mesh", index}});
        return index;
    }

    /// The file's text, with the buffer inside; then what `json` has under "more buffers".
    std::string embedded() const {
        Json copy = json;
        copy["buffers"] =
            Json::array({{{"byteLength", bytes.size()},
                          {"uri", "data:application/octet-stream;base64," + base64(bytes)}}});
        if (copy.contains("more buffers"))
            for (const Json& buffer : copy["more buffers"]) copy["buffers"].push_back(buffer);
        copy.erase("more buffers");
        return copy.dump(1);
    }
    /// The file's text, with the buffer in another file.
    std::string external(const std::string& uri) const {
        Json copy = json;
        copy["buffers"] = Json::array({{{"byteLength", bytes.size()}, {"uri", uri}}});
        return copy.dump(1);
    }
    std::string binary() const {
        Json copy = json;
        copy["buffers"] = Json::array({{{"byteLength", bytes.size()}}});
        std::string text = copy.dump(), data = bytes;
        text.resize((text.size() + 3) / 4 * 4, ' ');
        data.resize((data.size() + 3) / 4 * 4);
        return "glTF" + number(2) + number(12 + 8 + text.size() + 8 + data.size()) +
               number(text.size()) + "JSON" + text + number(data.size()) + std::string("BIN\0", 4) +
               data;
    }

    static std::string number(size_t value) {
        const uint32_t word = (uint32_t) value;
        return {(const char*) &word, 4};
    }
    static std::string base64(const std::string& data) {
        const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string text;
        for (size_t i = 0; i < data.size(); i += 3) {
            uint32_t bits = 0;
            const size_t count = std::min<size_t>(3, data.size() - i);
            for (size_t k = 0; k < 3; ++k)
                bits = bits << 8 | (k < count ? (unsigned char) data[i + k] : 0);
            for (size_t k = 0; k < 4; ++k)
                text += k <= count ? digits[bits >> (18 - 6 * k) & 63] : '=';
        }
        return text;
    }
};

} // namespace dirt::test
