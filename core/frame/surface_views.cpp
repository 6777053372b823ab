#include "core/frame/surface_views.h"

#include "core/trace/offset.h"
#include "shaders/shared/random.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace dirt {

namespace {

constexpr size_t kSamples = 1024; ///< shares are right to a few hundredths

glm::dvec3 areaVector(const Triangle& t) {
    const glm::dvec3 a = t.a;
    return 0.5 * glm::cross(glm::dvec3(t.b) - a, glm::dvec3(t.c) - a);
}

/// What is seen edge-on is not seen; along a surface of many triangles its ray would be dear.
/// Rounded to float a direction may be off by 2^-24 of its length: what is less than twice that
/// from the surface, as the cosine of a right angle in double is, cannot be told from it.
constexpr double kEdgeOn = 0x1p-23;

/// Looks back from the samples to each of \p ends, which are places or directions.
std::vector<SurfaceView> look(std::span<const glm::dvec3> ends, bool isPlace,
                              std::span<const SurfaceSample> samples, Tracer& tracer) {
    const float reach = isPlace ? 1.0f : std::numeric_limits<float>::infinity();
    std::vector<Ray> rays;
    std::vector<double> cosines;
    std::vector<float> maxT;
    rays.reserve(ends.size() * samples.size());
    for (const glm::dvec3& end : ends)
        for (const SurfaceSample& sample : samples) {
            Ray ray;
            ray.direction = glm::vec3(isPlace ? end - glm::dvec3(sample.point) : end);
            const glm::dvec3 direction(ray.direction);
            const double cosine = glm::dot(sample.normal, direction);
            cosines.push_back(std::abs(cosine) <= kEdgeOn * glm::length(direction) ? 0.0 : cosine);
            // From within, what lies on a floor hides it; from outside both sheets of a wall that
            // has two in one plane are seen, one by its front and one by its back.
            ray.origin = isPlace ? sample.point : cosines.back() > 0.0 ? sample.front : sample.back;
            ray.skip = sample.triangle;
            rays.push_back(ray);
            maxT.push_back(cosines.back() != 0.0 ? reach : 0.0f);
        }
    std::vector<uint8_t> occluded(rays.size());
    tracer.occluded(rays, maxT, occluded);

    std::vector<SurfaceView> views(ends.size(), SurfaceView(samples.size(), Side::hidden));
    for (size_t i = 0; i < rays.size(); ++i)
        if (!occluded[i] && cosines[i] != 0.0)
            views[i / samples.size()][i % samples.size()] =
                cosines[i] > 0.0 ? Side::front : Side::back;
    return views;
}

} // namespace

std::vector<SurfaceSample> sampleSurface(const Mesh& mesh, const FrameGeometry& geometry) {
    std::vector<double> until; // area of the triangles up to each
    until.reserve(geometry.triangles.size());
    double area = 0.0;
    for (const Triangle& t : geometry.triangles)
        until.push_back(area += glm::length(areaVector(t)));
    std::vector<SurfaceSample> samples;
    if (area == 0.0) return samples;
    for (size_t i = 0; i < kSamples; ++i) {
        const double share = area * ((double) i + 0.5) / (double) kSamples;
        const auto found = std::upper_bound(until.begin(), until.end(), share);
        const uint32_t id = (uint32_t) (found - until.begin());
        const Triangle& t = geometry.triangles[id];
        // Uniform over the triangle: lines of equal distance from a by the root.
        const float away = std::sqrt(randomUnit((uint32_t) i, 0, 0, 0, 0));
        const float along = randomUnit((uint32_t) i, 0, 0, 1, 0);
        const glm::dvec3 a = t.a, b = t.b, c = t.c;
        const glm::dvec3 point = a + (double) away * ((b - a) + (double) along * (c - b));
        const float u = away * (1.0f - along), v = away * along;
        const glm::dvec3 normal = glm::normalize(areaVector(t));
        samples.push_back({glm::vec3(point), offsetOrigin(t, u, v, glm::vec3(normal)),
                           offsetOrigin(t, u, v, glm::vec3(-normal)), normal, id,
                           mesh.materials.empty() ? 0 : mesh.materials[id]});
    }
    return samples;
}

double shareOf(const SurfaceView& view, Side side) {
    if (view.empty()) return 0.0;
    return (double) std::count(view.begin(), view.end(), side) / (double) view.size();
}

double shareSeen(const SurfaceView& view) {
    return 1.0 - shareOf(view, Side::hidden);
}

std::vector<SurfaceView> viewsFrom(std::span<const glm::dvec3> directions,
                                   std::span<const SurfaceSample> samples, Tracer& tracer) {
    return look(directions, false, samples, tracer);
}

std::vector<SurfaceView> viewsAt(std::span<const glm::dvec3> places,
                                 std::span<const SurfaceSample> samples, Tracer& tracer) {
    return look(places, true, samples, tracer);
}

} // namespace dirt
