#include "core/frame/model_kind.h"

#include "shaders/shared/random.h"
#include "shaders/shared/sampling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include <glm/geometric.hpp>

namespace dirt {

namespace {

constexpr size_t kDirections = 64; ///< that the model is seen from
constexpr size_t kPlaces = 64;     ///< inside that are tried

/// Directions evenly over the sphere: in equal steps along an axis, turned by the golden angle.
std::vector<glm::dvec3> directionsAround() {
    std::vector<glm::dvec3> result;
    const double goldenAngle = std::numbers::pi * (3.0 - std::sqrt(5.0));
    for (size_t i = 0; i < kDirections; ++i) {
        const double y = 1.0 - (2.0 * (double) i + 1.0) / (double) kDirections;
        const double radius = std::sqrt(1.0 - y * y), angle = goldenAngle * (double) i;
        result.push_back({radius * std::cos(angle), y, radius * std::sin(angle)});
    }
    return result;
}

/// Of what leaves the front of \p sample, the part that meets the model again: by the cosine, over
/// the directions on that side.
double enclosure(const SurfaceSample& sample, size_t index, std::span<const glm::dvec3> directions,
                 std::span<const SurfaceView> views) {
    double all = 0.0, open = 0.0;
    for (size_t d = 0; d < directions.size(); ++d) {
        const double cosine = glm::dot(sample.normal, directions[d]);
        if (cosine <= 0.0) continue;
        all += cosine;
        if (views[d][index] == Side::front) open += cosine;
    }
    return all > 0.0 ? 1.0 - open / all : 0.0;
}

/// Places with fronts around them: on the way from one front to another that it sees.
std::vector<glm::dvec3> placesBetweenFronts(const FrameGeometry& geometry,
                                            std::span<const SurfaceSample> samples,
                                            Tracer& tracer) {
    std::vector<Ray> rays;
    for (size_t i = 0; i < samples.size(); ++i) {
        const glm::vec3 normal = glm::vec3(samples[i].normal);
        glm::vec3 tangent, bitangent;
        orthonormalBasis(normal, tangent, bitangent);
        const glm::vec3 local = cosineHemisphere(randomUnit((uint32_t) i, 1, 0, 0, 0),
                                                 randomUnit((uint32_t) i, 1, 0, 1, 0));
        Ray ray;
        ray.origin = samples[i].point;
        ray.direction = local.x * tangent + local.y * bitangent + local.z * normal;
        ray.skip = samples[i].triangle;
        rays.push_back(ray);
    }
    std::vector<Hit> hits(rays.size());
    tracer.intersect(rays, hits);

    std::vector<glm::dvec3> all;
    for (size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i].found()) continue;
        const Triangle& t = geometry.triangles[hits[i].primitive];
        const glm::dvec3 normal = glm::cross(glm::dvec3(t.b - t.a), glm::dvec3(t.c - t.a));
        const glm::dvec3 way = rays[i].direction;
        if (glm::dot(normal, way) >= 0.0) continue;
        const double part = randomUnit((uint32_t) i, 1, 0, 2, 0);
        all.push_back(glm::dvec3(rays[i].origin) + part * (double) hits[i].t * way);
    }
    std::vector<glm::dvec3> places;
    const size_t count = std::min(kPlaces, all.size());
    for (size_t i = 0; i < count; ++i) places.push_back(all[all.size() * i / count]);
    return places;
}

/// The largest share of \p side in one of \p views.
double mostOf(std::span<const SurfaceView> views, Side side) {
    double most = 0.0;
    for (const SurfaceView& view : views) most = std::max(most, shareOf(view, side));
    return most;
}

double mostSeen(std::span<const SurfaceView> views) {
    double most = 0.0;
    for (const SurfaceView& view : views) most = std::max(most, shareSeen(view));
    return most;
}

/// What is seen in one or another of \p views; of each sample, the first side that it is seen from.
SurfaceView together(std::span<const SurfaceView> views, size_t samples) {
    SurfaceView result(samples, Side::hidden);
    for (const SurfaceView& view : views)
        for (size_t s = 0; s < samples; ++s)
            if (result[s] == Side::hidden) result[s] = view[s];
    return result;
}

/// Whether no direction shows more of fronts than of backs.
bool turnsBacksOutwards(std::span<const SurfaceView> views, std::span<const SurfaceSample> samples,
                        std::span<const glm::dvec3> directions) {
    for (size_t d = 0; d < directions.size(); ++d) {
        double projected = 0.0; // area of fronts less that of backs
        for (size_t s = 0; s < samples.size(); ++s)
            if (views[d][s] != Side::hidden)
                projected += glm::dot(samples[s].normal, directions[d]);
        if (projected > 0.0) return false;
    }
    return !samples.empty();
}

/// Whether nothing is seen from \p views but fronts that are open to the outside: the skin of
/// something closed.
bool isClosed(std::span<const SurfaceView> views, std::span<const double> within) {
    for (const SurfaceView& view : views)
        for (size_t s = 0; s < view.size(); ++s)
            if (view[s] == Side::back || (view[s] == Side::front && within[s] > 0.5)) return false;
    return true;
}

/// Whether one sees the fronts of all of it at once, along one of the axes.
bool isSeenWhole(std::span<const SurfaceSample> samples, Tracer& tracer) {
    const std::array<glm::dvec3, 6> axes{
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
    for (const SurfaceView& view : viewsFrom(axes, samples, tracer))
        if (shareOf(view, Side::front) == 1.0) return true;
    return false;
}

} // namespace

ModelKind kindOf(const FrameGeometry& geometry, std::span<const SurfaceSample> samples,
                 Tracer& tracer) {
    const std::vector<glm::dvec3> directions = directionsAround();
    const std::vector<SurfaceView> outside = viewsFrom(directions, samples, tracer);
    ModelKind kind;
    for (size_t s = 0; s < samples.size(); ++s)
        kind.within.push_back(enclosure(samples[s], s, directions, outside));
    const double within = std::accumulate(kind.within.begin(), kind.within.end(), 0.0);
    const bool backs = turnsBacksOutwards(outside, samples, directions);
    if (within <= 0.5 * (double) samples.size() || isClosed(outside, kind.within)) {
        kind.insideOut = backs;
        return kind;
    }

    kind.places = placesBetweenFronts(geometry, samples, tracer);
    kind.views = viewsAt(kind.places, samples, tracer);
    double best = -1.0; // fronts less backs: among leaves, half of what is seen are backs
    for (const SurfaceView& view : kind.views)
        best = std::max(best, shareOf(view, Side::front) - shareOf(view, Side::back));
    if (backs) {
        const double seenWithin = shareOf(together(kind.views, samples.size()), Side::front);
        const double seenOutside = shareSeen(together(outside, samples.size()));
        kind.room = seenWithin > seenOutside && best > mostSeen(outside);
        kind.insideOut = !kind.room;
    } else {
        kind.room = best > mostOf(outside, Side::front) && !isSeenWhole(samples, tracer);
    }
    return kind;
}

} // namespace dirt
