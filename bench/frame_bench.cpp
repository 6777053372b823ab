#include "bench/frame_bench.h"

#include "backend_cpu/cpu_backend.h"
#include "backend_cpu/image/direct_visibility.h"
#include "bench/bandwidth.h"
#include "bench/ray_sets.h"

#include <algorithm>
#include <chrono>

namespace dirt {

namespace {

/// Whether a frame finds its first hits as `rasterizeHits` does.
bool rasterizesPrimary(const Scene& scene, const RenderSettings& settings, const Backend& backend) {
    return dynamic_cast<const CpuBackend*>(&backend) != nullptr &&
           !requirementsOf(scene, settings, backend.rasterizes()).tracedPrimary;
}

/// One backend on one frame's geometry and rays.
class Side {
public:
    Side(Backend& backend, const Scene& scene, const FrameGeometry& geometry,
         const RenderSettings& settings, const RaySets& rays, Executor& executor)
        : backend_(backend), scene_(scene), geometry_(geometry), settings_(settings), rays_(rays),
          executor_(executor), rasterizes_(rasterizesPrimary(scene, settings, backend)),
          hits_(std::max(rays.primary.size(), rays.diffuse.size())), occluded_(rays.shadow.size()) {
        settings_.samples = 1;
        settings_.bounces = 2;
    }

    double milliseconds(FramePart part) {
        const auto start = std::chrono::steady_clock::now();
        run(part);
        const std::chrono::duration<double, std::milli> passed =
            std::chrono::steady_clock::now() - start;
        return passed.count();
    }

private:
    void run(FramePart part) {
        switch (part) {
        case FramePart::build:
            backend_.build(geometry_, scene_.camera, settings_.grid);
            return;
        case FramePart::primary:
            if (rasterizes_)
                return rasterizeHits(
                    {scene_, geometry_, settings_, requirementsOf(scene_, settings_, true)},
                    executor_, 0, eyeBuffers_, hits_);
            return backend_.intersect(rays_.primary, {hits_.data(), rays_.primary.size()});
        case FramePart::trace:
            return backend_.intersect(rays_.diffuse, {hits_.data(), rays_.diffuse.size()});
        case FramePart::shadow:
            return backend_.occluded(rays_.shadow, rays_.shadowMaxT, occluded_);
        case FramePart::frame:
            Renderer(scene_, settings_, backend_).render();
            return;
        }
    }

    Backend& backend_;
    const Scene& scene_;
    const FrameGeometry& geometry_;
    RenderSettings settings_;
    const RaySets& rays_;
    Executor& executor_;
    const bool rasterizes_; ///< the first hits
    EyeBuffers eyeBuffers_;
    std::vector<Hit> hits_;
    std::vector<uint8_t> occluded_;
};

/// What stands between construction and tracing, without what only construction needs.
uint64_t structureBytes(const Backend& backend) {
    uint64_t total = 0;
    for (const BufferSize& buffer : backend.memory())
        if (buffer.name != "fragments") total += buffer.bytes;
    return total;
}

/// What the traversal does for these rays.
std::array<WorkReport, kFrameParts.size()> countWork(const LeafTracer& tracer, const RaySets& sets,
                                                     bool rasterized) {
    std::array<WorkReport, kFrameParts.size()> work;
    std::vector<Hit> hits(std::max(sets.primary.size(), sets.diffuse.size()));
    const auto closest = [&](FramePart part, const std::vector<Ray>& rays) {
        WorkReport& report = work[(size_t) part];
        report.rays = rays.size();
        tracer.closest(rays, {hits.data(), rays.size()}, &report.counts);
    };
    if (rasterized)
        work[(size_t) FramePart::primary].rays = sets.primary.size();
    else
        closest(FramePart::primary, sets.primary);
    closest(FramePart::trace, sets.diffuse);
    WorkReport& shadow = work[(size_t) FramePart::shadow];
    shadow.rays = sets.shadow.size();
    std::vector<uint8_t> result(sets.shadow.size());
    tracer.occluded(sets.shadow, sets.shadowMaxT, result, &shadow.counts);
    return work;
}

} // namespace

const char* framePartName(FramePart part) {
    static constexpr const char* kNames[] = {"build", "primary", "trace", "shadow", "frame"};
    return kNames[(size_t) part];
}

FrameReport benchFrame(const Scene& scene, const RenderSettings& settings, Backend& dirt,
                       Backend& embree, Backend& morton, Executor& executor, int rounds) {
    const RaySets rays = makeRaySets(scene, settings, dirt, executor);
    const FrameGeometry geometry = makeFrameGeometry(scene.mesh, scene.camera, settings.grid.mode);
    Side sides[2] = {{dirt, scene, geometry, settings, rays, executor},
                     {embree, scene, geometry, settings, rays, executor}};
    const RaySets none;
    Side mortonSide(morton, scene, geometry, settings, none, executor);
    FrameReport report;
    SideReport* const reports[2] = {&report.dirt, &report.embree};
    for (int round = -1; round < rounds; ++round)
        for (const FramePart part : kFrameParts) {
            for (int i = 0; i < 2; ++i) {
                const int s = (i + round) & 1; // who comes first changes from round to round
                const double ms = sides[s].milliseconds(part);
                if (round >= 0) reports[s]->parts[(size_t) part].ms.push_back(ms);
            }
            if (part != FramePart::build) continue;
            if (round < 0) {
                report.dirt.bytes = structureBytes(dirt);
                report.embree.bytes = structureBytes(embree);
            }
            const double ms = mortonSide.milliseconds(part);
            if (round >= 0) report.mortonBuild.ms.push_back(ms);
        }
    report.listEntries = dirt.listEntries();
    if (auto* cpu = dynamic_cast<CpuBackend*>(&dirt))
        report.work = countWork(cpu->tracer(), rays, rasterizesPrimary(scene, settings, dirt));
    // The triangle buffer is part of the structure's bytes: read here, not written.
    report.floorBytes = report.dirt.bytes;
    report.bytesPerMs = measureBandwidth(executor);
    return report;
}

} // namespace dirt
