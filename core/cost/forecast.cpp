#include "core/cost/forecast.h"

#include "core/frame/forwarding_backend.h"
#include "core/frame/renderer.h"

#include <algorithm>
#include <chrono>
#include <numeric>

namespace dirt {

namespace {

/// Pixels a side of the blocks that go on together.
constexpr int kBlock = 8;

/// Which blocks go on.
enum class Part { sixteenth, half };

/// Lets the paths of a part of all blocks go on after direct light.
class ThinnedBackend final : public ForwardingBackend {
public:
    ThinnedBackend(Backend& inner, const GridSettings& grid, Part part)
        : ForwardingBackend(inner), grid_(grid), part_(part) {}

    void depthMask(int event) override {
        inner_.depthMask(event);
        if (event != 1) return;
        const auto start = std::chrono::steady_clock::now();
        PathBuffers paths = inner_.readPaths();
        for (size_t i = 0; i < paths.mask.size(); ++i)
            if (!goesOn((int) (i % (size_t) grid_.width), (int) (i / (size_t) grid_.width)))
                paths.mask[i] = 0;
        inner_.writePaths(paths);
        const std::chrono::duration<double, std::milli> spent =
            std::chrono::steady_clock::now() - start;
        thinningMs_ += spent.count();
    }

    /// Part of the pixels that go on.
    double part() const {
        size_t count = 0;
        for (int y = 0; y < grid_.height; ++y)
            for (int x = 0; x < grid_.width; ++x) count += goesOn(x, y);
        return (double) count / ((double) grid_.width * grid_.height);
    }

    /// Time that the thinning itself took.
    double thinningMs() const { return thinningMs_; }

private:
    bool goesOn(int x, int y) const {
        const int column = x / kBlock, row = y / kBlock;
        return part_ == Part::half ? (column + row) % 2 == 0 : column % 4 == 0 && row % 4 == 0;
    }

    const GridSettings& grid_;
    Part part_;
    double thinningMs_ = 0.0;
};

/// One sample of which a part of the paths goes on.
struct Trial {
    double part = 0.0, buildMs = 0.0, sampleMs = 0.0;
    FrameCounts counts;
};

Trial run(const Scene& scene, const RenderSettings& settings, Backend& backend, Part part) {
    RenderSettings one = settings;
    one.samples = 1;
    ThinnedBackend thinned(backend, one.grid, part);
    const RenderResult frame = Renderer(scene, one, thinned).render();
    Trial trial;
    trial.part = thinned.part();
    for (const PassTime& pass : frame.build) trial.buildMs += pass.ms;
    for (const PassTime& pass : frame.passes) trial.sampleMs += pass.ms;
    trial.sampleMs -= trial.buildMs + thinned.thinningMs();
    trial.counts = frame.counts;
    return trial;
}

} // namespace

Forecast forecastFrame(const Scene& scene, const RenderSettings& settings, Backend& backend) {
    const Trial few = run(scene, settings, backend, Part::sixteenth);
    const Trial some = run(scene, settings, backend, Part::half);
    // At part 1 of the line through the two, which are the same without indirect paths, and in
    // images of less than two blocks.
    const auto all = [&](double fewer, double more) {
        if (settings.bounces < 2 || some.part <= few.part) return more;
        return std::max(more, more + (more - fewer) * (1.0 - some.part) / (some.part - few.part));
    };
    Forecast forecast;
    forecast.buildMs = few.buildMs;
    forecast.sampleMs = all(few.sampleMs, some.sampleMs);
    forecast.frameMs = forecast.buildMs + settings.samples * forecast.sampleMs;
    forecast.rays = settings.samples * all((double) few.counts.rays, (double) some.counts.rays);
    forecast.shadowRays =
        settings.samples * all((double) few.counts.shadowRays, (double) some.counts.shadowRays);
    for (const BufferSize& buffer : backend.memory()) forecast.memory += buffer.second;
    return forecast;
}

} // namespace dirt
