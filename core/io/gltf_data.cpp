#include "core/io/gltf_data.h"

#include "core/io/bytes.h"
#include "core/io/find_file.h"
#include "core/io/gltf_members.h"
#include "core/io/gltf_meshopt.h"
#include "core/io/load_report.h"
#include "core/io/text_file.h"

#include <cstring>

#include <nlohmann/json.hpp>

namespace dirt {

GltfData::GltfData(const std::filesystem::path& file, const MemoryBudget& budget)
    : file_(file), memory_(budget), bytes_(readBytes(file, memory_)) {
    const auto bytes = std::as_bytes(std::span(bytes_));
    const bool binary = bytes_.starts_with("glTF");
    if (binary)
        readBinary(bytes);
    else
        json_ = bytes_;
    memory_.take(jsonBytes(json_), file_, "its JSON");
    document_.reset(new nlohmann::json(parseJson(file_, json_, !binary)));
    root_ = std::make_unique<JsonValue>(file_, *document_);
    const std::string version = root_->required("asset").text("version").value_or("");
    if (!version.starts_with("2."))
        failAt(file_, 0, "is of glTF version " + inQuotes(version) + "; 2.0 can be read");
    checkExtensions();
    views_ = root_->objects("bufferViews");
    accessors_ = root_->objects("accessors");
    readBuffers();
    unpackViews();
}

GltfData::~GltfData() = default;

/// A header of 12 bytes, then chunks: length, type, data. The first is JSON, the second, if there
/// is one, the binary buffer.
void GltfData::readBinary(std::span<const std::byte> bytes) {
    constexpr uint32_t kJson = 0x4e4f534a, kBinary = 0x004e4942;
    if (bytes.size() < 12) failAt(file_, 0, "is cut short");
    if (valueAt<uint32_t>(bytes, 1) != 2)
        failAt(file_, 0,
               "is binary glTF of version " + std::to_string(valueAt<uint32_t>(bytes, 1)) +
                   "; 2 can be read");
    const uint32_t length = valueAt<uint32_t>(bytes, 2);
    if (length < 12 || length > bytes.size()) failAt(file_, 0, "is cut short");
    std::span<const std::byte> rest = bytes.subspan(12, length - 12);
    for (int chunk = 0; !rest.empty(); ++chunk) {
        if (rest.size() < 8 || valueAt<uint32_t>(rest, 0) > rest.size() - 8)
            failAt(file_, 0, "has a chunk that is cut short");
        const auto data = rest.subspan(8, valueAt<uint32_t>(rest, 0));
        const uint32_t type = valueAt<uint32_t>(rest, 1);
        if ((chunk == 0) != (type == kJson)) failAt(file_, 0, "does not begin with one JSON chunk");
        if (chunk == 0) json_ = {(const char*) data.data(), data.size()};
        if (chunk == 1 && type == kBinary) binary_ = data;
        rest = rest.subspan(8 + data.size());
    }
    if (json_.data() == nullptr) failAt(file_, 0, "has no JSON chunk");
}

void GltfData::checkExtensions() const {
    if (!root_->has("extensionsRequired")) return;
    for (const auto& value : (*document_)["extensionsRequired"]) {
        const std::string name = value.is_string() ? value.get<std::string>() : "";
        if (!knowsGltfExtension(name))
            failAt(file_, 0, "requires the extension " + inQuotes(name) + ", " + whyUnknown(name));
    }
}

void GltfData::readBuffers() {
    const std::vector<JsonValue> sources = root_->objects("buffers");
    loaded_.resize(sources.size());
    for (size_t i = 0; i < sources.size(); ++i) {
        Buffer& buffer = buffers_.emplace_back(Buffer{sources[i]});
        const uint64_t length =
            buffer.source.requiredInteger("byteLength", JsonValue::kMostInteger);
        std::span<const std::byte> bytes = binary_;
        if (const auto uri = buffer.source.text("uri")) {
            if (uri->starts_with("data:")) memory_.take(uri->size(), file_, buffer.source.place());
            auto data = decodeDataUri(*uri, buffer.source);
            const auto path = data ? std::nullopt : findFile(file_.parent_path(), decodeUri(*uri));
            if (path) data = readBytes(*path, memory_);
            if (!data) buffer.problem = "is in a file that is not there: " + inQuotes(*uri);
            loaded_[i] = std::move(data).value_or("");
            bytes = std::as_bytes(std::span(loaded_[i]));
        } else if (i != 0 || binary_.data() == nullptr) {
            buffer.problem = "has neither a uri nor a binary chunk";
        }
        if (buffer.problem.empty() && length > bytes.size())
            buffer.problem =
                "has " + std::to_string(bytes.size()) + " bytes, not " + std::to_string(length);
        if (buffer.problem.empty()) buffer.bytes = bytes.first(length);
    }
}

void GltfData::unpackViews() {
    if (!knowsGltfExtension("EXT_meshopt_compression")) return; // there may be a plain fallback
    for (size_t i = 0; i < views_.size(); ++i)
        if (const auto extensions = views_[i].object("extensions"))
            if (const auto source = extensions->object("EXT_meshopt_compression"))
                unpacked_[i] = decodeMeshopt(*source, range(*source), memory_);
}

/// What a value with a buffer, an offset and a length refers to.
std::span<const std::byte> GltfData::range(const JsonValue& view) const {
    const uint64_t index = view.requiredInteger("buffer", JsonValue::kMostInteger);
    if (index >= buffers_.size()) view.fail("refers to a buffer that is not there");
    const Buffer& buffer = buffers_[index];
    if (!buffer.problem.empty()) {
        if (const auto extension = unknownExtension(view))
            view.fail("has its data in the extension " + inQuotes(*extension) + ", " +
                      whyUnknown(*extension));
        buffer.source.fail(buffer.problem);
    }
    const uint64_t offset = view.integer("byteOffset", JsonValue::kMostInteger).value_or(0);
    const uint64_t length = view.requiredInteger("byteLength", JsonValue::kMostInteger);
    if (offset > buffer.bytes.size() || length > buffer.bytes.size() - offset)
        view.fail("reaches beyond its buffer");
    return buffer.bytes.subspan(offset, length);
}

std::span<const std::byte> GltfData::view(uint64_t index, const JsonValue& from) const {
    const JsonValue& view = JsonValue::at(views_, index, from, "bufferViews");
    const auto unpacked = unpacked_.find(index);
    return unpacked == unpacked_.end() ? range(view) : std::as_bytes(std::span(unpacked->second));
}

} // namespace dirt
