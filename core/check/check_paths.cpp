#include "core/check/check_paths.h"

#include "core/check/adjudicate_visibility.h"
#include "core/check/compare_paths.h"
#include "core/check/compare_structure.h"
#include "core/frame/forwarding_backend.h"
#include "core/frame/renderer.h"
#include "core/path/sub_pixel.h"

#include <algorithm>
#include <array>
#include <initializer_list>

namespace dirt {
namespace {

constexpr std::array kBuffers = {PathBuffer::previous,   PathBuffer::current,  PathBuffer::next,
                                 PathBuffer::mask,       PathBuffer::rays,     PathBuffer::hits,
                                 PathBuffer::visibility, PathBuffer::radiance, PathBuffer::image};

/// What a frame's first sample finds in its place, so that Clear has something to clear, and
/// Resolve something to add to.
const glm::vec3 kLeftover(0.5f);

/// The backend on which a Renderer renders: passes each pass on to one backend, lets another do the
/// same from the same buffers, and compares.
class Lockstep final : public ForwardingBackend {
public:
    Lockstep(const Camera& camera, const RenderSettings& settings, const BuiltStructure& built,
             Backend& source, Backend& tested)
        : ForwardingBackend(source), tested_(tested), built_(built), camera_(camera),
          judge_(built.geometry, camera, settings.grid, subPixelOffset(0, settings.seed)),
          comparison_(built.geometry, settings.grid.width,
                      {source.isIeee() && tested.isIeee(), source.hasGrid() && tested.hasGrid(),
                       [this](size_t pixel, uint32_t a, uint32_t b) {
                           return judge_.mayConfuse(pixel, a, b);
                       }}) {
        untouched_.pass = "every pass";
        untouched_.buffer = "what it must not write";
        untouched_.tested = tested.name();
        untouched_.source = source.name();
    }

    /// The rows; to be called once, at the end.
    std::vector<CheckRow> takeRows() {
        rows_.push_back(untouched_);
        return std::move(rows_);
    }
    const std::vector<uint32_t>& surfaces() const { return surfaces_; }
    const std::vector<glm::vec3>& radiance() const { return state_.radiance; }

    bool rasterizes() const override { return inner_.rasterizes() && tested_.rasterizes(); }

    // The structure is there already.
    void clear(const Camera&, const GridSettings& settings) override { grid_ = settings; }
    void transform(const Mesh&, const Camera&, ViewMode) override {}
    void fillDepth() override {}
    void fillDepthMipmap() override {}
    void fillPrimitives() override {
        hand(built_, camera_, grid_, inner_);
        hand(built_, camera_, grid_, tested_);
    }

    void beginFrame(const Scene& scene, const RenderSettings& settings,
                    const Requirements& requirements) override {
        inner_.beginFrame(scene, settings, requirements);
        tested_.beginFrame(scene, settings, requirements);
        resolution_ = requirements.shadowMap;
        state_ = inner_.readPaths();
        std::fill(state_.radiance.begin(), state_.radiance.end(), kLeftover);
        std::fill(state_.image.begin(), state_.image.end(), kLeftover);
        inner_.writePaths(state_);
    }

    void shadowMap() override {
        inner_.shadowMap();
        tested_.shadowMap();
        const std::vector<float> expected = inner_.readShadowMap();
        CheckRow row;
        row.pass = "ShadowMap";
        row.buffer = "shadow map";
        row.tested = tested_.name();
        row.source = inner_.name();
        compareShadowMaps(expected, tested_.readShadowMap(), resolution_,
                          inner_.isIeee() && tested_.isIeee(), row);
        rows_.push_back(std::move(row));
        tested_.writeShadowMap(expected);
    }

    void beginSample() override {
        run("Clear", 0, {PathBuffer::radiance}, [](Backend& b) { b.beginSample(); });
    }
    void directVisibility(uint32_t sample) override {
        run("DirectVisibility", 0, {PathBuffer::next},
            [=](Backend& b) { b.directVisibility(sample); });
    }
    void depthMask(int k) override {
        run("DepthMask", k, {PathBuffer::mask}, [=](Backend& b) { b.depthMask(k); });
    }
    void rays(uint32_t sample, int k) override {
        run("Rays", k, {PathBuffer::rays}, [=](Backend& b) { b.rays(sample, k); });
    }
    void trace(int k) override {
        run("Trace", k, {PathBuffer::hits}, [=](Backend& b) { b.trace(k); });
    }
    void fetch(int k) override {
        run("Fetch", k, {PathBuffer::next, PathBuffer::hits}, [=](Backend& b) { b.fetch(k); });
    }
    void visibility(int k) override {
        run("Visibility", k, {PathBuffer::visibility}, [=](Backend& b) { b.visibility(k); });
    }
    void shade(int k) override {
        if (k == 0)
            for (const SurfacePoint& point : state_.next) surfaces_.push_back(point.primitive);
        run("Shade", k, {PathBuffer::radiance}, [=](Backend& b) { b.shade(k); });
        event_ = k;
    }
    void shift() override {
        // What becomes of G[k+1] is not said: the next event writes all of it.
        run("Shift", event_, {PathBuffer::previous, PathBuffer::current}, {PathBuffer::next},
            [](Backend& b) { b.shift(); });
    }
    void resolve() override {
        run("Resolve", 0, {PathBuffer::image}, [](Backend& b) { b.resolve(); });
    }

private:
    using Buffers = std::initializer_list<PathBuffer>;

    template <typename Pass>
    void run(const char* name, int event, Buffers written, const Pass& pass) {
        run(name, event, written, {}, pass);
    }

    /// \p pass writes \p written, and may leave anything in \p spoilt.
    template <typename Pass>
    void run(const char* name, int event, Buffers written, Buffers spoilt, const Pass& pass) {
        pass(inner_);
        PathBuffers expected = inner_.readPaths();
        tested_.writePaths(state_);
        pass(tested_);
        const PathBuffers found = tested_.readPaths();
        for (const PathBuffer buffer : kBuffers) {
            const auto among = [buffer](Buffers buffers) {
                return std::find(buffers.begin(), buffers.end(), buffer) != buffers.end();
            };
            if (among(written))
                compare(name, event, buffer, expected, found);
            else if (!among(spoilt))
                comparison_.compare(buffer, state_, found, untouched_);
        }
        state_ = std::move(expected);
    }

    void compare(const std::string& pass, int event, PathBuffer buffer, const PathBuffers& expected,
                 const PathBuffers& found) {
        CheckRow& row = rows_.emplace_back();
        row.pass = pass;
        row.event = event;
        row.buffer = nameOf(buffer);
        row.tested = tested_.name();
        row.source = inner_.name();
        if (pass == "DirectVisibility")
            comparison_.compareDirectVisibility(expected, found, row);
        else
            comparison_.compare(buffer, expected, found, row);
        // A scene may need none of it.
        if (row.compared == 0) rows_.pop_back();
    }

    Backend& tested_;
    const BuiltStructure& built_;
    const Camera& camera_;
    GridSettings grid_;
    VisibilityJudge judge_;
    PathComparison comparison_;
    PathBuffers state_; ///< of the source, before the next pass
    std::vector<uint32_t> surfaces_;
    std::vector<CheckRow> rows_;
    CheckRow untouched_;
    size_t resolution_ = 0; ///< of the shadow map
    int event_ = 0;
};

} // namespace

SampleCheck checkPaths(const Scene& scene, const RenderSettings& given, const BuiltStructure& built,
                       Backend& source, Backend& tested) {
    RenderSettings settings = given;
    settings.samples = 1;
    // Only tiles list hits.
    if (!source.hasGrid() || !tested.hasGrid()) settings.fetch = Fetch::direct;
    Lockstep lockstep(scene.camera, settings, built, source, tested);
    Renderer renderer(scene, settings, lockstep);
    renderer.keepPreviousPoint();
    renderer.render();
    return {lockstep.takeRows(), lockstep.surfaces(), lockstep.radiance()};
}

} // namespace dirt
