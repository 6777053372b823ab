#pragma once

#include "core/io/json_value.h"
#include "core/io/memory_budget.h"

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dirt {

/// The container of a glTF 2.0 file, .gltf or .glb: its JSON, and the bytes that accessors and
/// images lie in. Every range is checked against what holds it.
class GltfData {
public:
    /// Reads the file and the external buffers that it names, and unpacks views that are
    /// compressed. Throws InputError where it is not well-formed, not of version 2, or requires an
    /// extension that is not known here. A buffer may be missing or too short as long as nothing
    /// refers to it.
    /// \p budget: for what is needed as long as this lives, and for elements while they are made.
    explicit GltfData(const std::filesystem::path& file, const MemoryBudget& budget = {});
    ~GltfData();
    GltfData(const GltfData&) = delete; // values refer to the document
    GltfData& operator=(const GltfData&) = delete;

    const std::filesystem::path& file() const { return file_; }
    /// Takes what is needed as long as this lives.
    MemoryClaim& memory() const { return memory_; }
    const JsonValue& root() const { return *root_; }
    const nlohmann::json& document() const { return *document_; }

    /// The bytes of a buffer view, unpacked. \p from says what refers to it.
    std::span<const std::byte> view(uint64_t index, const JsonValue& from) const;

    /// The elements of an accessor of vectors with so many components, one after the other: floats,
    /// normalized integers of 8 or 16 bits, or, where \p orIntegers, such integers as they are
    /// (KHR_mesh_quantization). May hold NaN and infinity.
    std::vector<float> floats(uint64_t index, const JsonValue& from, size_t components,
                              bool orIntegers = false) const;
    /// The elements of an accessor of scalar unsigned integers.
    std::vector<uint32_t> indices(uint64_t index, const JsonValue& from) const;
    /// How many components the vectors of an accessor have: 2 to 4; else 1.
    size_t components(uint64_t index, const JsonValue& from) const;
    bool isNormalized(uint64_t index, const JsonValue& from) const;
    /// Whether an accessor has any data, or is all zeros.
    bool hasData(uint64_t index, const JsonValue& from) const;

private:
    struct Elements {
        uint64_t componentType;
        bool normalized;
        std::vector<std::byte> bytes; ///< one after the other, without gaps
        MemoryClaim memory;           ///< for these, and for the values that become of them
    };

    /// A buffer, or why there is none, which matters where something refers to it.
    struct Buffer {
        JsonValue source;
        std::span<const std::byte> bytes = {};
        std::string problem = {};
    };

    void readBinary(std::span<const std::byte> bytes);
    void checkExtensions() const;
    void readBuffers();
    void unpackViews();
    std::span<const std::byte> range(const JsonValue& view) const;
    void overwriteSparse(const JsonValue& accessor, uint64_t count, size_t elementBytes,
                         std::vector<std::byte>& bytes) const;
    Elements elements(const JsonValue& accessor, size_t components) const;

    void claimZeros(const JsonValue& accessor, uint64_t count) const;

    std::filesystem::path file_;
    mutable MemoryClaim memory_;
    mutable uint64_t zeros_ = 0; ///< elements without data so far
    std::string bytes_;          ///< of the file
    std::string_view json_;
    std::span<const std::byte> binary_; ///< the chunk of a .glb
    JsonDocument document_;
    std::unique_ptr<JsonValue> root_;
    std::vector<JsonValue> accessors_, views_;
    std::vector<std::string> loaded_; ///< buffers that are not the chunk
    std::vector<Buffer> buffers_;
    std::map<uint64_t, std::string> unpacked_; ///< views that were compressed
};

/// The bytes of a data: URI; nothing where \p uri is none. Throws InputError at \p from where it is
/// malformed.
std::optional<std::string> decodeDataUri(std::string_view uri, const JsonValue& from);

/// \p uri with %20 and the like decoded.
std::string decodeUri(std::string_view uri);

} // namespace dirt
