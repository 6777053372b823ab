#include "core/io/gltf_data.h"

#include "core/io/find_file.h"
#include "core/io/load_report.h"
#include "core/io/text_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace dirt {

namespace {

/// Whole numbers in a file are at most what a double holds exactly.
constexpr uint64_t kHighest = uint64_t(1) << 53;
/// Elements of an accessor without data of its own, which are zero: a small file must not cost all
/// memory.
constexpr uint64_t kMostZeros = uint64_t(1) << 18;

constexpr uint64_t kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123,
                   kUnsignedInt = 5125, kFloat = 5126;

/// Extensions that may be required: those that are honoured.
constexpr std::array kKnownExtensions{"KHR_materials_emissive_strength"};

size_t componentBytes(uint64_t type) {
    switch (type) {
    case kByte:
    case kUnsignedByte:
        return 1;
    case kShort:
    case kUnsignedShort:
        return 2;
    case kUnsignedInt:
    case kFloat:
        return 4;
    default:
        return 0;
    }
}

template <typename Value>
Value valueAt(std::span<const std::byte> bytes, size_t index) {
    Value value;
    std::memcpy(&value, bytes.data() + index * sizeof(Value), sizeof(Value));
    return value;
}

uint32_t unsignedAt(std::span<const std::byte> bytes, uint64_t type, size_t index) {
    if (type == kUnsignedByte) return valueAt<uint8_t>(bytes, index);
    if (type == kUnsignedShort) return valueAt<uint16_t>(bytes, index);
    return valueAt<uint32_t>(bytes, index);
}

/// Of normalized unsigned integers (glTF 2.0, 3.6.2.2).
float normalizedAt(std::span<const std::byte> bytes, uint64_t type, size_t index) {
    if (type == kUnsignedByte) return (float) valueAt<uint8_t>(bytes, index) / 255.0f;
    return (float) valueAt<uint16_t>(bytes, index) / 65535.0f;
}

} // namespace

GltfData::GltfData(const std::filesystem::path& file) : file_(file), bytes_(readBytes(file)) {
    const auto bytes = std::as_bytes(std::span(bytes_));
    const bool binary = bytes_.starts_with("glTF");
    if (binary)
        readBinary(bytes);
    else
        json_ = bytes_;
    document_ = parseJson(file_, json_, !binary);
    root_ = std::make_unique<JsonValue>(file_, document_);
    const std::string version = root_->required("asset").text("version").value_or("");
    if (!version.starts_with("2."))
        failAt(file_, 0, "is of glTF version " + inQuotes(version) + "; 2.0 can be read");
    if (root_->has("extensionsRequired"))
        for (const auto& name : document_["extensionsRequired"])
            if (!name.is_string() || std::find(kKnownExtensions.begin(), kKnownExtensions.end(),
                                               name.get<std::string>()) == kKnownExtensions.end())
                failAt(file_, 0,
                       "requires the extension " +
                           inQuotes(name.is_string() ? name.get<std::string>() : "") +
                           ", which is not known here");
    views_ = root_->objects("bufferViews");
    accessors_ = root_->objects("accessors");
    readBuffers();
}

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

void GltfData::readBuffers() {
    const std::vector<JsonValue> buffers = root_->objects("buffers");
    loaded_.resize(buffers.size());
    for (size_t i = 0; i < buffers.size(); ++i) {
        const JsonValue& buffer = buffers[i];
        const uint64_t length = buffer.requiredInteger("byteLength", kHighest);
        std::span<const std::byte> bytes = binary_;
        if (const auto uri = buffer.text("uri")) {
            auto data = decodeDataUri(*uri, buffer);
            if (!data) {
                const auto path = findFile(file_.parent_path(), decodeUri(*uri));
                if (!path) buffer.fail("is in a file that is not there: " + inQuotes(*uri));
                data = readBytes(*path);
            }
            loaded_[i] = std::move(*data);
            bytes = std::as_bytes(std::span(loaded_[i]));
        } else if (i != 0 || binary_.data() == nullptr) {
            buffer.fail("has neither a uri nor a binary chunk");
        }
        if (length > bytes.size())
            buffer.fail("has " + std::to_string(bytes.size()) + " bytes, not " +
                        std::to_string(length));
        buffers_.push_back(bytes.first(length));
    }
}

std::span<const std::byte> GltfData::view(uint64_t index, const JsonValue& from) const {
    const JsonValue& view = JsonValue::at(views_, index, from, "bufferViews");
    const uint64_t buffer = view.requiredInteger("buffer", kHighest);
    if (buffer >= buffers_.size()) view.fail("refers to a buffer that is not there");
    const uint64_t offset = view.integer("byteOffset", kHighest).value_or(0);
    const uint64_t length = view.requiredInteger("byteLength", kHighest);
    if (offset > buffers_[buffer].size() || length > buffers_[buffer].size() - offset)
        view.fail("reaches beyond its buffer");
    return buffers_[buffer].subspan(offset, length);
}

GltfData::Elements GltfData::elements(const JsonValue& accessor, const char* type,
                                      size_t components) const {
    Elements elements;
    elements.componentType = accessor.requiredInteger("componentType", kHighest);
    elements.normalized = accessor.boolean("normalized").value_or(false);
    const size_t elementBytes = componentBytes(elements.componentType) * components;
    if (elementBytes == 0) accessor.fail("has an unknown componentType");
    if (accessor.text("type").value_or("") != type)
        accessor.fail("is not of the type " + std::string(type));
    const uint64_t count = accessor.requiredInteger("count", std::numeric_limits<uint32_t>::max());

    if (const auto index = accessor.integer("bufferView", kHighest)) {
        const auto bytes = view(*index, accessor);
        const uint64_t offset = accessor.integer("byteOffset", kHighest).value_or(0);
        const uint64_t given = views_[*index].integer("byteStride", 252).value_or(0);
        const uint64_t stride = given == 0 ? elementBytes : given;
        if (stride < elementBytes) accessor.fail("has elements longer than their byteStride");
        if (count > 0 && (offset > bytes.size() || elementBytes > bytes.size() - offset ||
                          (bytes.size() - offset - elementBytes) / stride < count - 1))
            accessor.fail("reaches beyond its bufferView");
        elements.bytes.resize(count * elementBytes);
        for (uint64_t i = 0; i < count; ++i)
            std::memcpy(elements.bytes.data() + i * elementBytes,
                        bytes.data() + offset + i * stride, elementBytes);
    } else {
        if (count > kMostZeros)
            accessor.fail("has no data and " + std::to_string(count) +
                          " elements, which is absurd");
        elements.bytes.resize(count * elementBytes);
    }
    overwriteSparse(accessor, count, elementBytes, elements.bytes);
    return elements;
}

void GltfData::overwriteSparse(const JsonValue& accessor, uint64_t count, size_t elementBytes,
                               std::vector<std::byte>& bytes) const {
    const auto sparse = accessor.object("sparse");
    if (!sparse) return;
    const uint64_t replaced = sparse->requiredInteger("count", count);
    const JsonValue places = sparse->required("indices"), values = sparse->required("values");
    const uint64_t type = places.requiredInteger("componentType", kHighest);
    if (type != kUnsignedByte && type != kUnsignedShort && type != kUnsignedInt)
        places.fail("has a componentType that is none of indices");
    const auto part = [&](const JsonValue& value, size_t size) {
        const auto all = view(value.requiredInteger("bufferView", kHighest), value);
        const uint64_t offset = value.integer("byteOffset", kHighest).value_or(0);
        if (offset > all.size() || replaced > (all.size() - offset) / size)
            value.fail("reaches beyond its bufferView");
        return all.subspan(offset, replaced * size);
    };
    const auto placeBytes = part(places, componentBytes(type));
    const auto valueBytes = part(values, elementBytes);
    for (uint64_t i = 0; i < replaced; ++i) {
        const uint32_t place = unsignedAt(placeBytes, type, i);
        if (place >= count)
            places.fail("holds " + std::to_string(place) + ", of " + std::to_string(count) +
                        " elements");
        std::memcpy(bytes.data() + place * elementBytes, valueBytes.data() + i * elementBytes,
                    elementBytes);
    }
}

std::vector<float> GltfData::floats(uint64_t index, const JsonValue& from, size_t components,
                                    bool orNormalized) const {
    const JsonValue& accessor = JsonValue::at(accessors_, index, from, "accessors");
    const Elements data = elements(accessor, components == 2 ? "VEC2" : "VEC3", components);
    const bool normalized =
        orNormalized && data.normalized &&
        (data.componentType == kUnsignedByte || data.componentType == kUnsignedShort);
    if (data.componentType != kFloat && !normalized)
        accessor.fail("has a componentType that is not allowed here");
    std::vector<float> values(data.bytes.size() / componentBytes(data.componentType));
    for (size_t i = 0; i < values.size(); ++i)
        values[i] = normalized ? normalizedAt(data.bytes, data.componentType, i)
                               : valueAt<float>(data.bytes, i);
    return values;
}

std::vector<uint32_t> GltfData::indices(uint64_t index, const JsonValue& from) const {
    const JsonValue& accessor = JsonValue::at(accessors_, index, from, "accessors");
    const Elements data = elements(accessor, "SCALAR", 1);
    if (data.componentType != kUnsignedByte && data.componentType != kUnsignedShort &&
        data.componentType != kUnsignedInt)
        accessor.fail("has a componentType that is none of indices");
    std::vector<uint32_t> values(data.bytes.size() / componentBytes(data.componentType));
    for (size_t i = 0; i < values.size(); ++i)
        values[i] = unsignedAt(data.bytes, data.componentType, i);
    return values;
}

} // namespace dirt
