#include "core/io/gltf_draco.h"

#ifdef DIRT_HAVE_DRACO

#include "core/io/load_report.h"

#include <algorithm>
#include <new>
#include <stdexcept>

#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>

namespace dirt {

namespace {

/// What a mesh says it has, before anything of it is decoded. The decoder takes memory by these
/// numbers and looks at its data afterwards.
struct Counts {
    uint32_t points = 0, faces = 0;
};

/// Counts of the bitstream 2.2, which glTF asks for; nothing where they are not there.
std::optional<Counts> countsOf(draco::DecoderBuffer buffer) {
    draco::DracoHeader header;
    if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok()) return {};
    const uint16_t version = DRACO_BITSTREAM_VERSION(header.version_major, header.version_minor);
    if (version != DRACO_BITSTREAM_VERSION(2, 2)) return {};
    buffer.set_bitstream_version(version);
    draco::GeometryMetadata metadata;
    if ((header.flags & METADATA_FLAG_MASK) != 0 &&
        !draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata))
        return {};
    Counts counts;
    bool there = true;
    if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING) {
        uint8_t traversal = 0;
        there = buffer.Decode(&traversal) && draco::DecodeVarint(&counts.points, &buffer) &&
                draco::DecodeVarint(&counts.faces, &buffer);
    } else {
        there = draco::DecodeVarint(&counts.faces, &buffer) &&
                draco::DecodeVarint(&counts.points, &buffer);
    }
    return there ? std::optional(counts) : std::nullopt;
}

/// Takes what decoding needs, in \p memory. Compressed faces may be far less than a byte, but not
/// without end.
void claim(const draco::DecoderBuffer& buffer, size_t bytes, MemoryClaim& memory,
           const JsonValue& from) {
    constexpr uint64_t kFree = 1 << 16, kPerByte = 1024; // faces, or points
    constexpr uint64_t kOfAFace = 40, kOfAPoint = 32;    // tables of corners, of vertices
    const auto counts = countsOf(buffer);
    if (!counts) from.fail("holds no Draco mesh of version 2.2 that can be read");
    if (std::max(counts->points, counts->faces) > kFree + kPerByte * bytes)
        from.fail("claims more than its bytes can hold");
    memory.take(kOfAFace * counts->faces + kOfAPoint * counts->points, from.file(), from.place());
}

std::unique_ptr<draco::Mesh> decode(std::span<const std::byte> bytes, const MemoryBudget& budget,
                                    const JsonValue& from) {
    draco::DecoderBuffer buffer;
    buffer.Init((const char*) bytes.data(), bytes.size());
    MemoryClaim meanwhile(budget);
    claim(buffer, bytes.size(), meanwhile, from);
    try {
        draco::Decoder decoder;
        auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
        if (mesh.ok()) return std::move(mesh).value();
    } catch (const std::bad_alloc&) { // a damaged count
    } catch (const std::length_error&) {
    }
    from.fail("holds no Draco mesh that can be read");
}

/// \p source's values for each of the mesh's points; integers as glTF's accessor has them.
std::vector<float> valuesOf(const draco::PointAttribute& source, size_t points, bool normalized,
                            const JsonValue& from) {
    draco::PointAttribute attribute;
    attribute.CopyFrom(source);
    attribute.set_normalized(normalized);
    const auto components = (size_t) attribute.num_components();
    std::vector<float> values(points * components);
    for (size_t i = 0; i < points; ++i)
        if (!attribute.ConvertValue<float>(attribute.mapped_index(draco::PointIndex((uint32_t) i)),
                                           (int8_t) components, values.data() + i * components))
            from.fail("holds an attribute that is no vector of numbers");
    return values;
}

} // namespace

std::optional<DracoMesh> readDraco(const GltfData& data, const JsonValue& primitive) {
    const auto extensions = primitive.object("extensions");
    const auto source =
        extensions ? extensions->object("KHR_draco_mesh_compression") : std::nullopt;
    if (!source) return std::nullopt;
    const auto mesh =
        decode(data.view(source->requiredInteger("bufferView", JsonValue::kMostIndex), *source),
               data.memory().budget(), *source);
    uint64_t bytes = 3 * sizeof(uint32_t) * uint64_t(mesh->num_faces());
    for (int i = 0; i < mesh->num_attributes(); ++i)
        bytes += sizeof(float) * uint64_t(mesh->num_points()) *
                 (uint64_t) mesh->attribute(i)->num_components();
    data.memory().take(bytes, data.file(), primitive.place());
    DracoMesh result;
    for (uint32_t i = 0; i < mesh->num_faces(); ++i)
        for (const auto& corner : mesh->face(draco::FaceIndex(i)))
            result.corners.push_back(corner.value());
    const JsonValue ids = source->required("attributes");
    const JsonValue accessors = primitive.required("attributes");
    for (const std::string& name : ids.names()) {
        const auto id = (uint32_t) ids.requiredInteger(name.c_str(), JsonValue::kMostIndex);
        const draco::PointAttribute* attribute = mesh->GetAttributeByUniqueId(id);
        if (attribute == nullptr || attribute->num_components() > 4)
            ids.fail("name " + inQuotes(name) + ", which is no vector there");
        const auto accessor = accessors.integer(name.c_str(), JsonValue::kMostIndex);
        if (!accessor) continue;
        result.attributes[name] = {
            (size_t) attribute->num_components(),
            valuesOf(*attribute, mesh->num_points(), data.isNormalized(*accessor, accessors), ids)};
    }
    return result;
}

} // namespace dirt

#else

namespace dirt {

std::optional<DracoMesh> readDraco(const GltfData&, const JsonValue&) {
    return std::nullopt;
}

} // namespace dirt

#endif

namespace dirt {

std::optional<std::vector<float>> DracoMesh::values(const std::string& name,
                                                    size_t components) const {
    const auto found = attributes.find(name);
    if (found == attributes.end() || found->second.first < components) return std::nullopt;
    const auto& [given, all] = found->second;
    std::vector<float> values;
    values.reserve(all.size() / given * components);
    for (size_t i = 0; i < all.size(); i += given)
        values.insert(values.end(), all.begin() + (ptrdiff_t) i,
                      all.begin() + (ptrdiff_t) (i + components));
    return values;
}

} // namespace dirt
