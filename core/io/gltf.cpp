#include "core/io/gltf.h"

#include "core/io/gltf_faults.h"
#include "core/io/gltf_material.h"

#include <utility>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace dirt {

namespace {

constexpr uint64_t kHighest = 0xfffffffe;
/// Nodes may place one mesh any number of times: a small file must not cost all memory.
constexpr uint64_t kMostTriangles = uint64_t(1) << 28;

template <typename Vector>
std::vector<Vector> vectors(const std::vector<float>& values) {
    constexpr size_t kComponents = sizeof(Vector) / sizeof(float);
    std::vector<Vector> list(values.size() / kComponents);
    for (size_t i = 0; i < values.size(); ++i)
        list[i / kComponents][(int) (i % kComponents)] = values[i];
    return list;
}

class GltfReader {
public:
    GltfReader(const std::filesystem::path& file, LoadReport& report)
        : data_(file), report_(report) {
        gltf_.file = file;
    }

    GltfFile read() {
        const JsonValue& root = data_.root();
        for (const char* name : {"animations", "skins"})
            if (root.has(name)) report_.ignore("glTF " + std::string(name));
        gltf_.images = gltfImages(data_, report_);
        gltf_.surfaces = gltfSurfaces(data_, gltf_.images.size(), report_);
        for (const JsonValue& mesh : root.objects("meshes")) {
            auto& primitives = gltf_.meshes.emplace_back();
            for (const JsonValue& primitive : mesh.objects("primitives"))
                readPrimitive(primitive, primitives);
        }
        placeNodes();
        report_.warn(gltf_.file, faults_.faults());
        return std::move(gltf_);
    }

private:
    enum Mode : uint64_t { kTriangles = 4, kStrip = 5, kFan = 6 };

    void readPrimitive(const JsonValue& source, std::vector<GltfFile::Primitive>& list) {
        const uint64_t mode = source.integer("mode", kFan).value_or(kTriangles);
        if (mode < kTriangles) return; // points and lines
        if (source.has("targets")) report_.ignore("glTF primitive targets");
        GltfFile::Primitive primitive;
        uint64_t set = 0;
        if (const auto material = source.integer("material", kHighest)) {
            if (*material >= gltf_.surfaces.size())
                source.fail("refers to a material that is not there");
            primitive.surface = (uint32_t) *material;
            set = gltf_.surfaces[*material].texcoordSet;
        }
        readAttributes(source, set, primitive);
        const size_t count = primitive.positions.size();
        std::vector<uint32_t> corners;
        if (const auto indices = source.integer("indices", kHighest)) {
            corners = data_.indices(*indices, source);
            for (const uint32_t corner : corners)
                if (corner >= count)
                    source.fail("has index " + std::to_string(corner) + ", of " +
                                std::to_string(count) + " positions");
        } else {
            for (size_t i = 0; i < count; ++i) corners.push_back((uint32_t) i);
        }
        if (mode == kTriangles && corners.size() % 3 != 0)
            source.fail("has " + std::to_string(corners.size()) +
                        " corners, which make no whole triangles");
        primitive.triangles = trianglesOf(corners, mode);
        checkVertices(primitive, source, faults_);
        list.push_back(std::move(primitive));
    }

    void readAttributes(const JsonValue& source, uint64_t set, GltfFile::Primitive& primitive) {
        const JsonValue attributes = source.required("attributes");
        const std::string texcoord = "TEXCOORD_" + std::to_string(set);
        for (const std::string& name : attributes.names())
            if (name != "POSITION" && name != "NORMAL" && !name.starts_with("TEXCOORD_"))
                report_.ignore("glTF attribute " + name);
        // A mesh without positions shows nothing (glTF 2.0, 3.7.2.1).
        if (!attributes.has("POSITION")) return;
        primitive.positions = vectors<glm::vec3>(
            data_.floats(attributes.requiredInteger("POSITION", kHighest), attributes, 3));
        const size_t count = primitive.positions.size();
        if (const auto normals = attributes.integer("NORMAL", kHighest))
            primitive.normals = vectors<glm::vec3>(data_.floats(*normals, attributes, 3));
        if (const auto texcoords = attributes.integer(texcoord.c_str(), kHighest))
            primitive.texcoords = vectors<glm::vec2>(data_.floats(*texcoords, attributes, 2, true));
        for (const size_t size : {primitive.normals.size(), primitive.texcoords.size()})
            if (size != 0 && size != count) attributes.fail("have not all as many elements");
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

    static glm::dmat4 matrixOf(const JsonValue& node) {
        glm::dmat4 matrix(1.0);
        if (const auto values = node.numbers("matrix", 16)) {
            for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = (*values)[(size_t) i];
            if (matrix[0][3] != 0.0 || matrix[1][3] != 0.0 || matrix[2][3] != 0.0 ||
                matrix[3][3] != 1.0)
                node.fail("has a matrix that is not affine");
            return matrix;
        }
        if (const auto s = node.numbers("scale", 3))
            for (int i = 0; i < 3; ++i) matrix[i][i] = (*s)[(size_t) i];
        if (const auto r = node.numbers("rotation", 4)) {
            const glm::dquat turn((*r)[3], (*r)[0], (*r)[1], (*r)[2]);
            if (!(glm::length(turn) > 0.0)) node.fail("has a rotation of no length");
            matrix = glm::mat4_cast(glm::normalize(turn)) * matrix;
        }
        if (const auto t = node.numbers("translation", 3))
            matrix[3] = glm::dvec4((*t)[0], (*t)[1], (*t)[2], 1.0);
        return matrix;
    }

    /// The scene's roots; without scenes, all nodes that are no one's child.
    std::vector<uint64_t> rootsOf(const std::vector<JsonValue>& nodes) const {
        const JsonValue& root = data_.root();
        const auto scenes = root.objects("scenes");
        if (!scenes.empty())
            return JsonValue::at(scenes, root.integer("scene", kHighest).value_or(0), root,
                                 "scenes")
                .integers("nodes", kHighest);
        std::vector<bool> isChild(nodes.size(), false);
        for (const JsonValue& node : nodes)
            for (const uint64_t child : node.integers("children", kHighest))
                if (child < nodes.size()) isChild[child] = true;
        std::vector<uint64_t> roots;
        for (size_t i = 0; i < nodes.size(); ++i)
            if (!isChild[i]) roots.push_back(i);
        return roots;
    }

    void placeNodes() {
        struct Visit {
            uint64_t node;
            glm::dmat4 parentToFile;
        };
        const auto nodes = data_.root().objects("nodes");
        const auto roots = rootsOf(nodes);
        std::vector<Visit> open; // a stack: the first of siblings on top
        for (auto root = roots.rbegin(); root != roots.rend(); ++root)
            open.push_back({*root, glm::dmat4(1.0)});
        std::vector<bool> seen(nodes.size(), false);
        uint64_t triangles = 0;
        while (!open.empty()) {
            const Visit visit = open.back();
            open.pop_back();
            const JsonValue& node = JsonValue::at(nodes, visit.node, data_.root(), "nodes");
            if (seen[visit.node]) node.fail("is reached twice: nodes make a tree");
            seen[visit.node] = true;
            const glm::dmat4 toFile = visit.parentToFile * matrixOf(node);
            if (const auto mesh = node.integer("mesh", kHighest)) {
                if (*mesh >= gltf_.meshes.size()) node.fail("refers to a mesh that is not there");
                for (const auto& primitive : gltf_.meshes[*mesh])
                    triangles += primitive.triangles.size();
                if (triangles > kMostTriangles)
                    node.fail("makes the file one of more than " + std::to_string(kMostTriangles) +
                              " triangles, which is absurd");
                gltf_.instances.push_back({(uint32_t) *mesh, toFile});
            }
            const auto children = node.integers("children", kHighest);
            for (auto child = children.rbegin(); child != children.rend(); ++child)
                open.push_back({*child, toFile});
        }
    }

    GltfData data_;
    LoadReport& report_;
    FaultCounter faults_;
    GltfFile gltf_;
};

} // namespace

GltfFile readGltf(const std::filesystem::path& file, LoadReport& report) {
    return GltfReader(file, report).read();
}

} // namespace dirt
