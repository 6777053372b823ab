#pragma once

#include "core/base/executor.h"
#include "core/frame/backend.h"
#include "core/path/camera_rays.h"
#include "core/path/grid_spotlight.h"
#include "core/path/shadow_frustum.h"
#include "core/trace/view_cone.h"

#include <cstdint>
#include <optional>
#include <span>

namespace dirt {

/// What the passes of a sample read and never change.
struct FrameContext {
    const Scene& scene;
    const FrameGeometry& geometry;
    const RenderSettings& settings;
    Requirements requirements;
    CameraRays camera;
    uint microfacets; ///< the scene's model
    uint rayType;     ///< what indirect rays take surfaces for; the values of RayType
    std::optional<GridSpotlight> light;
    std::optional<ShadowMap> shadowMap; ///< of the light
    std::optional<ViewCone> view;       ///< single mode: where secondary and shadow rays end

    FrameContext(const Scene& scene, const FrameGeometry& geometry, const RenderSettings& settings,
                 const Requirements& requirements);
};

/// A ray from a surface point to the light, which asks for any hit at t < maxT.
struct ShadowRay {
    Ray ray;
    float maxT = 0.0f;
};

/// The ray from the eye through \p pixel: what event 0 traces, or DirectVisibility rasterizes.
PathRay primaryRay(const FrameContext& frame, size_t pixel, uint32_t sample);

/// The shadow ray from G[k+1] of \p pixel at path event \p event; none where there is no light to
/// ask for, or it would add nothing.
std::optional<ShadowRay> shadowRay(const FrameContext& frame, int event, const PathBuffers& paths,
                                   size_t pixel);

// The passes of a sample on the host, each over all pixels: the definition of what every backend
// computes. Each writes all records of what it writes; a pixel without a path gets an empty one.

/// Mask of the pixels whose path goes on to event \p event >= 1: those that have reached a surface,
/// G[k], that reflects. Reads and writes the mask, which event 1 finds full.
void passDepthMask(const FrameContext& frame, Executor& executor, int event, PathBuffers& paths);

/// The rays of \p event: from the eye for event 0; else from G[k], in directions that its lobe
/// chooses. One that would leave through the surface gets no direction: the path ends.
void passRays(const FrameContext& frame, Executor& executor, uint32_t sample, int event,
              PathBuffers& paths);

/// Nearest hits of the rays, which it adds to \p counts. In single mode a ray that leaves the view
/// hits nothing; those from the eye never do, those through a lens may.
void passTrace(const FrameContext& frame, Executor& executor, Tracer& tracer, int event,
               PathBuffers& paths, FrameCounts& counts);

/// G[k+1] of each hit, by primitive id; counts the fetch in the hit's record.
void passFetch(const FrameContext& frame, Executor& executor, PathBuffers& paths);

/// Whether the light reaches G[k+1]; asked only where it would add something. In single mode a
/// shadow ray ends where it leaves the view.
void passVisibility(const FrameContext& frame, Executor& executor, Tracer& tracer, int event,
                    PathBuffers& paths, FrameCounts& counts);

/// Adds what G[k+1] emits and reflects of the light, or the background, to the pixel's radiance.
/// \p shadowDepths: the light's shadow map, if it has one.
void passShade(const FrameContext& frame, Executor& executor, int event,
               std::span<const float> shadowDepths, PathBuffers& paths);

/// Shifts the three points left.
void passShift(PathBuffers& paths);

/// Adds the sample's radiance to the image; pixels whose radiance was clamped to \p counts.
void passResolve(Executor& executor, PathBuffers& paths, FrameCounts& counts);

} // namespace dirt
