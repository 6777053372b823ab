#include "core/io/gltf_nodes.h"

#include "core/io/gltf_instancing.h"
#include "core/io/gltf_transform.h"

#include <algorithm>

namespace dirt {

namespace {

/// Nodes may place one mesh any number of times: a small file must not cost all memory.
constexpr uint64_t kMostTriangles = uint64_t(1) << 28;

class NodeWalk {
public:
    NodeWalk(const GltfData& data, GltfFile& gltf, GltfIgnored& ignored, MemoryClaim& memory)
        : data_(data), gltf_(gltf), ignored_(ignored), memory_(memory),
          nodes_(data.root().objects("nodes")), cameras_(gltfCameras(data)),
          lights_(data, ignored) {}

    void walk() {
        const auto roots = rootsOf();
        std::vector<Visit> open; // a stack: the first of siblings on top
        for (auto root = roots.rbegin(); root != roots.rend(); ++root)
            open.push_back({*root, glm::dmat4(1.0), true});
        std::vector<bool> seen(nodes_.size(), false);
        while (!open.empty()) {
            const Visit visit = open.back();
            open.pop_back();
            const JsonValue& node = JsonValue::at(nodes_, visit.node, data_.root(), "nodes");
            if (seen[visit.node]) node.fail("is reached twice: nodes make a tree");
            seen[visit.node] = true;
            const glm::dmat4 toFile = visit.parentToFile * gltfTransformOf(node);
            const bool visible = visit.visible && isVisible(node);
            place(node, toFile, visible);
            const auto children = node.integers("children", JsonValue::kMostIndex);
            for (auto child = children.rbegin(); child != children.rend(); ++child)
                open.push_back({*child, toFile, visible});
        }
        // A file's first camera is the first that it lists, wherever its node stands.
        std::stable_sort(
            gltf_.cameras.begin(), gltf_.cameras.end(),
            [](const GltfCamera& a, const GltfCamera& b) { return a.index < b.index; });
        gltf_.spotlight = lights_.spotlight();
    }

private:
    struct Visit {
        uint64_t node;
        glm::dmat4 parentToFile;
        bool visible;
    };

    /// The scene's roots; without scenes, all nodes that are no one's child.
    std::vector<uint64_t> rootsOf() {
        const JsonValue& root = data_.root();
        const auto scenes = root.objects("scenes");
        if (scenes.size() > 1) ignored_.add("scenes but one", scenes.size() - 1);
        if (!scenes.empty())
            return JsonValue::at(scenes, root.integer("scene", JsonValue::kMostIndex).value_or(0),
                                 root, "scenes")
                .integers("nodes", JsonValue::kMostIndex);
        std::vector<bool> isChild(nodes_.size(), false);
        for (const JsonValue& node : nodes_)
            for (const uint64_t child : node.integers("children", JsonValue::kMostIndex))
                if (child < nodes_.size()) isChild[child] = true;
        std::vector<uint64_t> roots;
        for (size_t i = 0; i < nodes_.size(); ++i)
            if (!isChild[i]) roots.push_back(i);
        return roots;
    }

    static bool isVisible(const JsonValue& node) {
        const auto extensions = node.object("extensions");
        const auto visibility =
            extensions ? extensions->object("KHR_node_visibility") : std::nullopt;
        return !visibility || visibility->boolean("visible").value_or(true);
    }

    /// What is not visible neither shows nor shines; cameras are never seen.
    void place(const JsonValue& node, const glm::dmat4& toFile, bool visible) {
        if (const auto camera = node.integer("camera", JsonValue::kMostIndex))
            placeCamera(node, *camera, toFile);
        if (!visible) return;
        lights_.place(node, toFile);
        const auto mesh = node.integer("mesh", JsonValue::kMostIndex);
        if (!mesh) return;
        if (*mesh >= gltf_.meshes.size()) node.fail("refers to a mesh that is not there");
        if (const auto instances = gltfInstances(data_, node))
            for (const glm::dmat4& toNode : *instances) placeMesh(node, *mesh, toFile * toNode);
        else
            placeMesh(node, *mesh, toFile);
    }

    void placeCamera(const JsonValue& node, uint64_t index, const glm::dmat4& toFile) {
        if (index >= cameras_.size()) node.fail("refers to a camera that is not there");
        GltfCamera camera = cameras_[index];
        const std::string name = printable(node.text("name").value_or(""));
        if (!name.empty()) camera.name = name;
        camera.toFile = toFile;
        if (camera.halfHeight)
            ignored_.add("camera of type orthographic but as a perspective one from afar");
        gltf_.cameras.push_back(camera);
    }

    void placeMesh(const JsonValue& node, uint64_t mesh, const glm::dmat4& toFile) {
        for (const auto& primitive : gltf_.meshes[mesh]) triangles_ += primitive.triangles.size();
        if (triangles_ > kMostTriangles)
            node.fail("makes the file one of more than " + std::to_string(kMostTriangles) +
                      " triangles, which is absurd");
        memory_.take(2 * sizeof(GltfFile::Instance), gltf_.file, "the list of instances");
        gltf_.instances.push_back({(uint32_t) mesh, toFile});
    }

    const GltfData& data_;
    GltfFile& gltf_;
    GltfIgnored& ignored_;
    MemoryClaim& memory_;
    std::vector<JsonValue> nodes_;
    std::vector<GltfCamera> cameras_;
    GltfLights lights_;
    uint64_t triangles_ = 0;
};

} // namespace

void placeGltfNodes(const GltfData& data, GltfFile& gltf, GltfIgnored& ignored,
                    MemoryClaim& memory) {
    NodeWalk(data, gltf, ignored, memory).walk();
}

} // namespace dirt
