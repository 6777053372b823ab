#include "core/frame/passes.h"

#include "core/frame/compact.h"
#include "core/path/fetch_surface.h"
#include "core/path/sub_pixel.h"
#include "core/trace/offset.h"
#include "shaders/shared/glossy_reflection.h"
#include "shaders/shared/random.h"

#include <algorithm>
#include <atomic>
#include <span>

namespace dirt {

namespace {

/// Pixels in one piece of work.
constexpr size_t kGrain = 4096;

/// Rays that are cast together: enough to keep many threads busy, few enough that they and their
/// answers stay in the cache.
constexpr size_t kRaysPerCast = 1 << 16;

/// A ray that leaves the surface at \p point.
Ray leavingRay(const FrameGeometry& geometry, const SurfacePoint& point, glm::vec3 direction) {
    return {offsetOrigin(geometry.triangles[point.primitive], point.u, point.v, direction),
            direction, point.primitive};
}

/// The numbers of one pixel and path event.
struct RandomNumbers {
    uint pixel, sample, event, seed;

    float operator()(uint dimension) const {
        return randomUnit(pixel, sample, event, dimension, seed);
    }
};

PathRay cameraRay(const FrameContext& frame, size_t pixel, uint32_t sample, glm::vec2 offset) {
    const size_t width = (size_t) frame.settings.grid.width;
    const float x = (float) (pixel % width) + offset.x, y = (float) (pixel / width) + offset.y;
    const RandomNumbers random{(uint) pixel, sample, 0, frame.settings.seed};
    const Ray ray = frame.requirements.lens ? frame.camera.through(x, y, random(kDimensionLensU),
                                                                   random(kDimensionLensV))
                                            : frame.camera.through(x, y);
    return {ray.origin, kNoPrimitive, ray.direction, 1.0f, glm::vec3(1.0f), 0.0f};
}

/// The unit vector from a point that the ray of path event \p event has found back along the ray.
/// Without a lens those of event 0 come from the eye, whether they were traced or not.
glm::vec3 towardsViewer(const FrameContext& frame, int event, const PathBuffers& paths,
                        size_t pixel, const SurfacePoint& point) {
    return event == 0 && !frame.requirements.lens ? directionToEye(point.position)
                                                  : -unitVector(paths.rays[pixel].direction);
}

StoredPoint nextPoint(const FrameContext& frame, const PathBuffers& paths, size_t pixel) {
    return {frame.geometry, paths.next, paths.packedNext, pixel};
}
StoredPoint currentPoint(const FrameContext& frame, const PathBuffers& paths, size_t pixel) {
    return {frame.geometry, paths.current, paths.packedCurrent, pixel};
}

/// What the surface \p point, G[k+1], reflects of the light, unless something is between them.
glm::vec3 reflectedOfLight(const FrameContext& frame, int event, const PathBuffers& paths,
                           size_t pixel, const SurfacePoint& point) {
    const LightSample light = sampleSpotlight(*frame.light, point.position);
    if (!isGlossy(point)) return reflectedRadiance(point, light);
    return reflectedRadiance(point, frame.microfacets,
                             towardsViewer(frame, event, paths, pixel, point), light);
}

/// What the surface at G[k+1] reflects of the light that its shadow map lets through.
glm::vec3 litThroughMap(const FrameContext& frame, int event, std::span<const float> depths,
                        const PathBuffers& paths, size_t pixel, const SurfacePoint& point) {
    const glm::vec3 reflected = reflectedOfLight(frame, event, paths, pixel, point);
    if (black(reflected)) return glm::vec3(0.0f);
    const ShadowTexels texels{depths.data(), frame.shadowMap->resolution};
    return reflected * openToLight(texels, *frame.light, *frame.shadowMap, point.position,
                                   point.geometricNormal);
}

Scattering scatterAt(const FrameContext& frame, const RandomNumbers& random, int event,
                     const PathBuffers& paths, const SurfacePoint& point) {
    const float u = random(kDimensionScatterU), v = random(kDimensionScatterV);
    if (!isGlossy(point)) return scatter(point, u, v);
    const glm::vec3 viewer = towardsViewer(frame, event - 1, paths, random.pixel, point);
    return scatter(point, frame.microfacets, viewer, random(kDimensionLobe), u, v,
                   random(kDimensionFacet));
}

PathRay scatteredRay(const FrameContext& frame, uint32_t pixel, uint32_t sample, int event,
                     const PathBuffers& paths) {
    const RandomNumbers random{pixel, sample, (uint) event, frame.settings.seed};
    const SurfacePoint point = takenFor(frame.rayType, *currentPoint(frame, paths, pixel));
    const Scattering next = scatterAt(frame, random, event, paths, point);
    if (next.direction == glm::vec3(0.0f)) return {};
    glm::vec3 throughput = next.weight;
    if (event > 1) throughput = paths.rays[pixel].throughput * throughput;
    if (frame.settings.roulette && (uint) event >= kFirstRouletteEvent) {
        const float chance = survivalChance(throughput);
        if (!(random(kDimensionRoulette) < chance)) return {};
        throughput = throughput / chance;
    }
    const Ray ray = leavingRay(frame.geometry, point, next.direction);
    return {ray.origin, ray.skip, next.direction, next.pdf, boundedRadiance(throughput), 0.0f};
}

/// Whether the light would add something to G[k+1] of a pixel.
bool matters(const FrameContext& frame, int event, const PathBuffers& paths, size_t pixel) {
    return paths.alive(event, pixel) && paths.foundNext(pixel) &&
           !black(reflectedOfLight(frame, event, paths, pixel, *nextPoint(frame, paths, pixel)));
}

ShadowRay rayToLight(const FrameContext& frame, const SurfacePoint& point) {
    Ray ray = leavingRay(frame.geometry, point, frame.light->position - point.position);
    ray.direction = frame.light->position - ray.origin;
    return {ray, frame.view ? std::min(frame.view->part(ray).end, 1.0f) : 1.0f};
}

bool goesSomewhere(const PathRay& ray) {
    return ray.direction != glm::vec3(0.0f);
}

/// Calls \p cast(pixels) for slices of \p pixels.
template <typename Cast>
void inSlices(std::span<const uint32_t> pixels, const Cast& cast) {
    for (size_t first = 0; first < pixels.size(); first += kRaysPerCast)
        cast(pixels.subspan(first, std::min(kRaysPerCast, pixels.size() - first)));
}

} // namespace

FrameContext::FrameContext(const Scene& scene, const FrameGeometry& geometry,
                           const RenderSettings& settings, const Requirements& requirements)
    : scene(scene), geometry(geometry), settings(settings), requirements(requirements),
      camera(scene.camera, settings.grid.width, settings.grid.height, settings.grid.mode,
             geometry.frame.scale),
      microfacets((uint) scene.microfacetModel), rayType((uint) settings.rayType) {
    if (settings.grid.mode == ViewMode::single)
        view.emplace(makeViews(settings.grid, scene.camera).front());
    if (requirements.light) light = makeGridSpotlight(scene.lights.front(), geometry.frame);
    if (requirements.shadowMap > 0) shadowMap = makeShadowMap(scene, geometry.frame);
}

PathRay primaryRay(const FrameContext& frame, size_t pixel, uint32_t sample) {
    return cameraRay(frame, pixel, sample, subPixelOffset(sample, frame.settings.seed));
}

std::optional<ShadowRay> shadowRay(const FrameContext& frame, int event, const PathBuffers& paths,
                                   size_t pixel) {
    if (!frame.requirements.shadowRays || !matters(frame, event, paths, pixel)) return {};
    return rayToLight(frame, *nextPoint(frame, paths, pixel));
}

void passDepthMask(const FrameContext& frame, Executor& executor, int event, PathBuffers& paths) {
    const auto reflects = [&](size_t pixel) {
        if (frame.rayType == kRaysVisibility) return true;
        if (paths.packedCurrent.empty())
            return !black(paths.current[pixel].diffuse) || isGlossy(paths.current[pixel]);
        const PackedPoint point = paths.packedCurrent[pixel]; // the rest of it does not matter
        return !black(diffuseOf(point)) || isGlossy(point.gloss);
    };
    executor.forRange(paths.mask.size(), kGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i)
            paths.mask[i] = (event == 1 || paths.mask[i]) && paths.foundCurrent(i) && reflects(i);
    });
}

void passRays(const FrameContext& frame, Executor& executor, uint32_t sample, int event,
              PathBuffers& paths) {
    const glm::vec2 offset = subPixelOffset(sample, frame.settings.seed);
    executor.forRange(paths.rays.size(), kGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            PathRay& ray = paths.rays[i];
            if (event == 0)
                ray = cameraRay(frame, i, sample, offset);
            else if (paths.mask[i])
                ray = scatteredRay(frame, (uint32_t) i, sample, event, paths);
            else
                ray = {};
        }
    });
}

void passTrace(const FrameContext& frame, Executor& executor, Tracer& tracer, int event,
               PathBuffers& paths, FrameCounts& counts) {
    executor.forRange(paths.hits.size(), kGrain, [&](size_t begin, size_t end) {
        std::fill(paths.hits.begin() + begin, paths.hits.begin() + end, Hit{});
    });
    const auto pixels = compact(executor, paths.rays.size(), kGrain, [&](size_t i) {
        return paths.alive(event, i) && goesSomewhere(paths.rays[i]);
    });
    std::vector<Ray> rays(std::min(kRaysPerCast, pixels.size()));
    std::vector<Hit> hits(rays.size());
    inSlices(pixels, [&](std::span<const uint32_t> slice) {
        const size_t count = slice.size();
        executor.forRange(count, kGrain, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) {
                const PathRay& ray = paths.rays[slice[i]];
                rays[i] = {ray.origin, ray.direction, ray.skip};
            }
        });
        tracer.intersect({rays.data(), count}, {hits.data(), count});
        executor.forRange(count, kGrain, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) {
                const bool within = !frame.view || (event == 0 && !frame.requirements.lens);
                const bool seen = within || frame.view->part(rays[i]).holds(hits[i].t);
                if (seen) paths.hits[slice[i]] = hits[i];
            }
        });
        for (uint32_t pixel : slice) counts.hits += paths.hits[pixel].found() ? 1 : 0;
    });
    counts.rays += pixels.size();
}

void passFetch(const FrameContext& frame, Executor& executor, PathBuffers& paths) {
    executor.forRange(paths.hits.size(), kGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            Hit& hit = paths.hits[i];
            paths.clearNext(i);
            if (!hit.found()) continue;
            paths.setNext(i,
                          fetchSurface(frame.scene, frame.geometry, paths.rays[i].direction,
                                       hit.primitive, hit.u, hit.v),
                          frame.geometry);
            ++hit.fetches;
        }
    });
}

void passVisibility(const FrameContext& frame, Executor& executor, Tracer& tracer, int event,
                    PathBuffers& paths, FrameCounts& counts) {
    if (!frame.requirements.shadowRays) return;
    const auto pixels = compact(executor, paths.pixels(), kGrain, [&](size_t i) {
        paths.visibility[i] = 0;
        return matters(frame, event, paths, i);
    });
    std::vector<Ray> rays(std::min(kRaysPerCast, pixels.size()));
    std::vector<float> maxT(rays.size());
    std::vector<uint8_t> occluded(rays.size());
    inSlices(pixels, [&](std::span<const uint32_t> slice) {
        const size_t count = slice.size();
        executor.forRange(count, kGrain, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) {
                const ShadowRay shadow = rayToLight(frame, *nextPoint(frame, paths, slice[i]));
                rays[i] = shadow.ray;
                maxT[i] = shadow.maxT;
            }
        });
        tracer.occluded({rays.data(), count}, {maxT.data(), count}, {occluded.data(), count});
        for (size_t i = 0; i < count; ++i) paths.visibility[slice[i]] = occluded[i] ? 0 : 1;
    });
    counts.shadowRays += pixels.size();
}

void passShade(const FrameContext& frame, Executor& executor, int event,
               std::span<const float> shadowDepths, PathBuffers& paths) {
    // In single mode a secondary ray that leaves the view returns nothing.
    const bool seesBackground = event == 0 || frame.settings.grid.mode == ViewMode::full;
    executor.forRange(paths.pixels(), kGrain, [&](size_t begin, size_t end) {
        for (size_t i = begin; i < end; ++i) {
            if (!paths.alive(event, i)) continue;
            const StoredPoint point = nextPoint(frame, paths, i);
            const glm::vec3 throughput = event == 0 ? glm::vec3(1.0f) : paths.rays[i].throughput;
            const auto add = [&](glm::vec3 radiance) {
                paths.radiance[i] = boundedRadiance(paths.radiance[i] + radiance);
            };
            if (frame.rayType == kRaysVisibility)
                add(point->found() ? glm::vec3(0.0f) : throughput);
            else if (point->found())
                add(throughput * point->emission);
            else if (seesBackground)
                add(throughput * frame.scene.background);
            if (frame.requirements.shadowRays && paths.visibility[i])
                add(throughput * reflectedOfLight(frame, event, paths, i, *point));
            if (frame.requirements.openLight && point->found())
                add(throughput * reflectedOfLight(frame, event, paths, i, *point));
            if (frame.shadowMap && point->found())
                add(throughput * litThroughMap(frame, event, shadowDepths, paths, i, *point));
        }
    });
}

void passShift(PathBuffers& paths) {
    if (!paths.previous.empty()) paths.previous.swap(paths.current);
    if (!paths.current.empty()) paths.current.swap(paths.next);
    if (!paths.packedPrevious.empty()) paths.packedPrevious.swap(paths.packedCurrent);
    if (!paths.packedCurrent.empty()) paths.packedCurrent.swap(paths.packedNext);
}

void passResolve(Executor& executor, PathBuffers& paths, FrameCounts& counts) {
    std::atomic<uint64_t> clamped = 0;
    executor.forRange(paths.image.size(), kGrain, [&](size_t begin, size_t end) {
        uint64_t own = 0;
        for (size_t i = begin; i < end; ++i) {
            paths.image[i] += paths.radiance[i];
            if (reachesBound(paths.radiance[i])) ++own;
        }
        if (own > 0) clamped += own;
    });
    counts.clamped += clamped;
}

} // namespace dirt
