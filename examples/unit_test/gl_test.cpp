// The structure that OpenGL builds, against the definition: the same, lists as sets.

#include <dirt/backend_gl/gl_backend.h>
#include <dirt/core/base/error.h>

#include <gtest/gtest.h>

using namespace dirt;

TEST(GlTest, ListsWhatTheDefinitionLists) {
    FrameGeometry geometry;
    geometry.triangles = {{{-1.5f, -1.5f, -1}, {1.5f, -1.5f, -1}, {0, 1.5f, -1}}};
    GridSettings settings;
    settings.viewSize = 64;
    settings.bins = 4;
    const Camera camera;
    try {
        GlBackend backend;
        backend.build(geometry, camera, settings);
        EXPECT_EQ(backend.listEntries(), buildGrid(geometry, camera, settings).ids.size());
        EXPECT_GT(backend.listEntries(), 0u);
    } catch (const CapabilityError& error) {
        GTEST_SKIP() << error.what();
    }
}
