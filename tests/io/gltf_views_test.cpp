// Cameras and lights of glTF files.

#include "core/path/grid_spotlight.h"
#include "tests/io/gltf_fixture.h"

#include <numbers>

namespace dirt {
namespace {

/// A triangle and a perspective camera, 20 units before it.
GltfWriter filmed() {
    GltfWriter writer;
    writer.triangle();
    writer.json["cameras"] =
        Json::parse(R"([{"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}}])");
    writer.node({{"camera", 0}, {"translation", {0, 0, 20}}});
    return writer;
}

TEST_F(Gltf, TheFirstCameraIsTheScenes) {
    const LoadedScene loaded = load(filmed());
    EXPECT_TRUE(loaded.hasCamera);
    EXPECT_EQ(loaded.modelCamera, 0u);
    const Camera& camera = loaded.scene.camera;
    EXPECT_EQ(camera.eye, glm::vec3(0, 0, 20));
    EXPECT_EQ(glm::normalize(camera.target - camera.eye), glm::vec3(0, 0, -1));
    EXPECT_EQ(camera.up, glm::vec3(0, 1, 0));
    EXPECT_EQ(camera.verticalFov, (float) (0.5 * 180.0 / std::numbers::pi));
    EXPECT_TRUE(loaded.ignored.empty());
}

/// In the order of `cameras`, whatever that of the nodes.
TEST_F(Gltf, CamerasAreCountedAsTheFileListsThem) {
    GltfWriter writer = filmed();
    writer.json["cameras"].push_back(writer.json["cameras"][0]);
    writer.json["cameras"][1]["name"] = "front";
    writer.json["nodes"][1]["camera"] = 1;
    const double half = std::sqrt(0.5); // a quarter turn about X: -Z looks up
    writer.node({{"camera", 0}, {"rotation", {half, 0, 0, half}}, {"name", "up"}});
    const LoadedScene loaded = load(writer);
    ASSERT_EQ(loaded.cameras.size(), 2u);
    EXPECT_EQ(loaded.cameras[0].name, "up");
    EXPECT_EQ(loaded.cameras[1].name, "front");
    EXPECT_EQ(loaded.modelCamera, 0u);
    EXPECT_EQ(loaded.scene.camera.eye, glm::vec3(0));
    EXPECT_NEAR(loaded.scene.camera.target.y, 1.0f, 0x1p-22f);
    EXPECT_NEAR(loaded.scene.camera.up.z, 1.0f, 0x1p-22f);
}

/// From afar, and the middle of the scene as large as it is.
TEST_F(Gltf, OrthographicCamerasAreApproximated) {
    GltfWriter writer = filmed();
    writer.json["cameras"][0] = {
        {"type", "orthographic"},
        {"orthographic", {{"xmag", 3}, {"ymag", 2}, {"znear", 0.1}, {"zfar", 9}}}};
    const LoadedScene loaded = load(writer);
    const Camera& camera = loaded.scene.camera;
    EXPECT_EQ(glm::vec2(camera.eye), glm::vec2(0, 0));
    const double distance = camera.eye.z; // of the triangle in z = 0
    EXPECT_EQ(distance, 32.0);
    EXPECT_NEAR(std::tan(camera.verticalFov * std::numbers::pi / 360.0) * distance, 2.0, 0x1p-20);
    EXPECT_EQ(loaded.ignored,
              std::vector<std::string>{
                  "glTF camera of type orthographic but as a perspective one from afar (1)"});
}

TEST_F(Gltf, ASceneFilesUserGoesBeforeAModelsCamera) {
    folder_.write("a.gltf", filmed().embedded());
    const auto scene = [&](const std::string& inside) {
        return loadScene(folder_.write("a.scene", "<world>" + inside + "</world>"));
    };
    const std::string object = "<transformation scale='2 2 2' translation='1 0 0'>"
                               "<object file='a.gltf'/></transformation>";
    const LoadedScene without = scene(object);
    EXPECT_TRUE(without.hasCamera);
    EXPECT_EQ(without.scene.camera.eye, glm::vec3(1, 0, 40));
    const LoadedScene with = scene("<user position='0 0 3' lookat='0 0 0'/>" + object);
    EXPECT_EQ(with.scene.camera.eye, glm::vec3(0, 0, 3));
    EXPECT_FALSE(with.modelCamera);
    EXPECT_EQ(with.cameras.size(), 1u) << "which may be chosen still";
}

TEST_F(Gltf, RefusesCamerasWithoutAView) {
    const auto cameraError = [&](const char* camera) {
        return errorOf([&](auto& w) {
            w.json["cameras"] = Json::array({Json::parse(camera)});
            w.node({{"camera", 0}, {"scale", {0, 0, 0}}});
        });
    };
    EXPECT_EQ(cameraError(R"({"type": "perspective"})"), ": cameras[0] has no perspective");
    EXPECT_EQ(cameraError(R"({"type": "perspective", "perspective": {"yfov": 0}})"),
              ": cameras[0].perspective has no yfov between 0 and pi");
    EXPECT_EQ(cameraError(R"({"type": "perspective", "perspective": {"yfov": 1}})"),
              ": cameras[0] has no place or no direction");
    EXPECT_EQ(errorOf([](auto& w) { w.json["nodes"][0]["camera"] = 3; }),
              ": nodes[0] refers to a camera that is not there");
}

/// A triangle and a node with the given light, 3 above it, shining down.
GltfWriter lit(const char* light) {
    GltfWriter writer;
    writer.triangle();
    writer.json["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({Json::parse(light)});
    const double half = std::sqrt(0.5);
    Json node = {{"translation", {0, 3, 0}}, {"rotation", {-half, 0, 0, half}}};
    node["extensions"]["KHR_lights_punctual"]["light"] = 0;
    writer.node(node);
    return writer;
}

TEST_F(Gltf, TheFirstSpotlightShinesAsItsIntensitySays) {
    const LoadedScene loaded = load(lit(R"({"type": "spot", "color": [1, 0.5, 0],
        "intensity": 500, "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.6}})"));
    ASSERT_TRUE(loaded.hasLight);
    EXPECT_TRUE(loaded.ignored.empty());
    const Spotlight& light = loaded.scene.lights.at(0);
    EXPECT_EQ(light.position, glm::vec3(0, 3, 0));
    const GridFrame frame; // the world's
    const GridSpotlight grid = makeGridSpotlight(light, frame);
    const auto received = [&](double angle) {
        const glm::vec3 point(std::sin(angle), 3.0 - std::cos(angle), 0.0);
        return sampleSpotlight(grid, point).irradiance.x;
    };
    // The extension's falloff: ((cos - cos outer) / (cos inner - cos outer))^2.
    const auto expected = [](double angle) {
        const double part = (std::cos(angle) - std::cos(0.6)) / (std::cos(0.2) - std::cos(0.6));
        return 500.0 * std::min(part, 1.0) * std::min(part, 1.0);
    };
    for (const double angle : {0.0, 0.1, 0.3, 0.4, 0.5, 0.55})
        // Angles are rounded to float in degrees; beside the rim part loses four bits.
        EXPECT_NEAR(received(angle), expected(angle), 500.0 * 0x1p-18) << angle;
    EXPECT_EQ(received(0.61), 0.0f);
    EXPECT_NEAR(sampleSpotlight(grid, {0, 1, 0}).irradiance.y, 250.0 / 4.0, 250.0 * 0x1p-20);
}

TEST_F(Gltf, OtherLightsAreNamed) {
    GltfWriter writer = lit(R"({"type": "spot", "range": 10})");
    Json& lights = writer.json["extensions"]["KHR_lights_punctual"]["lights"];
    lights.push_back({{"type", "point"}});
    lights.push_back({{"type", "directional"}});
    for (const int light : {1, 0, 1, 2}) {
        Json node = Json::object();
        node["extensions"]["KHR_lights_punctual"]["light"] = light;
        writer.node(node);
    }
    const LoadedScene loaded = load(writer);
    EXPECT_EQ(loaded.scene.lights.at(0).aperture, 90.0f);
    EXPECT_EQ(loaded.scene.lights.at(0).penumbra, 0.0f);
    EXPECT_EQ(loaded.ignored,
              (std::vector<std::string>{
                  "glTF light of type directional (1)", "glTF light of type point (2)",
                  "glTF light of type spot after the first (1)", "glTF light range (1)"}));
    EXPECT_EQ(
        errorOf(
            [](auto& w) { w.json["nodes"][0]["extensions"]["KHR_lights_punctual"]["light"] = 0; }),
        ": nodes[0].extensions.KHR_lights_punctual refers to lights[0], of which there are 0");
    EXPECT_EQ(error("a.gltf", lit(R"({"type": "spot", "spot": {"outerConeAngle": 2}})").embedded()),
              ": extensions.KHR_lights_punctual.lights[0].spot.outerConeAngle is out of range");
}

TEST_F(Gltf, ASceneFilesLightGoesBeforeAModels) {
    folder_.write("a.gltf", lit(R"({"type": "spot"})").embedded());
    const LoadedScene loaded = loadScene(folder_.write(
        "a.scene",
        "<world><light position='0 9 0' target='0 0 0'/><object file='a.gltf'/></world>"));
    ASSERT_EQ(loaded.scene.lights.size(), 1u);
    EXPECT_EQ(loaded.scene.lights[0].position, glm::vec3(0, 9, 0));
    EXPECT_EQ(loaded.ignored,
              std::vector<std::string>{"glTF light of type spot beside another light"});
}

} // namespace
} // namespace dirt
