// Pictures of what OpenGL has are those of what the CPU has, to the bit.

#include "core/preview/preview.h"

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "backend_gl/gl_backend.h"
#include "core/explain/path_account.h"
#include "core/preview/present.h"
#include "core/preview/ray_picture.h"
#include "tests/support/golden_scenes.h"

#include <gtest/gtest.h>

namespace dirt {
namespace {

class GlPreview : public testing::Test {
protected:
    GlPreview()
        : loaded_(loadScene(test::goldenFolder() / "scenes" / "materials.scene")),
          settings_(test::goldenSettings(loaded_, 1)) {
        settings_.grid.width = 48;
        settings_.grid.height = 24;
        settings_.grid.tile = 4;
        settings_.primary = Primary::traced; // whose ties the device's rasterizer decides otherwise
    }
    PreviewPicture draw(Backend& backend, PreviewRequest request) {
        return drawPreview(loaded_.scene, settings_, backend, request);
    }

    LoadedScene loaded_;
    RenderSettings settings_;
    ThreadPool pool_{2};
    CpuBackend cpu_{pool_};
    GlBackend gl_;
};

TEST_F(GlPreview, IsTheSameOfEveryBuffer) {
    using Of = PreviewKind::Of;
    for (const PreviewKind& kind : previewKinds()) {
        SCOPED_TRACE(kind.name);
        const std::string name = kind.name;
        if (name == "time") continue;
        // Of shading and the shadow map numbers are equal within bounds only (dirt check); on a
        // device that computes as IEEE 754 says, as here, their 8 bits are equal, too.
        settings_.visibility =
            kind.of == Of::light ? LightVisibility::shadowMap : LightVisibility::traced;
        PreviewRequest request;
        request.kind = &kind;
        request.around = previewKind("entries");
        request.event = kind.of == Of::event || kind.of == Of::point ? 1 : 0;
        request.path = PathRequest{{20, 12}, {}};
        if (kind.of == Of::light) request.path.reset();
        const PreviewPicture cpu = draw(cpu_, request), gl = draw(gl_, request);
        EXPECT_EQ(present(cpu).rgb, present(gl).rgb);
    }
}

TEST_F(GlPreview, DrawsTheSameRays) {
    for (const size_t pixel : {500u, 600u, 700u}) {
        const PathAccount cpu = accountOf(loaded_.scene, settings_, cpu_, pixel, 1);
        const PathAccount gl = accountOf(loaded_.scene, settings_, gl_, pixel, 1);
        EXPECT_EQ(drawRays(cpu, "a pixel", {}).rgb, drawRays(gl, "a pixel", {}).rgb);
    }
}

} // namespace
} // namespace dirt
