// The structure that OpenGL builds, against the definition.

#include <dirt/backend_gl/gl_backend.h>
#include <dirt/core/base/error.h>
#include <dirt/core/probe/grid_probe.h>

#include <gtest/gtest.h>

using namespace dirt;

//! gl
TEST(GlTest, ListsWhatTheDefinitionLists) {
    GridSettings settings;
    settings.viewSize = 64;
    settings.bins = 4;
    const GridProbe expected({{{-1.5f, -1.5f, -1}, {1.5f, -1.5f, -1}, {0, 1.5f, -1}}}, Camera{},
                             settings);
    try {
        GlBackend backend;
        backend.build(expected.geometry(), Camera{}, settings);
        const GridProbe built(expected.geometry(), backend.readGrid());
        EXPECT_EQ(built.describe(), expected.describe());
        EXPECT_EQ(built.cellsOf(0), expected.cellsOf(0));
        EXPECT_FALSE(built.cellsOf(0).empty());
    } catch (const CapabilityError& error) {
        GTEST_SKIP() << error.what(); // no OpenGL 4.5 here
    }
}
//! end
