// Shadow rays as they are dumped: the definition's rays, the backend's own answers, and the blocker
// that a test of every triangle finds.

#include "core/dump/shadow_rays.h"

#include "backend_cpu/cpu_backend.h"
#include "core/frame/forwarding_backend.h"
#include "core/frame/renderer.h"
#include "core/trace/traverse.h"
#include "tests/frame/shapes.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace dirt {
namespace {

/// Says the opposite of what Visibility has found.
class ContraryBackend final : public ForwardingBackend {
public:
    using ForwardingBackend::ForwardingBackend;
    void visibility(int event) override {
        inner_.visibility(event);
        PathBuffers paths = inner_.readPaths();
        for (uint8_t& visible : paths.visibility) visible = visible ? 0 : 1;
        inner_.writePaths(paths);
    }
};

class ShadowRays : public testing::TestWithParam<ViewMode> {
protected:
    SerialExecutor serial_;
    CpuBackend cpu_{serial_};
    Scene scene_ = test::room();
    RenderSettings settings_;

    void SetUp() override {
        // Beyond the light, which it does not block.
        test::addQuad(scene_.mesh, {-9, 3.5f, -9}, {18, 0, 0}, {0, 0, 18}, 0);
        settings_.grid.mode = GetParam();
        settings_.grid.width = 45;
        settings_.grid.height = 31;
        settings_.grid.tile = 4;
        settings_.grid.bins = 5;
        settings_.samples = 1;
    }

    /// Calls \p look(frame, event, paths, records) in each path event.
    template <typename Look>
    void observe(Backend& backend, const Look& look) {
        const Requirements need = requirementsOf(scene_, settings_, backend.rasterizes());
        RenderHooks hooks;
        hooks.observe = [&](uint32_t, int event) {
            const FrameGeometry geometry = backend.readGeometry();
            const FrameContext frame(scene_, geometry, settings_, need);
            const PathBuffers paths = backend.readPaths();
            look(frame, event, paths, shadowRecordsOf(frame, backend, event, paths));
        };
        Renderer(scene_, settings_, backend).render(hooks);
    }
};

bool lists(const Grid& grid, const ShadowRecord& record) {
    if (record.view == grid.views.size())
        return std::find(grid.atEye.begin(), grid.atEye.end(), record.blocker) != grid.atEye.end();
    const View& view = grid.views[record.view];
    if (record.column >= (uint32_t) view.columns || record.row >= (uint32_t) view.rows)
        return false;
    for (int bin = 0; bin < grid.settings.bins; ++bin) {
        const auto list = grid.list((int) record.view,
                                    (int) record.row * view.columns + (int) record.column, bin);
        if (std::find(list.begin(), list.end(), record.blocker) != list.end()) return true;
    }
    return false;
}

TEST_P(ShadowRays, AreThoseOfTheDefinitionWithTheirNearestBlocker) {
    size_t open = 0, blocked = 0, none = 0;
    observe(cpu_, [&](const FrameContext& frame, int event, const PathBuffers& paths,
                      const std::vector<ShadowRecord>& records) {
        ASSERT_EQ(records.size(), paths.pixels());
        for (size_t pixel = 0; pixel < records.size(); ++pixel) {
            const ShadowRecord& record = records[pixel];
            const auto due = shadowRay(frame, event, paths, pixel);
            if (!due) {
                EXPECT_EQ(record.direction, glm::vec3(0.0f));
                EXPECT_EQ(record.occluded, 0u);
                EXPECT_EQ(record.blocker, kNoPrimitive);
                ++none;
                continue;
            }
            EXPECT_EQ(record.origin, due->ray.origin);
            EXPECT_EQ(record.direction, due->ray.direction);
            EXPECT_EQ(record.skip, due->ray.skip);
            EXPECT_EQ(record.tMax, due->maxT);
            EXPECT_EQ(record.occluded, paths.visibility[pixel] ? 0u : 1u);
            const Hit nearest = closestHitBruteForce(frame.geometry, due->ray);
            const bool between = nearest.found() && nearest.t < due->maxT;
            EXPECT_EQ(record.occluded == 1, between) << "pixel " << pixel;
            EXPECT_EQ(record.blocker, between ? nearest.primitive : kNoPrimitive);
            EXPECT_EQ(record.t, between ? nearest.t : 0.0f);
            if (between) {
                EXPECT_TRUE(lists(cpu_.grid(), record)) << "pixel " << pixel;
            }
            ++(between ? blocked : open);
        }
    });
    EXPECT_GT(open, 100u);
    EXPECT_GT(blocked, 100u);
    EXPECT_GT(none, 10u);
}

TEST_P(ShadowRays, HaveTheAnswersOfTheBackendItself) {
    ContraryBackend contrary(cpu_);
    size_t rays = 0;
    observe(contrary, [&](const FrameContext&, int, const PathBuffers&,
                          const std::vector<ShadowRecord>& records) {
        for (const ShadowRecord& record : records) {
            if (record.direction == glm::vec3(0.0f)) continue;
            EXPECT_EQ(record.occluded == 0, record.blocker != kNoPrimitive);
            ++rays;
        }
    });
    EXPECT_GT(rays, 200u);
}

TEST_P(ShadowRays, AreNoneWhereTheFrameCastsNone) {
    settings_.visibility = LightVisibility::shadowMap;
    observe(cpu_, [&](const FrameContext&, int, const PathBuffers&,
                      const std::vector<ShadowRecord>& records) { EXPECT_TRUE(records.empty()); });
}

INSTANTIATE_TEST_SUITE_P(Modes, ShadowRays, testing::Values(ViewMode::full, ViewMode::single),
                         [](const auto& info) {
                             return info.param == ViewMode::full ? "Full" : "Single";
                         });

} // namespace
} // namespace dirt
