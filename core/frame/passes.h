#pragma once

#include "core/frame/backend.h"
#include "core/frame/executor.h"
#include "core/frame/path_buffers.h"
#include "core/frame/settings.h"
#include "core/path/camera_rays.h"
#include "core/path/spotlight.h"
#include "core/scene/scene.h"
#include "core/trace/view_cone.h"

#include <cstdint>
#include <optional>

namespace dirt {

/// What the passes of a frame read and never change.
struct FrameContext {
    const Scene& scene;
    const FrameGeometry& geometry;
    const RenderSettings& settings;
    Backend& backend;
    Executor& executor;
    CameraRays camera;
    std::optional<GridSpotlight> light;
    std::optional<ViewCone> view; ///< single mode: where secondary and shadow rays end
};

// The passes of one path event, each over all alive paths. Their order is Frame's.

/// Event 0: one ray from the eye through every pixel.
void passRays(const FrameContext& frame, uint32_t sample, PathBuffers& paths);

/// Events from 1: keeps the paths that go on, in order, and chooses their directions. A path ends
/// where it missed, where the surface is black, or where the direction would leave through the
/// surface. \p event is that of the new rays.
void passDepthMask(const FrameContext& frame, uint32_t sample, int event, PathBuffers& paths);

/// Nearest hits of the rays. In single mode a secondary ray that leaves the view hits nothing.
void passTrace(const FrameContext& frame, int event, PathBuffers& paths);

/// Surface points of the hits, by primitive id.
void passFetch(const FrameContext& frame, PathBuffers& paths);

/// What the light would add to each path, and whether it is occluded. Shadow rays are traced only
/// where it would add something; in single mode they end where they leave the view.
void passVisibility(const FrameContext& frame, PathBuffers& paths);

/// Adds emission, unoccluded light and background to the radiance of each path's pixel.
void passShade(const FrameContext& frame, int event, PathBuffers& paths);

} // namespace dirt
