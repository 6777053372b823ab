#pragma once

#include "core/io/image.h"
#include "tests/support/golden_scenes.h"
#include "tests/support/temporary_folder.h"

#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

#include <gtest/gtest.h>

namespace dirt::test {

/// Expects a picture to be the same as images/\p name.png, which somebody has looked at.
/// DIRT_PROMOTE=1 makes it the expected one first.
inline void expectGolden(const std::string& name, int width, int height,
                         std::span<const uint8_t> rgb) {
    const std::string expected = goldenFolder() / "images" / (name + ".png");
    if (std::getenv("DIRT_PROMOTE")) writePng(expected, width, height, rgb, {});
    const TemporaryFolder folder;
    writePng(folder / "now.png", width, height, rgb, {});
    const Image before = readImage(expected), now = readImage(folder / "now.png");
    ASSERT_EQ(before.pixels.size(), now.pixels.size());
    size_t different = 0;
    for (size_t i = 0; i < now.pixels.size(); ++i) different += now.pixels[i] != before.pixels[i];
    EXPECT_EQ(different, 0u) << "pixels; DIRT_PROMOTE=1 writes what it is now to " << expected
                             << ", to look at it and to keep it";
}

} // namespace dirt::test
