#include "bench/tradeoff_bench.h"

#include "core/compare/differences.h"
#include "core/compare/flip.h"
#include "core/frame/renderer.h"

#include <algorithm>
#include <numeric>

namespace dirt {

namespace {

double sumOf(const std::vector<PassTime>& passes) {
    return std::accumulate(passes.begin(), passes.end(), 0.0,
                           [](double sum, const PassTime& pass) { return sum + pass.ms; });
}

uint64_t totalBytes(const Backend& backend) {
    uint64_t total = 0;
    for (const BufferSize& buffer : backend.memory()) total += buffer.second;
    return total;
}

class Run {
public:
    Run(const Scene& scene, Backend& backend, Backend& peer, Executor& executor,
        const TradeoffOptions& options)
        : scene_(scene), backend_(backend), peer_(peer), executor_(executor), options_(options) {}

    TradeoffReport operator()(const RenderSettings& around) {
        report_.sweeps = makeSweeps(around);
        report_.settings.resize(report_.sweeps.settings.size());
        report_.images.resize(report_.sweeps.settings.size());
        time();
        takeErrors();
        return std::move(report_);
    }

private:
    void say(const std::string& line) const {
        if (options_.progress) options_.progress(line);
    }

    void time() {
        std::vector<Image> images;
        for (int round = -1; round < options_.rounds; ++round) {
            say("round " + std::to_string(round + 1) + " of " + std::to_string(options_.rounds));
            for (size_t i = 0; i < report_.settings.size(); ++i) {
                RenderSettings one = report_.sweeps.settings[i];
                one.samples = 1;
                const RenderResult frame = Renderer(scene_, one, backend_).render();
                SettingsReport& to = report_.settings[i];
                if (round < 0) {
                    to.listEntries = backend_.listEntries();
                    to.bytes = totalBytes(backend_);
                    images.push_back(frame.image);
                    to.image = sameImage(images, i);
                } else {
                    const double build = sumOf(frame.build);
                    to.build.ms.push_back(build);
                    to.sample.ms.push_back(sumOf(frame.passes) - build);
                }
            }
        }
    }

    static size_t sameImage(const std::vector<Image>& images, size_t i) {
        for (size_t k = 0; k < i; ++k)
            if (images[k].pixels == images[i].pixels) return k;
        return i;
    }

    Image converge(RenderSettings settings, int bounces) {
        say("reference, " + std::to_string(bounces) + " bounces");
        settings.grid.mode = ViewMode::full;
        settings.samples = options_.referenceSamples;
        settings.bounces = bounces;
        ++settings.seed; // other samples than those whose error it shows
        return Renderer(scene_, settings, peer_).render().image;
    }

    void takeErrors() {
        const std::vector<RenderSettings>& all = report_.sweeps.settings;
        int most = 0;
        for (const RenderSettings& settings : all) most = std::max(most, settings.bounces);
        report_.reference = converge(all.front(), all.front().bounces);
        const Image longest = converge(all.front(), most);
        for (size_t i = 0; i < all.size(); ++i) {
            if (report_.settings[i].image != i) continue;
            const bool other = all[i].bounces != all.front().bounces;
            takeErrors(i, other ? longest : report_.reference);
        }
    }

    /// Of settings \p i at 1, 2, 4, … samples.
    void takeErrors(size_t i, const Image& reference) {
        say("errors of settings " + std::to_string(i));
        RenderSettings settings = report_.sweeps.settings[i];
        settings.samples = options_.samples;
        RenderHooks hooks;
        hooks.progress = [&](int done, int total) {
            if ((done & (done - 1)) != 0 && done != total) return;
            Image image{settings.grid.width, settings.grid.height, backend_.readImage()};
            for (glm::vec3& pixel : image.pixels) pixel *= 1.0f / (float) done;
            const Plane seen = hdrFlip(image, reference, executor_);
            report_.settings[i].errors.push_back(
                {done, differencesOf(image, reference).relativeMse,
                 std::accumulate(seen.values.begin(), seen.values.end(), 0.0) /
                     (double) seen.values.size()});
        };
        report_.images[i] = Renderer(scene_, settings, backend_).render(hooks).image;
    }

    const Scene& scene_;
    Backend& backend_;
    Backend& peer_;
    Executor& executor_;
    const TradeoffOptions& options_;
    TradeoffReport report_;
};

} // namespace

TradeoffReport benchTradeoff(const Scene& scene, const RenderSettings& around, Backend& backend,
                             Backend& reference, Executor& executor,
                             const TradeoffOptions& options) {
    return Run(scene, backend, reference, executor, options)(around);
}

} // namespace dirt
