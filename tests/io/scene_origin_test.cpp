// Scenes far from 0: models, cameras, lights and key frames keep their digits.

#include "core/frame/move_scene.h"
#include "core/io/load.h"
#include "tests/io/gltf_writer.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

#include <glm/geometric.hpp>

namespace dirt {
namespace {

using test::GltfWriter;
using test::Json;

/// A cube of edge 1 whose least corner is \p low, and a polygon that is concave.
std::string cubeAt(const glm::dvec3& low) {
    std::string text;
    char line[96];
    for (int i = 0; i < 8; ++i) {
        std::snprintf(line, sizeof line, "v %.3f %.3f %.3f\n", low.x + (i & 1),
                      low.y + (i >> 1 & 1), low.z + (i >> 2));
        text += line;
    }
    std::snprintf(line, sizeof line, "v %.3f %.3f %.3f\n", low.x + 0.25, low.y + 0.25, low.z);
    return text + line + "f 1 3 7 5\nf 2 6 8 4\nf 1 5 6 2\nf 3 4 8 7\nf 1 2 9 3\nf 5 7 8 6\n";
}

const glm::dvec3 kUtm(500000.1, 5400000.3, 312.4);
/// A translation that every coordinate takes exactly, by a multiple of any lattice's step below.
const glm::dvec3 kFar(524288.0, -4194304.0, 65536.0);

class SceneOrigin : public testing::Test {
protected:
    Scene load(const std::string& name, const std::string& content) {
        return loadScene(folder_.write(name, content)).scene;
    }
    test::TemporaryFolder folder_;
};

TEST_F(SceneOrigin, KeepsTheDigitsOfAFarModel) {
    const Scene scene = load("house.obj", cubeAt(kUtm));
    EXPECT_EQ(scene.origin, glm::dvec3(500000, 5400000, 312));
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 right = kUtm + glm::dvec3(i & 1, i >> 1 & 1, i >> 2);
        // Some corner of the mesh is there, within half an ulp of coordinates below 2.
        double nearest = 1.0;
        for (const glm::vec3& p : scene.mesh.positions)
            nearest = std::min(nearest, glm::length(scene.inFiles(p) - right));
        EXPECT_LE(nearest, std::sqrt(3.0) * 0x1p-24) << i;
    }
    const Scene near = load("near.obj", cubeAt(kUtm - scene.origin));
    EXPECT_EQ(near.origin, glm::dvec3(0.0));
    EXPECT_EQ(near.mesh.triangles, scene.mesh.triangles) << "the concave face is cut alike";
    ASSERT_EQ(near.mesh.positions.size(), scene.mesh.positions.size());
    for (size_t i = 0; i < near.mesh.positions.size(); ++i)
        EXPECT_LE(glm::length(near.mesh.positions[i] - scene.mesh.positions[i]), 0x1p-22f);
}

TEST_F(SceneOrigin, AScenesCoordinatesAreThoseOfItsFiles) {
    const auto sceneAt = [&](const std::string& name, const glm::dvec3& t) {
        folder_.write(name + ".obj", cubeAt(glm::dvec3(0.25, -0.5, 0.125) + t));
        const auto point = [&](double x, double y, double z) {
            char text[96];
            std::snprintf(text, sizeof text, "%.6f %.6f %.6f", x + t.x, y + t.y, z + t.z);
            return std::string(text);
        };
        return load(name + ".scene", "<world><object file='" + name + ".obj'/><user position='" +
                                         point(3, 2, 5) + "' lookat='" + point(0.5, 0, 0.75) +
                                         "'/><light position='" + point(1, 4, 1) + "' target='" +
                                         point(0, 0, 0.5) + "'/></world>");
    };
    const Scene near = sceneAt("near", {0, 0, 0}), far = sceneAt("far", kFar);
    EXPECT_EQ(near.origin, glm::dvec3(0.0));
    EXPECT_EQ(far.origin, kFar);
    EXPECT_EQ(far.mesh.positions, near.mesh.positions);
    EXPECT_EQ(far.mesh.triangles, near.mesh.triangles);
    EXPECT_EQ(far.camera.eye, near.camera.eye);
    EXPECT_EQ(far.camera.target, near.camera.target);
    EXPECT_EQ(far.lights[0].position, near.lights[0].position);
    EXPECT_EQ(far.lights[0].target, near.lights[0].target);
}

TEST_F(SceneOrigin, WhatMovesFarAwayMovesAsItWouldAtZero) {
    // Once the transformations carry a near model away, once the model itself is far away, in the
    // world and, where a moving space turns it about its middle, in that space.
    const auto sceneAt = [&](const std::string& name, const glm::dvec3& model,
                             const glm::dvec3& moved, const glm::dvec3& eye) {
        folder_.write(name + ".obj", cubeAt(glm::dvec3(-0.5) + model));
        const auto text = [](const glm::dvec3& p) {
            char line[96];
            std::snprintf(line, sizeof line, "%.6f %.6f %.6f", p.x, p.y, p.z);
            return std::string(line);
        };
        return load(name + ".scene",
                    "<world><user lookat='" + text(eye) + "'><animation><key time='0' position='" +
                        text(eye + glm::dvec3(4, 0, 0)) + "'/><key time='1' position='" +
                        text(eye + glm::dvec3(0, 0, 4)) +
                        "'/></animation></user><transformation translation='" + text(moved) +
                        "'><transformation><animation><key time='0' rotation='0 0 0 1' "
                        "translation='0 0 0'/>"
                        "<key time='1' rotation='90 0 0 1' translation='0 0 2'/></animation>"
                        "<transformation translation='" +
                        text(-model) + "'><object file='" + name +
                        ".obj'/></transformation></transformation></transformation></world>");
    };
    SerialExecutor serial;
    Scene near = sceneAt("near", {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
    Scene far = sceneAt("far", {0, 0, 0}, kFar, kFar);
    Scene both = sceneAt("both", kUtm, kFar, kFar);
    EXPECT_EQ(near.origin, glm::dvec3(0.0));
    EXPECT_EQ(far.origin, kFar);
    EXPECT_EQ(both.origin, kFar);
    for (const int frame : {0, 7, 25}) {
        for (Scene* scene : {&near, &far, &both}) moveScene(*scene, frame, serial);
        EXPECT_EQ(far.mesh.positions, near.mesh.positions) << frame;
        EXPECT_EQ(far.camera.eye, near.camera.eye) << frame;
        EXPECT_EQ(far.camera.target, near.camera.target) << frame;
        for (size_t i = 0; i < near.mesh.positions.size(); ++i)
            EXPECT_LE(glm::length(both.mesh.positions[i] - near.mesh.positions[i]), 0x1p-21f)
                << frame;
    }
}

/// A model that turns in a space in which it is far from 0 keeps its shape.
TEST_F(SceneOrigin, AMovingSpaceHasAnOriginOfItsOwn) {
    folder_.write("a.obj", cubeAt(kUtm));
    Scene scene =
        load("a.scene", "<world><transformation translation='-500000 -5400000 -312'>"
                        "<transformation><animation><key time='0' translation='0 0 0'/><key "
                        "time='1' translation='0 0 1'/></animation><object file='a.obj'/>"
                        "</transformation></transformation></world>");
    EXPECT_EQ(scene.origin, glm::dvec3(0.0));
    EXPECT_EQ(scene.animation.parts.at(0).origin, glm::dvec3(500000, 5400000, 312));
    SerialExecutor serial;
    for (const int frame : {0, 25}) {
        moveScene(scene, frame, serial);
        for (const Corners& t : scene.mesh.triangles)
            for (int k = 0; k < 3; ++k) {
                const glm::vec3 edge = scene.mesh.positions[t[(size_t) k]] -
                                       scene.mesh.positions[t[((size_t) k + 1) % 3]];
                const float longest =
                    std::max({std::abs(edge.x), std::abs(edge.y), std::abs(edge.z)});
                const float quarters = std::round(4.0f * longest) / 4.0f; // as in the file
                EXPECT_NEAR(longest, quarters, 1e-6f);
                EXPECT_GT(quarters, 0.0f);
            }
    }
}

TEST_F(SceneOrigin, GltfNodesMayBeFarAway) {
    const auto at = [&](const glm::dvec3& t) {
        GltfWriter writer;
        writer.triangle();
        writer.json["nodes"][0]["translation"] = {t.x, t.y, t.z};
        return load("a.gltf", writer.embedded());
    };
    const Scene near = at({0, 0, 0}), far = at({524288.25, 0, -4194304.5});
    EXPECT_EQ(near.origin, glm::dvec3(0.0));
    EXPECT_NE(far.origin, glm::dvec3(0.0));
    for (size_t i = 0; i < near.mesh.positions.size(); ++i)
        EXPECT_EQ(far.inFiles(far.mesh.positions[i]),
                  near.inFiles(near.mesh.positions[i]) + glm::dvec3(524288.25, 0, -4194304.5));
}

/// Near and far parts together are a scene as large as their distance: what float32 loses there is
/// said.
TEST_F(SceneOrigin, FarAndNearPartsTogetherAreSaid) {
    const LoadedScene loaded =
        loadScene(folder_.write("a.obj", cubeAt(kUtm) + "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 10 11 12\n"));
    EXPECT_EQ(loaded.scene.origin, glm::dvec3(0.0));
    ASSERT_EQ(loaded.warnings.size(), 1u);
    EXPECT_EQ(loaded.warnings[0].kind, WarningKind::precision);
    EXPECT_NE(loaded.warnings[0].text.find(" of 13 triangles are too small for float32"),
              std::string::npos)
        << loaded.warnings[0].text;
}

} // namespace
} // namespace dirt
