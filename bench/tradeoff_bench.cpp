#include "bench/tradeoff_bench.h"

#include "core/compare/differences.h"
#include "core/compare/flip.h"
#include "core/frame/renderer.h"

#include <algorithm>
#include <numeric>

namespace dirt {

namespace {

class Run {
public:
    Run(const Scene& scene, const BackendMaker& makeBackend, Backend& peer, Executor& executor,
        const TradeoffOptions& options)
        : scene_(scene), makeBackend_(makeBackend), peer_(peer), executor_(executor),
          options_(options), backend_(makeBackend()) {}

    TradeoffReport operator()(const RenderSettings& around) {
        report_.sweeps = makeSweeps(around);
        report_.settings.resize(report_.sweeps.settings.size());
        report_.images.resize(report_.sweeps.settings.size());
        takeMemory();
        takeErrors();
        time();
        return std::move(report_);
    }

private:
    void say(const std::string& line) const {
        if (options_.progress) options_.progress(line);
    }

    RenderResult frame(size_t i, Backend& backend) const {
        RenderSettings one = report_.sweeps.settings[i];
        one.samples = 1;
        return Renderer(scene_, one, backend).render();
    }

    /// And which images are the same.
    void takeMemory() {
        say("memory");
        std::vector<Image> images;
        for (size_t i = 0; i < report_.settings.size(); ++i) {
            const std::unique_ptr<Backend> fresh = makeBackend_();
            images.push_back(frame(i, *fresh).image);
            SettingsReport& to = report_.settings[i];
            to.listEntries = fresh->listEntries();
            to.bytes = totalBytes(fresh->memory());
            to.image = sameImage(images, i);
        }
    }

    void time() {
        for (int round = 0; round <= options_.rounds; ++round) {
            say("round " + std::to_string(round) + " of " + std::to_string(options_.rounds));
            for (size_t i = 0; i < report_.settings.size(); ++i) {
                const RenderResult result = frame(i, *backend_);
                if (round == 0) continue; // warms up
                const double build = totalMs(result.build);
                report_.settings[i].build.ms.push_back(build);
                report_.settings[i].sample.ms.push_back(totalMs(result.passes) - build);
            }
        }
    }

    static size_t sameImage(const std::vector<Image>& images, size_t i) {
        for (size_t k = 0; k < i; ++k)
            if (images[k].pixels == images[i].pixels) return k;
        return i;
    }

    Image converge(RenderSettings settings, int bounces) {
        settings.grid.mode = ViewMode::full;
        settings.samples = options_.referenceSamples;
        settings.bounces = bounces;
        ++settings.seed; // other samples than those whose error it shows
        const auto trace = [&] {
            say("reference, " + std::to_string(bounces) + " bounces");
            return Renderer(scene_, settings, peer_).render().image;
        };
        return options_.reference ? options_.reference(settings, trace) : trace();
    }

    void takeErrors() {
        const std::vector<RenderSettings>& all = report_.sweeps.settings;
        const auto differs = [&](size_t i) { return report_.settings[i].image == i; };
        if (options_.knownErrors) {
            for (size_t i = 0; i < all.size(); ++i)
                if (differs(i)) report_.settings[i].errors = options_.knownErrors(i);
            return;
        }
        int most = 0;
        for (const RenderSettings& settings : all) most = std::max(most, settings.bounces);
        report_.reference = converge(all.front(), all.front().bounces);
        const Image longest = converge(all.front(), most);
        for (size_t i = 0; i < all.size(); ++i) {
            const bool other = all[i].bounces != all.front().bounces;
            if (differs(i)) takeErrors(i, other ? longest : report_.reference);
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
            Image image{settings.grid.width, settings.grid.height, backend_->readImage()};
            for (glm::vec3& pixel : image.pixels) pixel *= 1.0f / (float) done;
            const Plane seen = hdrFlip(image, reference, executor_);
            report_.settings[i].errors.push_back(
                {done, differencesOf(image, reference).relativeMse,
                 std::accumulate(seen.values.begin(), seen.values.end(), 0.0) /
                     (double) seen.values.size()});
        };
        report_.images[i] = Renderer(scene_, settings, *backend_).render(hooks).image;
    }

    const Scene& scene_;
    const BackendMaker& makeBackend_;
    Backend& peer_;
    Executor& executor_;
    const TradeoffOptions& options_;
    std::unique_ptr<Backend> backend_; ///< that errors and times are taken of
    TradeoffReport report_;
};

} // namespace

TradeoffReport benchTradeoff(const Scene& scene, const RenderSettings& around,
                             const BackendMaker& makeBackend, Backend& reference,
                             Executor& executor, const TradeoffOptions& options) {
    return Run(scene, makeBackend, reference, executor, options)(around);
}

} // namespace dirt
