#pragma once

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/thread_pool.h"
#include "core/preview/preview.h"
#include "tests/support/golden_scenes.h"

#include <string>

#include <gtest/gtest.h>

namespace dirt::test {

/// A small frame of a scene with maps, on the CPU.
class PreviewFixture : public testing::Test {
protected:
    PreviewFixture()
        : loaded_(loadScene(goldenFolder() / "scenes" / "maps.scene")),
          settings_(goldenSettings(loaded_, 2)) {
        settings_.grid.width = 48;
        settings_.grid.height = 24;
        settings_.grid.tile = 4;
    }

    PreviewPicture draw(Backend& backend, const std::string& name, PreviewRequest request = {}) {
        request.kind = previewKind(name);
        request.around = previewKind("entries"); // of the overview
        return drawPreview(loaded_.scene, settings_, backend, request);
    }

    LoadedScene loaded_;
    RenderSettings settings_;
    ThreadPool pool_{2};
    CpuBackend cpu_{pool_};
};

} // namespace dirt::test
