#include "core/frame/passes.h"

#include "core/frame/compact.h"
#include "core/trace/offset.h"
#include "shaders/shared/random.h"
#include "shaders/shared/sampling.h"

#include <algorithm>
#include <numbers>

namespace dirt {

namespace {

/// Paths in one piece of work.
constexpr size_t kGrain = 4096;

bool black(glm::vec3 color) {
    return !(color.x > 0.0f || color.y > 0.0f || color.z > 0.0f);
}

/// Cosine for light that arrives from \p direction, zero unless it does so in front of the
/// geometric and the shading normal alike: what an interpolated normal lets in from behind would
/// be a leak.
float shadingCosine(const SurfacePoint& point, glm::vec3 direction) {
    const float cosine = dotProduct(point.shadingNormal, direction);
    return dotProduct(point.geometricNormal, direction) > 0.0f && cosine > 0.0f ? cosine : 0.0f;
}

/// A ray that leaves the surface at \p hit.
Ray leavingRay(const FrameGeometry& geometry, const Hit& hit, glm::vec3 direction) {
    Ray ray;
    ray.origin = offsetOrigin(geometry.triangles[hit.primitive], hit.u, hit.v, direction);
    ray.direction = direction;
    ray.skip = hit.primitive;
    return ray;
}

} // namespace

void passRays(const FrameContext& frame, uint32_t sample, PathBuffers& paths) {
    const size_t width = (size_t) frame.settings.grid.width;
    const size_t count = width * frame.settings.grid.height;
    const glm::vec2 offset = subPixelOffset(sample, frame.settings.seed);
    paths.resize(count);
    frame.executor.forRange(count, kGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            paths.radiance[i] = glm::vec3(0.0f);
            paths.throughput[i] = glm::vec3(1.0f);
            paths.pixels[i] = (uint32_t) i;
            paths.rays[i] = frame.camera.through((float) (i % width) + offset.x,
                                                 (float) (i / width) + offset.y);
        }
    });
}

void passDepthMask(const FrameContext& frame, uint32_t sample, int event, PathBuffers& paths) {
    const uint32_t seed = frame.settings.seed;
    const auto goesOn = [&](size_t i) {
        if (!paths.hits[i].found() || black(paths.points[i].diffuse)) return false;
        const SurfacePoint& point = paths.points[i];
        const uint32_t pixel = paths.pixels[i];
        const float u = randomUnit(pixel, sample, (uint) event, kDimensionScatterU, seed);
        const float v = randomUnit(pixel, sample, (uint) event, kDimensionScatterV, seed);
        paths.directions[i] = cosineAround(point.shadingNormal, u, v);
        return shadingCosine(point, paths.directions[i]) > 0.0f;
    };
    const auto alive = compact(frame.executor, paths.rays.size(), kGrain, goesOn);

    std::vector<uint32_t> pixels(alive.size());
    std::vector<Ray> rays(alive.size());
    frame.executor.forRange(alive.size(), kGrain, [&](size_t begin, size_t end) {
        for (size_t j = begin; j < end; ++j) {
            const uint32_t i = alive[j];
            pixels[j] = paths.pixels[i];
            rays[j] = leavingRay(frame.geometry, paths.hits[i], paths.directions[i]);
            // Lambert: the cosine and 1/pi of the reflectance cancel against the density.
            paths.throughput[pixels[j]] *= paths.points[i].diffuse;
        }
    });
    paths.pixels.swap(pixels);
    paths.rays.swap(rays);
}

void passTrace(const FrameContext& frame, int event, PathBuffers& paths) {
    paths.hits.resize(paths.rays.size());
    frame.backend.trace(paths.rays, paths.hits);
    if (event == 0 || !frame.view) return;
    frame.executor.forRange(paths.rays.size(), kGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i)
            if (!frame.view->part(paths.rays[i]).holds(paths.hits[i].t)) paths.hits[i] = Hit{};
    });
}

void passFetch(const FrameContext& frame, PathBuffers& paths) {
    frame.executor.forRange(paths.hits.size(), kGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i)
            if (paths.hits[i].found())
                paths.points[i] =
                    fetchSurface(frame.scene, frame.geometry, paths.rays[i], paths.hits[i]);
    });
}

void passVisibility(const FrameContext& frame, PathBuffers& paths) {
    paths.shadowPaths.clear();
    if (!frame.light) return;
    const auto lit = [&](size_t i) {
        if (!paths.hits[i].found()) return false;
        const SurfacePoint& point = paths.points[i];
        const LightSample light = frame.light->sample(point.position);
        const float cosine = shadingCosine(point, light.direction);
        paths.direct[i] = point.diffuse * std::numbers::inv_pi_v<float> * light.irradiance * cosine;
        paths.directions[i] = light.toLight;
        return !black(paths.direct[i]);
    };
    paths.shadowPaths = compact(frame.executor, paths.hits.size(), kGrain, lit);

    const size_t count = paths.shadowPaths.size();
    paths.shadowRays.resize(count);
    paths.shadowMaxT.resize(count);
    paths.occluded.resize(count);
    frame.executor.forRange(count, kGrain, [&](size_t begin, size_t end) {
        for (size_t s = begin; s < end; ++s) {
            const uint32_t i = paths.shadowPaths[s];
            Ray ray = leavingRay(frame.geometry, paths.hits[i], paths.directions[i]);
            ray.direction = frame.light->position() - ray.origin;
            paths.shadowRays[s] = ray;
            paths.shadowMaxT[s] = frame.view ? std::min(frame.view->part(ray).end, 1.0f) : 1.0f;
        }
    });
    frame.backend.occluded(paths.shadowRays, paths.shadowMaxT, paths.occluded);
}

void passShade(const FrameContext& frame, int event, PathBuffers& paths) {
    // In single mode a secondary ray that leaves the view returns nothing.
    const bool seesBackground = event == 0 || frame.settings.grid.mode == ViewMode::full;
    frame.executor.forRange(paths.hits.size(), kGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            const uint32_t pixel = paths.pixels[i];
            if (paths.hits[i].found())
                paths.radiance[pixel] += paths.throughput[pixel] * paths.points[i].emission;
            else if (seesBackground)
                paths.radiance[pixel] += paths.throughput[pixel] * frame.scene.background;
        }
    });
    frame.executor.forRange(paths.shadowPaths.size(), kGrain, [&](size_t begin, size_t end) {
        for (size_t s = begin; s < end; ++s) {
            if (paths.occluded[s]) continue;
            const uint32_t i = paths.shadowPaths[s];
            const uint32_t pixel = paths.pixels[i];
            paths.radiance[pixel] += paths.throughput[pixel] * paths.direct[i];
        }
    });
}

} // namespace dirt
