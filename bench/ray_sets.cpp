#include "bench/ray_sets.h"

#include "core/frame/host_backend.h"
#include "core/frame/renderer.h"

namespace dirt {

namespace {

/// Passes all rays on to another backend, and keeps them.
class Recorder final : public HostBackend {
public:
    Recorder(Backend& inner, Executor& executor, RaySets& sets)
        : HostBackend(executor), inner_(inner), sets_(sets) {}

    std::string name() const override { return inner_.name(); }
    std::string device() const override { return inner_.device(); }
    void expectLight(const Spotlight* light) override { inner_.expectLight(light); }
    void clear(const Camera& camera, const GridSettings& settings) override {
        camera_ = camera;
        settings_ = settings;
    }
    void fillPrimitives() override { inner_.build(*geometry_, camera_, settings_); }
    void trace(int event) override {
        target_ = event == 0 ? &sets_.primary : &sets_.diffuse;
        HostBackend::trace(event);
    }
    void intersect(std::span<const Ray> rays, std::span<Hit> hits) override {
        inner_.intersect(rays, hits);
        target_->insert(target_->end(), rays.begin(), rays.end());
    }
    void occluded(std::span<const Ray> rays, std::span<const float> maxT,
                  std::span<uint8_t> result) override {
        inner_.occluded(rays, maxT, result);
        sets_.shadow.insert(sets_.shadow.end(), rays.begin(), rays.end());
        sets_.shadowMaxT.insert(sets_.shadowMaxT.end(), maxT.begin(), maxT.end());
    }

private:
    Backend& inner_;
    RaySets& sets_;
    std::vector<Ray>* target_ = nullptr;
    Camera camera_;
    GridSettings settings_;
};

} // namespace

RaySets makeRaySets(const Scene& scene, const RenderSettings& settings, Backend& backend,
                    Executor& executor) {
    RaySets sets;
    Recorder recorder(backend, executor, sets);
    RenderSettings two = settings;
    two.samples = 1;
    two.bounces = 2;
    two.visibility = LightVisibility::traced;
    Renderer(scene, two, recorder).render();
    return sets;
}

} // namespace dirt
