#pragma once

#include "core/io/load.h"
#include "tests/io/same_bits.h"

#include <gtest/gtest.h>

namespace dirt::test {

/// Expects two loads to have given the same, as far as files with images of colours can differ.
inline void expectSameScene(const LoadedScene& one, const LoadedScene& many) {
    const Mesh &m = one.scene.mesh, &n = many.scene.mesh;
    ASSERT_TRUE(sameBits(m.positions, n.positions) && sameBits(m.triangles, n.triangles) &&
                sameBits(m.materials, n.materials) && sameBits(m.texcoords, n.texcoords) &&
                sameBits(m.texcoordIndices, n.texcoordIndices) && sameBits(m.colors, n.colors));
    ASSERT_EQ(one.scene.materials.size(), many.scene.materials.size());
    for (size_t i = 0; i < one.scene.materials.size(); ++i) {
        const Material &a = one.scene.materials[i], &b = many.scene.materials[i];
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.diffuse, b.diffuse);
        EXPECT_EQ(a.diffuseMap, b.diffuseMap);
        EXPECT_EQ(a.reflectanceMap, b.reflectanceMap);
    }
    ASSERT_EQ(one.scene.textures.size(), many.scene.textures.size());
    for (size_t i = 0; i < one.scene.textures.size(); ++i) {
        EXPECT_EQ(one.scene.textures[i].file(), many.scene.textures[i].file());
        EXPECT_EQ(one.scene.textures[i].sample({0, 0}), many.scene.textures[i].sample({0, 0}));
    }
    EXPECT_EQ(one.scene.origin, many.scene.origin);
    EXPECT_EQ(one.scene.camera.eye, many.scene.camera.eye);
    EXPECT_EQ(one.scene.animation.parts.size(), many.scene.animation.parts.size());
    ASSERT_EQ(one.warnings.size(), many.warnings.size());
    for (size_t i = 0; i < one.warnings.size(); ++i)
        EXPECT_EQ(one.warnings[i].text, many.warnings[i].text);
    EXPECT_EQ(one.ignored, many.ignored);
}

} // namespace dirt::test
