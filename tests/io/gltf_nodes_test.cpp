// Where nodes of glTF files place what: instances, hidden nodes, matrices that are nearly affine.

#include "tests/io/gltf_fixture.h"

namespace dirt {
namespace {

std::pair<glm::vec3, glm::vec3> boxOf(const Mesh& mesh) {
    glm::vec3 low = mesh.positions.at(0), high = low;
    for (const glm::vec3& p : mesh.positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return {low, high};
}

TEST_F(Gltf, InstancesHaveTranslationsRotationsAndScales) {
    GltfWriter writer;
    writer.triangle();
    const auto place = [&](const Json& attributes) -> Json& {
        writer.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"] = {
            {"attributes", attributes}};
        return writer.json["nodes"][0];
    };
    const size_t translations = writer.vec3({-3, 0, 0, 0, 0, 0, 3, 0, 0, 0, 3, 0});
    place({{"TRANSLATION", translations}});
    const LoadedScene four = load(writer);
    EXPECT_EQ(four.scene.mesh.triangles.size(), 4u);
    EXPECT_EQ(boxOf(four.scene.mesh).first, glm::vec3(-3, 0, 0));
    EXPECT_EQ(boxOf(four.scene.mesh).second, glm::vec3(4, 4, 0));
    EXPECT_TRUE(four.ignored.empty());

    // Inside the node: a half turn about Z as normalized bytes, then the node's own move.
    const size_t turn = writer.accessor<int8_t>("VEC4", 5120, 4, {0, 0, 127, 0});
    writer.json["accessors"][turn]["normalized"] = true;
    const size_t scale = writer.vec3({2, 3, 1}), to = writer.vec3({0, 0, 5});
    place({{"TRANSLATION", to},
           {"ROTATION", turn},
           {"SCALE", scale},
           {"_ID", scale}})["translation"] = {10, 0, 0};
    const LoadedScene turned = load(writer);
    EXPECT_EQ(turned.scene.mesh.positions,
              (std::vector<glm::vec3>{{10, 0, 5}, {8, 0, 5}, {10, -3, 5}}));
    EXPECT_EQ(turned.ignored, std::vector<std::string>{"glTF instancing attribute _ID (1)"});

    place({{"TRANSLATION", translations}, {"SCALE", scale}});
    EXPECT_EQ(error("a.gltf", writer.embedded()),
              ": nodes[0].extensions.EXT_mesh_gpu_instancing.attributes have not all as many "
              "elements");
    place({{"TRANSLATION", writer.vec3({0, std::numeric_limits<float>::infinity(), 0})}});
    EXPECT_EQ(error("a.gltf", writer.embedded()),
              ": nodes[0].extensions.EXT_mesh_gpu_instancing.attributes have a TRANSLATION that is "
              "not finite");
}

TEST_F(Gltf, HiddenNodesHideWhatIsBelowThem) {
    GltfWriter writer;
    const size_t mesh = writer.triangle();
    const size_t hidden = writer.node({{"translation", {2, 0, 0}}, {"mesh", mesh}});
    writer.json["nodes"][hidden]["extensions"]["KHR_node_visibility"] = {{"visible", false}};
    writer.json["nodes"].push_back({{"mesh", mesh}, {"translation", {0, 7, 0}}});
    writer.json["nodes"][2]["extensions"]["KHR_node_visibility"] = {{"visible", true}};
    writer.json["nodes"][hidden]["children"] = {2};
    writer.json["extensionsRequired"] = {"KHR_node_visibility"};
    const LoadedScene loaded = load(writer);
    EXPECT_EQ(loaded.scene.mesh.triangles.size(), 1u);
    EXPECT_EQ(boxOf(loaded.scene.mesh).second, glm::vec3(1, 1, 0));
    EXPECT_TRUE(loaded.ignored.empty());
    writer.json["nodes"][hidden]["extensions"]["KHR_node_visibility"] = Json::object();
    EXPECT_EQ(load(writer).scene.mesh.triangles.size(), 3u);
}

/// Exporters write what their float arithmetic leaves of the row 0 0 0 1.
TEST_F(Gltf, MatricesMayBeAffineToFloatsPrecision) {
    const auto matrix = [](double perspective, double w) {
        return Json({1, 0, 0, perspective, 0, 1, 0, 0, 0, 0, 1, 0, 2, 0, 0, w});
    };
    for (const Json& near : {matrix(0, 0.99999994), matrix(1e-17, 1), matrix(-0x1p-20, 1)}) {
        GltfWriter writer;
        writer.triangle();
        writer.json["nodes"][0]["matrix"] = near;
        const LoadedScene loaded = load(writer);
        EXPECT_EQ(boxOf(loaded.scene.mesh).first, glm::vec3(2, 0, 0)) << near;
        EXPECT_EQ(boxOf(loaded.scene.mesh).second, glm::vec3(3, 1, 0)) << near;
    }
    for (const Json& far : {matrix(0, 1.00001), matrix(1e-5, 1), matrix(0, 0)})
        EXPECT_EQ(errorOf([&](auto& w) { w.json["nodes"][0]["matrix"] = far; }),
                  ": nodes[0] has a matrix that is not affine");
}

} // namespace
} // namespace dirt
