#pragma once

#include "core/aov/aov_kinds.h"
#include "core/base/image.h"
#include "core/frame/backend.h"
#include "core/io/exr_parts.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dirt {

/// Bytes that layers of these kinds take beside a frame of so many pixels, their file included.
uint64_t aovBytes(const std::vector<const AovKind*>& kinds, uint64_t pixels);

/// Layers that are gathered beside one frame's image: of the first hits of its samples, and of how
/// far these differ. Sums are in double, so that many samples, and positions far from 0, keep
/// their digits.
class Aovs {
public:
    /// \p scene and \p settings must outlive it, and be those of the frame.
    Aovs(const std::vector<const AovKind*>& kinds, const Scene& scene,
         const RenderSettings& settings);

    bool empty() const { return layers_.empty(); }

    /// After the Shade of path event \p event: takes what it needs from \p backend.
    void observe(const Backend& backend, int event);
    /// What has been observed since the last call is a sample that is finished; without the call it
    /// is forgotten.
    void finishSample();

    /// \p image as R, G and B, and all layers as NAME.LETTER, in one part.
    ExrPart picture(const Image& image) const;

private:
    struct Layer {
        const AovKind* kind;
        std::vector<double> sum; ///< the channels of a pixel together; of the radiance: its mean
        std::vector<double> squares; ///< of the radiance: of the distances from the mean
    };
    void addPoints(Layer& layer) const;
    void addRadiance(Layer& layer) const;
    void appendValues(const Layer& layer, size_t pixel, std::vector<uint32_t>& values) const;

    const Scene& scene_;
    const RenderSettings& settings_;
    std::optional<AovFrame> frame_;
    std::vector<Layer> layers_;
    bool needsPoints_ = false, needsRadiance_ = false;
    std::vector<SurfacePoint> points_; ///< G[1] of the sample under way
    std::vector<glm::vec3> radiance_;  ///< what it has gathered
    std::vector<uint32_t> hits_;       ///< of each pixel, the samples that hit something
    std::vector<uint32_t> ids_;        ///< of the first sample
    int samples_ = 0;
};

} // namespace dirt
