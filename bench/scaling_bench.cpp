#include "bench/scaling_bench.h"

#include "core/frame/renderer.h"

#include <cmath>

namespace dirt {

ScalingPoint benchScaling(const Scene& scene, const RenderSettings& settings, Backend& backend,
                          Backend& peer, int rounds) {
    ScalingPoint point;
    point.triangles = scene.mesh.triangles.size();
    point.width = settings.grid.width;
    point.height = settings.grid.height;
    RenderSettings one = settings;
    one.samples = 1;
    const auto time = [&](Backend& side, Timing& build, Timing& sample, bool counts) {
        const RenderResult frame = Renderer(scene, one, side).render();
        if (!counts) return;
        build.ms.push_back(totalMs(frame.build));
        sample.ms.push_back(totalMs(frame.passes) - build.ms.back());
    };
    for (int round = -1; round < rounds; ++round)
        for (int i = 0; i < 2; ++i)
            if (((i + round) & 1) == 0) // who comes first changes from round to round
                time(backend, point.build, point.sample, round >= 0);
            else
                time(peer, point.peerBuild, point.peerSample, round >= 0);
    point.bytes = totalBytes(backend.memory());
    return point;
}

double fittedExponent(const std::vector<double>& x, const std::vector<double>& y) {
    const double n = (double) x.size();
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (size_t i = 0; i < x.size(); ++i) {
        const double lx = std::log(x[i]), ly = std::log(y[i]);
        sx += lx, sy += ly, sxx += lx * lx, sxy += lx * ly;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

} // namespace dirt
