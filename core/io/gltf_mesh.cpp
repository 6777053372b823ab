#include "core/io/gltf_mesh.h"

#include "core/io/gltf_draco.h"
#include "core/io/gltf_faults.h"

#include <algorithm>
#include <optional>

namespace dirt {

namespace {

template <typename Vector>
std::vector<Vector> vectors(const std::vector<float>& values) {
    constexpr size_t kComponents = sizeof(Vector) / sizeof(float);
    std::vector<Vector> list(values.size() / kComponents);
    for (size_t i = 0; i < values.size(); ++i)
        list[i / kComponents][(int) (i % kComponents)] = values[i];
    return list;
}

class PrimitiveReader {
public:
    PrimitiveReader(const GltfData& data, const JsonValue& source,
                    std::span<const GltfFile::Surface> surfaces, GltfIgnored& ignored,
                    FaultCounter& faults)
        : data_(data), source_(source), surfaces_(surfaces), ignored_(ignored), faults_(faults),
          attributes_(source.required("attributes")) {}

    GltfFile::Primitive read(uint64_t mode) {
        GltfFile::Primitive primitive;
        uint64_t set = 0;
        if (const auto material = source_.integer("material", JsonValue::kMostIndex)) {
            if (*material >= surfaces_.size())
                source_.fail("refers to a material that is not there");
            primitive.surface = (uint32_t) *material;
            set = surfaces_[*material].texcoordSet;
        }
        const std::string texcoords = "TEXCOORD_" + std::to_string(set);
        if (primitive.surface != GltfFile::kNone && surfaces_[primitive.surface].hasTexture() &&
            !attributes_.has(texcoords.c_str()))
            ignored_.add("textures where the mesh has no " + texcoords);
        draco_ = readDraco(data_, source_);
        readAttributes(set, primitive);
        if (draco_) mode = kTriangles;
        std::vector<uint32_t> corners = readCorners(primitive.positions.size());
        if (mode == kTriangles && corners.size() % 3 != 0)
            source_.fail("has " + std::to_string(corners.size()) +
                         " corners, which make no whole triangles");
        primitive.triangles = trianglesOf(corners, mode);
        return primitive;
    }

    enum Mode : uint64_t { kTriangles = 4, kStrip = 5, kFan = 6 };

private:
    std::vector<uint32_t> readCorners(size_t count) const {
        std::vector<uint32_t> corners;
        const auto indices = source_.integer("indices", JsonValue::kMostIndex);
        if (draco_) {
            corners = draco_->corners;
        } else if (indices) {
            requireData(*indices);
            corners = data_.indices(*indices, source_);
        } else {
            for (size_t i = 0; i < count; ++i) corners.push_back((uint32_t) i);
        }
        for (const uint32_t corner : corners)
            if (corner >= count)
                source_.fail("has index " + std::to_string(corner) + ", of " +
                             std::to_string(count) + " positions");
        return corners;
    }

    void readAttributes(uint64_t set, GltfFile::Primitive& primitive) const {
        // A mesh without positions shows nothing (glTF 2.0, 3.7.2.1).
        if (!attributes_.has("POSITION")) return;
        primitive.positions = vectors<glm::vec3>(values("POSITION", 3));
        const size_t count = primitive.positions.size();
        primitive.normals = vectors<glm::vec3>(values("NORMAL", 3));
        primitive.texcoords =
            vectors<glm::vec2>(values(("TEXCOORD_" + std::to_string(set)).c_str(), 2));
        primitive.colors = colors();
        for (const size_t size :
             {primitive.normals.size(), primitive.texcoords.size(), primitive.colors.size()})
            if (size != 0 && size != count) attributes_.fail("have not all as many elements");
    }

    /// Of three or four components, whose last is alpha.
    std::vector<glm::vec3> colors() const {
        const auto accessor = attributes_.integer("COLOR_0", JsonValue::kMostIndex);
        if (!accessor) return {};
        const size_t components = data_.components(*accessor, attributes_) == 4 ? 4 : 3;
        const std::vector<float> all = values("COLOR_0", components);
        std::vector<glm::vec3> colors(all.size() / components);
        for (size_t i = 0; i < colors.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                const float value = all[i * components + (size_t) k];
                colors[i][k] = value >= 0.0f ? std::min(value, 1.0f) : 0.0f; // NaN, too
                if (colors[i][k] != value) notAColor(i);
            }
        if (components == 4)
            for (size_t i = 3; i < all.size(); i += 4)
                if (all[i] < 1.0f) {
                    ignored_.add("attribute COLOR_0 alpha");
                    break;
                }
        return colors;
    }

    void notAColor(size_t vertex) const {
        faults_.add(WarningKind::unusableAttribute, "color", 0, [&] {
            return source_.place() + " has color " + std::to_string(vertex) +
                   ", which is not from 0 to 1: the nearest is taken, for a NaN 0";
        });
    }

    /// An attribute's values, one after the other; none where the primitive has not got it.
    std::vector<float> values(const char* name, size_t components) const {
        const auto accessor = attributes_.integer(name, JsonValue::kMostIndex);
        if (!accessor) return {};
        if (draco_)
            if (const auto values = draco_->values(name, components)) return *values;
        requireData(*accessor);
        return data_.floats(*accessor, attributes_, components, true);
    }

    /// An accessor without data holds zeros, unless an extension that we do not know has its data:
    /// then there is no telling what the picture would be.
    void requireData(uint64_t accessor) const {
        if (data_.hasData(accessor, source_)) return;
        if (const auto extension = unknownExtension(source_))
            source_.fail("has its geometry in the extension " + inQuotes(*extension) + ", " +
                         whyUnknown(*extension));
    }

    /// In the order and with the winding of glTF 2.0, 3.7.2.1.
    static std::vector<std::array<uint32_t, 3>> trianglesOf(const std::vector<uint32_t>& corners,
                                                            uint64_t mode) {
        std::vector<std::array<uint32_t, 3>> triangles;
        if (mode == kTriangles)
            for (size_t i = 0; i + 2 < corners.size(); i += 3)
                triangles.push_back({corners[i], corners[i + 1], corners[i + 2]});
        else if (mode == kStrip)
            for (size_t i = 0; i + 2 < corners.size(); ++i)
                triangles.push_back({corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
        else
            for (size_t i = 0; i + 2 < corners.size(); ++i)
                triangles.push_back({corners[i + 1], corners[i + 2], corners[0]});
        return triangles;
    }

    const GltfData& data_;
    const JsonValue& source_;
    std::span<const GltfFile::Surface> surfaces_;
    GltfIgnored& ignored_;
    FaultCounter& faults_;
    JsonValue attributes_;
    std::optional<DracoMesh> draco_;
};

uint64_t bytesOf(const GltfFile::Primitive& primitive) {
    uint64_t sum = sizeof primitive;
    const auto add = [&sum](const auto& array) { sum += array.capacity() * sizeof array[0]; };
    add(primitive.positions);
    add(primitive.normals);
    add(primitive.texcoords);
    add(primitive.colors);
    add(primitive.triangles);
    return sum;
}

} // namespace

std::vector<GltfFile::Primitive> gltfPrimitives(const GltfData& data, const JsonValue& mesh,
                                                std::span<const GltfFile::Surface> surfaces,
                                                GltfIgnored& ignored, FaultCounter& faults,
                                                MemoryClaim& memory) {
    std::vector<GltfFile::Primitive> list;
    for (const JsonValue& source : mesh.objects("primitives")) {
        const uint64_t mode =
            source.integer("mode", PrimitiveReader::kFan).value_or(PrimitiveReader::kTriangles);
        if (mode < PrimitiveReader::kTriangles) {
            ignored.add(mode == 0 ? "primitive of points" : "primitive of lines");
            continue;
        }
        list.push_back(PrimitiveReader(data, source, surfaces, ignored, faults).read(mode));
        memory.take(bytesOf(list.back()), data.file(), source.place());
        checkVertices(list.back(), source, faults);
    }
    return list;
}

} // namespace dirt
