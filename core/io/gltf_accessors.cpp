#include "core/io/bytes.h"
#include "core/io/gltf_data.h"
#include "core/io/gltf_members.h"
#include "core/io/load_report.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace dirt {

namespace {

/// Elements without data of their own, which are zero, that any file may have, besides one for each
/// of its bytes: a small file must not cost all memory.
constexpr uint64_t kFreeZeros = 4096;

constexpr uint64_t kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123,
                   kUnsignedInt = 5125, kFloat = 5126;
/// By the count of components, less one.
constexpr std::array<std::string_view, 4> kTypes{"SCALAR", "VEC2", "VEC3", "VEC4"};

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

uint32_t unsignedAt(std::span<const std::byte> bytes, uint64_t type, size_t index) {
    if (type == kUnsignedByte) return valueAt<uint8_t>(bytes, index);
    if (type == kUnsignedShort) return valueAt<uint16_t>(bytes, index);
    return valueAt<uint32_t>(bytes, index);
}

/// An integer as it is, or the part of the type's largest that it is; the lowest of a signed type
/// is -1 like its neighbour (glTF 2.0, 3.6.2.2).
template <typename Integer>
float integerAt(std::span<const std::byte> bytes, bool normalized, size_t index) {
    const auto value = (float) valueAt<Integer>(bytes, index);
    if (!normalized) return value;
    return std::max(value / (float) std::numeric_limits<Integer>::max(), -1.0f);
}

float numberAt(std::span<const std::byte> bytes, uint64_t type, bool normalized, size_t index) {
    switch (type) {
    case kByte:
        return integerAt<int8_t>(bytes, normalized, index);
    case kUnsignedByte:
        return integerAt<uint8_t>(bytes, normalized, index);
    case kShort:
        return integerAt<int16_t>(bytes, normalized, index);
    case kUnsignedShort:
        return integerAt<uint16_t>(bytes, normalized, index);
    default:
        return valueAt<float>(bytes, index);
    }
}

} // namespace

GltfData::Elements GltfData::elements(const JsonValue& accessor, size_t components) const {
    Elements elements;
    elements.componentType = accessor.requiredInteger("componentType", JsonValue::kMostInteger);
    elements.normalized = accessor.boolean("normalized").value_or(false);
    const size_t elementBytes = componentBytes(elements.componentType) * components;
    if (elementBytes == 0) accessor.fail("has an unknown componentType");
    const std::string_view type = kTypes[components - 1];
    if (accessor.text("type").value_or("") != type)
        accessor.fail("is not of the type " + std::string(type));
    const uint64_t count = accessor.requiredInteger("count", std::numeric_limits<uint32_t>::max());

    const uint64_t perElement = elementBytes + 2 * sizeof(float) * components;
    elements.memory = MemoryClaim(memory_.budget());
    if (const auto index = accessor.integer("bufferView", JsonValue::kMostInteger)) {
        const auto bytes = view(*index, accessor);
        const uint64_t offset = accessor.integer("byteOffset", JsonValue::kMostInteger).value_or(0);
        const uint64_t given = views_[*index].integer("byteStride", 252).value_or(0);
        const uint64_t stride = given == 0 ? elementBytes : given;
        if (stride < elementBytes) accessor.fail("has elements longer than their byteStride");
        if (count > 0 && (offset > bytes.size() || elementBytes > bytes.size() - offset ||
                          (bytes.size() - offset - elementBytes) / stride < count - 1))
            accessor.fail("reaches beyond its bufferView");
        elements.memory.take(count * perElement, file_, accessor.place());
        elements.bytes.resize(count * elementBytes);
        for (uint64_t i = 0; i < count; ++i)
            std::memcpy(elements.bytes.data() + i * elementBytes,
                        bytes.data() + offset + i * stride, elementBytes);
    } else {
        if (const auto extension = unknownExtension(accessor))
            accessor.fail("has its data in the extension " + inQuotes(*extension) + ", " +
                          whyUnknown(*extension));
        claimZeros(accessor, count);
        elements.memory.take(count * perElement, file_, accessor.place());
        elements.bytes.resize(count * elementBytes);
    }
    overwriteSparse(accessor, count, elementBytes, elements.bytes);
    return elements;
}

/// However often an accessor is read, each time makes them anew.
void GltfData::claimZeros(const JsonValue& accessor, uint64_t count) const {
    uint64_t bytes = bytes_.size();
    for (const std::string& loaded : loaded_) bytes += loaded.size();
    zeros_ += count;
    if (zeros_ > kFreeZeros + bytes)
        accessor.fail("has no data and " + std::to_string(count) +
                      " elements, which is absurd in a file of " + std::to_string(bytes) +
                      " bytes (" + std::to_string(zeros_) + " with those before)");
}

void GltfData::overwriteSparse(const JsonValue& accessor, uint64_t count, size_t elementBytes,
                               std::vector<std::byte>& bytes) const {
    const auto sparse = accessor.object("sparse");
    if (!sparse) return;
    const uint64_t replaced = sparse->requiredInteger("count", count);
    const JsonValue places = sparse->required("indices"), values = sparse->required("values");
    const uint64_t type = places.requiredInteger("componentType", JsonValue::kMostInteger);
    if (type != kUnsignedByte && type != kUnsignedShort && type != kUnsignedInt)
        places.fail("has a componentType that is none of indices");
    const auto part = [&](const JsonValue& value, size_t size) {
        const auto all = view(value.requiredInteger("bufferView", JsonValue::kMostInteger), value);
        const uint64_t offset = value.integer("byteOffset", JsonValue::kMostInteger).value_or(0);
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
                                    bool orIntegers) const {
    const JsonValue& accessor = JsonValue::at(accessors_, index, from, "accessors");
    const Elements data = elements(accessor, components);
    const bool allowed = data.componentType == kFloat ||
                         (data.componentType != kUnsignedInt && (orIntegers || data.normalized));
    if (!allowed) accessor.fail("has a componentType that is not allowed here");
    std::vector<float> values(data.bytes.size() / componentBytes(data.componentType));
    for (size_t i = 0; i < values.size(); ++i)
        values[i] = numberAt(data.bytes, data.componentType, data.normalized, i);
    return values;
}

std::vector<uint32_t> GltfData::indices(uint64_t index, const JsonValue& from) const {
    const JsonValue& accessor = JsonValue::at(accessors_, index, from, "accessors");
    const Elements data = elements(accessor, 1);
    if (data.componentType != kUnsignedByte && data.componentType != kUnsignedShort &&
        data.componentType != kUnsignedInt)
        accessor.fail("has a componentType that is none of indices");
    std::vector<uint32_t> values(data.bytes.size() / componentBytes(data.componentType));
    for (size_t i = 0; i < values.size(); ++i)
        values[i] = unsignedAt(data.bytes, data.componentType, i);
    return values;
}

size_t GltfData::components(uint64_t index, const JsonValue& from) const {
    const JsonValue& accessor = JsonValue::at(accessors_, index, from, "accessors");
    const auto found = std::find(kTypes.begin(), kTypes.end(), accessor.text("type").value_or(""));
    return found == kTypes.end() ? 1 : (size_t) (found - kTypes.begin()) + 1;
}

bool GltfData::isNormalized(uint64_t index, const JsonValue& from) const {
    return JsonValue::at(accessors_, index, from, "accessors")
        .boolean("normalized")
        .value_or(false);
}

bool GltfData::hasData(uint64_t index, const JsonValue& from) const {
    const JsonValue& accessor = JsonValue::at(accessors_, index, from, "accessors");
    return accessor.has("bufferView") || accessor.has("sparse");
}

} // namespace dirt
