#pragma once

#include "core/frame/buffer_size.h"
#include "core/frame/settings.h"
#include "core/grid/geometry.h"
#include "core/scene/light.h"
#include "core/trace/ray.h"

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace dirt {

/// The time of one pass, over all samples of a frame.
struct PassTime {
    std::string name;
    double ms = 0.0;
    int event = 0; ///< path event; 0 for the build
};

double totalMs(std::span<const PassTime> passes);

/// What finds hits: builds a structure over a frame's geometry and casts rays through it.
/// The same rays give the same bits for any number of threads.
class Tracer {
public:
    virtual ~Tracer() = default;

    virtual std::string name() const = 0;
    virtual std::string device() const = 0;

    /// Of the builds that follow: many rays will end in this light, or (null) in none. A tracer may
    /// build more for these; answers are the same.
    virtual void expectLight(const Spotlight*) {}

    /// Builds everything anew and says how long each pass took. \p geometry must stay alive and
    /// unchanged while rays are cast.
    virtual std::vector<PassTime> build(const FrameGeometry& geometry, const Camera& camera,
                                        const GridSettings& settings) = 0;

    /// Nearest hits. A ray with a NaN or an infinity in it hits nothing.
    virtual void intersect(std::span<const Ray> rays, std::span<Hit> hits) = 0;

    /// For each ray, 1 if anything is hit at t < maxT[i], else 0.
    virtual void occluded(std::span<const Ray> rays, std::span<const float> maxT,
                          std::span<uint8_t> result) = 0;
};

} // namespace dirt
