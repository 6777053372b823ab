#include "core/aov/aovs.h"

#include <bit>

namespace dirt {

namespace {

using Of = AovKind::Of;

AovFrame makeFrame(const Scene& scene, const GridFrame& grid) {
    // The camera's axis is the third of a single view's frame.
    const glm::vec3 forward = grid.mode == ViewMode::single ? glm::vec3(0.0f, 0.0f, 1.0f)
                                                            : cameraBasis(scene.camera).forward;
    return {scene, grid, forward};
}

} // namespace

uint64_t aovBytes(const std::vector<const AovKind*>& kinds, uint64_t pixels) {
    if (kinds.empty()) return 0;
    uint64_t channels = 3, sums = 0;
    for (const AovKind* kind : kinds) {
        channels += kind->channels();
        sums += kind->channels() * (kind->of == Of::radiance ? 2 : 1);
    }
    // What is read of a sample, how many of them hit and the first id, all sums; the picture, and
    // when it is written its file twice.
    const uint64_t each = sizeof(SurfacePoint) + sizeof(glm::vec3) + 2 * sizeof(uint32_t) +
                          sums * sizeof(double) + 3 * channels * sizeof(float);
    return pixels * each;
}

Aovs::Aovs(const std::vector<const AovKind*>& kinds, const Scene& scene,
           const RenderSettings& settings)
    : scene_(scene), settings_(settings) {
    const size_t pixels = (size_t) settings.grid.width * (size_t) settings.grid.height;
    for (const AovKind* kind : kinds) {
        Layer& layer = layers_.emplace_back(Layer{kind, {}, {}});
        (kind->of == Of::radiance ? needsRadiance_ : needsPoints_) = true;
        if (kind->of == Of::firstSample)
            ids_.assign(pixels, kNoPrimitive);
        else
            layer.sum.assign(pixels * kind->channels(), 0.0);
        if (kind->of == Of::radiance) layer.squares = layer.sum;
        if (kind->of == Of::hits) hits_.assign(pixels, 0);
    }
}

void Aovs::observe(const Backend& backend, int event) {
    if (event == 0 && needsPoints_) {
        if (!frame_) frame_.emplace(makeFrame(scene_, backend.readGeometry().frame));
        points_ = backend.readPoints();
    }
    if (event == settings_.bounces - 1 && needsRadiance_) radiance_ = backend.readRadiance();
}

void Aovs::finishSample() {
    ++samples_;
    for (size_t pixel = 0; pixel < hits_.size(); ++pixel) hits_[pixel] += points_[pixel].found();
    for (Layer& layer : layers_)
        if (layer.kind->of == Of::radiance)
            addRadiance(layer);
        else if (layer.kind->value)
            addPoints(layer);
    if (samples_ == 1)
        for (size_t pixel = 0; pixel < ids_.size(); ++pixel) ids_[pixel] = points_[pixel].primitive;
}

void Aovs::addPoints(Layer& layer) const {
    const size_t channels = layer.kind->channels();
    for (size_t pixel = 0; pixel < points_.size(); ++pixel) {
        if (!points_[pixel].found()) continue;
        const glm::dvec3 value = layer.kind->value(*frame_, points_[pixel]);
        for (size_t c = 0; c < channels; ++c) layer.sum[pixel * channels + c] += value[(int) c];
    }
}

/// Welford's sums: mean and squares of the distances from it, without the loss of digits that
/// sums of squares have.
void Aovs::addRadiance(Layer& layer) const {
    for (size_t i = 0; i < layer.sum.size(); ++i) {
        const double x = radiance_[i / 3][(int) (i % 3)];
        const double distance = x - layer.sum[i];
        layer.sum[i] += distance / samples_;
        layer.squares[i] += distance * (x - layer.sum[i]);
    }
}

void Aovs::appendValues(const Layer& layer, size_t pixel, std::vector<uint32_t>& values) const {
    const AovKind& kind = *layer.kind;
    const size_t channels = kind.channels();
    if (kind.of == Of::firstSample) {
        values.push_back(ids_[pixel]);
        return;
    }
    const std::vector<double>& sums = kind.of == Of::radiance ? layer.squares : layer.sum;
    const int count = kind.of == Of::radiance ? samples_ - 1
                      : kind.of == Of::hits   ? (int) hits_[pixel]
                                              : samples_;
    for (size_t c = 0; c < channels; ++c) {
        const double value = count > 0 ? sums[pixel * channels + c] / count : kind.nothing;
        values.push_back(std::bit_cast<uint32_t>((float) value));
    }
}

ExrPart Aovs::picture(const Image& image) const {
    using Type = ExrChannel::Type;
    ExrPart part{"", image.width, image.height, {}, {}};
    for (const char* name : {"R", "G", "B"}) part.channels.push_back({name, Type::float32});
    for (const Layer& layer : layers_)
        for (const char letter : std::string(layer.kind->letters))
            part.channels.push_back(
                {std::string(layer.kind->name) + "." + letter,
                 layer.kind->of == Of::firstSample ? Type::uint32 : Type::float32});
    part.values.reserve(image.pixels.size() * part.channels.size());
    for (size_t pixel = 0; pixel < image.pixels.size(); ++pixel) {
        for (int c = 0; c < 3; ++c)
            part.values.push_back(std::bit_cast<uint32_t>(image.pixels[pixel][c]));
        for (const Layer& layer : layers_) appendValues(layer, pixel, part.values);
    }
    return part;
}

} // namespace dirt
