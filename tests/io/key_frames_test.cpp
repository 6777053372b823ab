// <animation> in scene files.

#include "core/io/load.h"
#include "core/io/scene_file.h"
#include "tests/io/input_error.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <glm/vec4.hpp>

namespace dirt {
namespace {

class KeyFrames : public testing::Test {
protected:
    SceneFile read(const std::string& content, const std::string& world = "") {
        return readSceneFile(write(content, world), report_);
    }
    std::string error(const std::string& content) {
        const std::string file = write(content, "");
        const std::string what = inputError([&] { readSceneFile(file, report_); });
        return what.empty() ? what : what.substr(file.size());
    }
    std::string write(const std::string& content, const std::string& world) {
        return folder_.write("test.scene", "<world" + world + ">\n" + content + "\n</world>");
    }

    test::TemporaryFolder folder_;
    LoadReport report_;
};

const std::string kObject = "<object file='a.obj'/>";

TEST_F(KeyFrames, OfATransformation) {
    const SceneFile scene =
        read("<transformation scale='2 2 2' rotation='30 0 1 0' translation='5 5 5'><animation>\n"
             "<key time='0.5' translation='1 2 3'/>\n"
             "<key frame='20' translation='4 5 6' rotation='90 0 0 2'/></animation>" +
                 kObject + "</transformation>" + kObject,
             " fps='10'");
    EXPECT_TRUE(report_.ignored().empty()) << report_.ignored().front();
    EXPECT_EQ(scene.animation.fps, 10.0);
    ASSERT_EQ(scene.animation.spaces.size(), 1u);
    const TransformMotion& motion = scene.animation.spaces[0].motion;
    ASSERT_EQ(motion.translation.keys.size(), 2u);
    EXPECT_EQ(motion.translation.keys[0].time, 0.5);
    EXPECT_EQ(motion.translation.keys[0].value, glm::dvec3(1, 2, 3));
    EXPECT_EQ(motion.translation.keys[1].time, 2.0);
    ASSERT_EQ(motion.rotation.keys.size(), 1u) << "the second key alone turns";
    EXPECT_EQ(motion.rotation.keys[0].value.degrees, 90.0);
    ASSERT_EQ(motion.scale.keys.size(), 1u) << "no key scales: the element does";
    EXPECT_EQ(motion.scale.keys[0].value, glm::dvec3(2));
    ASSERT_EQ(scene.objects.size(), 2u);
    EXPECT_EQ(scene.objects[0].space, 0u);
    EXPECT_EQ(scene.objects[0].toSpace, glm::dmat4(1.0));
    EXPECT_EQ(scene.objects[1].space, MovingSpace::kWorld);
}

TEST_F(KeyFrames, TransformationsInAndAroundAMotion) {
    const SceneFile scene =
        read("<transformation translation='1 0 0'><transformation><animation><key time='0' "
             "scale='1 1 1'/></animation><transformation translation='0 2 0'>" +
             kObject + "<transformation><animation><key time='1'/></animation>" + kObject +
             "</transformation></transformation></transformation>" + kObject + "</transformation>");
    ASSERT_EQ(scene.animation.spaces.size(), 2u);
    EXPECT_EQ(scene.animation.spaces[0].parent, MovingSpace::kWorld);
    EXPECT_EQ(scene.animation.spaces[0].toParent[3], glm::dvec4(1, 0, 0, 1));
    EXPECT_EQ(scene.animation.spaces[1].parent, 0u);
    EXPECT_EQ(scene.animation.spaces[1].toParent[3], glm::dvec4(0, 2, 0, 1));
    ASSERT_EQ(scene.objects.size(), 3u);
    EXPECT_EQ(scene.objects[0].space, 0u);
    EXPECT_EQ(scene.objects[0].toSpace[3], glm::dvec4(0, 2, 0, 1));
    EXPECT_EQ(scene.objects[1].space, 1u);
    EXPECT_EQ(scene.objects[1].toSpace[3], glm::dvec4(0, 0, 0, 1));
    EXPECT_EQ(scene.objects[2].space, MovingSpace::kWorld);
    EXPECT_EQ(scene.objects[2].toSpace[3], glm::dvec4(1, 0, 0, 1));
}

TEST_F(KeyFrames, OfTheCamera) {
    const SceneFile scene =
        read("<camera aperture='30'><animation><key time='0' aperture='20'/><key time='1' "
             "aperture='40'/></animation></camera>"
             "<user position='0 0 1' lookat='0 0 0'><animation><key time='0' position='1 1 1'/>"
             "<key time='2' lookat='3 3 3' up='0 0 1'/></animation></user>");
    EXPECT_TRUE(report_.ignored().empty()) << report_.ignored().front();
    ASSERT_TRUE(scene.animation.camera);
    EXPECT_EQ(scene.animation.camera->verticalFov.keys.size(), 2u);
    EXPECT_EQ(scene.animation.camera->eye.keys.size(), 1u);
    EXPECT_EQ(scene.animation.camera->target.keys[0].value, glm::dvec3(3));
    EXPECT_EQ(scene.animation.camera->up.keys[0].value, glm::dvec3(0, 0, 1));
    EXPECT_EQ(read("<user up='1 0 0'/>").camera.up, glm::vec3(1, 0, 0));
}

TEST_F(KeyFrames, ErrorsHaveTheirLine) {
    const auto moved = [this](const std::string& keys) {
        return error("<transformation><animation>\n" + keys + "\n</animation></transformation>");
    };
    EXPECT_EQ(moved("<key/>"), ":3: <key>: has neither a time nor a frame");
    EXPECT_EQ(moved("<key time='1' frame='1'/>"), ":3: <key>: has both a time and a frame");
    EXPECT_EQ(moved("<key time='1'/>\n<key time='1'/>"),
              ":4: <key>: is not after the key before it");
    EXPECT_EQ(moved("<key frame='30'/>\n<key time='1'/>"),
              ":4: <key>: is not after the key before it");
    EXPECT_EQ(moved("<key time='-1'/>"), ":3: <key>: time='-1' is out of range");
    EXPECT_EQ(moved("<key time='nan'/>"), ":3: <key>: time='nan' is not finite in float32");
    EXPECT_EQ(moved("<key time='0' rotation='1 0 0 0'/>"),
              ":3: <key>: the rotation's axis is zero");
    EXPECT_EQ(moved("<key time='0' scale='1'/>"), ":3: <key>: scale='1' has 1 numbers, not 3");
    EXPECT_EQ(moved(""), ":2: <animation>: holds no <key>");
    EXPECT_EQ(moved("<key time='0'/></animation>\n<animation>"),
              ":4: <animation>: there may be one only in <transformation>");
    EXPECT_EQ(error("<camera><animation><key time='0' aperture='180'/></animation></camera>"),
              ":2: <key>: aperture='180' is out of range");
    EXPECT_EQ(error("<user up='0 0 0'/>"), ":2: <user>: up is zero");
}

TEST_F(KeyFrames, WhatHasNoEffectIsNamed) {
    read("<animation/><transformation><animation fps='3'><frame/><key time='0' position='1 1 1'>"
         "<x/></key></animation></transformation><light><animation/></light>");
    EXPECT_EQ(
        report_.ignored(),
        (std::vector<std::string>{"element <animation> in <world>", "attribute fps of <animation>",
                                  "element <frame> in <animation>", "attribute position of <key>",
                                  "element <x> in <key>", "element <animation> in <light>"}));
}

TEST_F(KeyFrames, ASceneIsLoadedAtItsFirstFrame) {
    folder_.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
    const LoadedScene loaded = loadScene(
        write(kObject +
                  "<transformation><animation><key time='0' translation='0 0 3' rotation='90 "
                  "0 1 0'/><key time='1' translation='0 0 9'/></animation>" +
                  kObject + "</transformation>",
              ""));
    const Mesh& mesh = loaded.scene.mesh;
    EXPECT_EQ(mesh.triangles, (std::vector<Corners>{{0, 1, 2}, {3, 4, 5}}));
    EXPECT_EQ(mesh.positions[1], glm::vec3(1, 0, 0));
    EXPECT_EQ(mesh.positions[4], glm::vec3(0, 0, 2));
    EXPECT_EQ(mesh.normals[1], glm::vec3(1, 0, 0));
    ASSERT_EQ(loaded.scene.animation.parts.size(), 1u);
    EXPECT_EQ(loaded.scene.animation.parts[0].positions[1], glm::vec3(1, 0, 0));
}

} // namespace
} // namespace dirt
