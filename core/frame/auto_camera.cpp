#include "core/frame/auto_camera.h"

#include "core/frame/framing.h"
#include "core/frame/model_kind.h"
#include "core/frame/object_view.h"
#include "core/trace/offset.h"
#include "shaders/shared/surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace dirt {

namespace {

constexpr int kHeadings = 16;                     ///< level directions tried at one place
constexpr float kFov = 53.0f, kObjectFov = 30.0f; ///< degrees
constexpr int kColumns = 12, kRows = 6;           ///< rays of a coarse image

/// Where to stand and which way to look; grid frame.
struct Look {
    glm::dvec3 eye, direction;
};

/// A model in the grid frame around the middle of its box, what is known of it, and what is asked.
struct Subject {
    const FrameGeometry& geometry;
    const CameraHints& hints;
    Horizon horizon;
    std::vector<SurfaceSample> samples;
    glm::dvec3 low{std::numeric_limits<double>::max()};
    glm::dvec3 high{std::numeric_limits<double>::lowest()};
    std::optional<glm::dvec3> eye, target;
    float verticalFov = kFov;

    Subject(const Mesh& mesh, const FrameGeometry& geometry, const CameraHints& hints)
        : geometry(geometry), hints(hints), horizon(hints.up),
          samples(sampleSurface(mesh, geometry)) {
        for (const Triangle& t : geometry.triangles)
            for (const glm::dvec3 p : {glm::dvec3(t.a), glm::dvec3(t.b), glm::dvec3(t.c)}) {
                low = glm::min(low, p);
                high = glm::max(high, p);
            }
        if (hints.eye) eye = toGrid(*hints.eye);
        if (hints.target) target = toGrid(*hints.target);
        if (hints.verticalFov) verticalFov = *hints.verticalFov;
    }
    Framing framing(glm::dvec3 direction) const {
        return Framing(direction, hints.up, verticalFov, hints.aspect);
    }
    glm::dvec3 centre() const { return 0.5 * (low + high); }
    /// In double: what is given may be far outside of what float's grid frame holds.
    glm::dvec3 toGrid(glm::vec3 world) const {
        const GridFrame& frame = geometry.frame;
        return (glm::dvec3(world) - glm::dvec3(frame.eye)) * (double) frame.scale;
    }
    glm::dvec3 toWorld(glm::dvec3 p) const {
        const GridFrame& frame = geometry.frame;
        return glm::dvec3(frame.eye) + p / (double) frame.scale;
    }
    /// The corners of the model's box.
    std::vector<glm::dvec3> box() const {
        std::vector<glm::dvec3> corners;
        for (int i = 0; i < 8; ++i)
            corners.push_back(
                {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
        return corners;
    }
};

/// What a picture is worth: the samples in it that \p view shows from a side that counts, each by
/// its weight and as far as it faces the eye; times the number of their materials, as a bare wall
/// shows less than what somebody has furnished.
double worthOf(const Subject& subject, const Look& look, const SurfaceView& view, bool backsToo,
               std::span<const double> weights) {
    const Framing framing = subject.framing(look.direction);
    double area = 0.0;
    std::set<uint32_t> materials;
    for (size_t s = 0; s < view.size(); ++s) {
        const bool counts = view[s] == Side::front || (backsToo && view[s] == Side::back);
        const SurfaceSample& sample = subject.samples[s];
        if (!counts || !framing.contains(sample.point, look.eye)) continue;
        const glm::dvec3 way = glm::normalize(look.eye - glm::dvec3(sample.point));
        area += std::abs(glm::dot(sample.normal, way)) * (weights.empty() ? 1.0 : weights[s]);
        materials.insert(sample.material);
    }
    return area * (double) materials.size();
}

/// The directions to try from \p eye: to the target, or around.
std::vector<Look> looksFrom(const Subject& subject, glm::dvec3 eye) {
    std::vector<Look> looks;
    if (!subject.target) {
        for (int i = 0; i < kHeadings; ++i)
            looks.push_back({eye, subject.horizon.heading(2.0 * std::numbers::pi * i / kHeadings)});
    } else if (*subject.target != eye) {
        looks.push_back({eye, *subject.target - eye});
    }
    return looks;
}

/// From a given place, what shows most: at the middle of the model, or level around.
Look lookFrom(const Subject& subject, glm::dvec3 eye, Tracer& tracer) {
    std::vector<Look> looks = looksFrom(subject, eye);
    if (!subject.target && subject.centre() != eye)
        looks.insert(looks.begin(), {eye, subject.centre() - eye});
    const SurfaceView view = viewsAt(std::array{eye}, subject.samples, tracer).front();
    Look best{eye, subject.horizon.forward};
    double most = -1.0;
    for (const Look& look : looks) {
        const double worth = worthOf(subject, look, view, true, {});
        if (worth <= most) continue;
        most = worth;
        best = look;
    }
    return best;
}

Look lookAtObject(const Subject& subject, const ModelKind& kind, Tracer& tracer) {
    std::vector<glm::dvec3> corners;
    corners.reserve(3 * subject.geometry.triangles.size());
    for (const Triangle& t : subject.geometry.triangles)
        corners.insert(corners.end(), {t.a, t.b, t.c});
    const glm::dvec3 direction = objectDirection(subject.horizon, kind, subject.samples, tracer);
    return {subject.framing(direction).eyeFor(corners, subject.target), direction};
}

/// What shows most of the surface that is seen from within: from one of the places inside, level;
/// or from outside, level or slightly from above, through an opening.
Look lookIntoRoom(const Subject& subject, const ModelKind& kind, Tracer& tracer) {
    const std::vector<glm::dvec3> box = subject.box();
    std::vector<Look> outside;
    std::vector<glm::dvec3> eyes;
    for (double rise : {0.0, kSlightly})
        for (int i = 0; i < kHeadings; ++i) {
            const double turn = 2.0 * std::numbers::pi * i / kHeadings;
            const glm::dvec3 direction =
                glm::normalize(subject.horizon.heading(turn) - rise * subject.horizon.up);
            eyes.push_back(subject.framing(direction).eyeFor(box, subject.target));
            outside.push_back({eyes.back(), direction});
        }
    const std::vector<SurfaceView> views = viewsAt(eyes, subject.samples, tracer);

    Look best = outside.front();
    double most = -1.0;
    const auto consider = [&](const Look& look, const SurfaceView& view) {
        const double worth = worthOf(subject, look, view, false, kind.within);
        if (worth <= most) return;
        most = worth;
        best = look;
    };
    for (size_t i = 0; i < outside.size(); ++i) consider(outside[i], views[i]);
    for (size_t i = 0; i < kind.places.size(); ++i)
        for (const Look& look : looksFrom(subject, kind.places[i])) consider(look, kind.views[i]);
    return best;
}

/// And through which lens, if that is not given.
Look chooseLook(Subject& subject, Tracer& tracer) {
    if (subject.eye) return lookFrom(subject, *subject.eye, tracer);
    const ModelKind kind = kindOf(subject.geometry, subject.samples, tracer);
    if (kind.room) return lookIntoRoom(subject, kind, tracer);
    if (!subject.hints.verticalFov) subject.verticalFov = kObjectFov;
    return lookAtObject(subject, kind, tracer);
}

/// What a coarse image shows.
struct Glance {
    double distance = 0.0; ///< median of what is seen, else that of the model's middle
    std::vector<Hit> hits; ///< what is seen
};

Glance glanceAt(const Subject& subject, const Look& look, Tracer& tracer) {
    const Framing framing = subject.framing(look.direction);
    std::vector<Ray> rays;
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column) {
            const double x = framing.wide * ((2 * column + 1) / (double) kColumns - 1.0);
            const double y = framing.tall * ((2 * row + 1) / (double) kRows - 1.0);
            Ray ray;
            ray.origin = glm::vec3(look.eye);
            ray.direction =
                glm::vec3(glm::normalize(framing.forward + x * framing.right + y * framing.down));
            rays.push_back(ray);
        }
    std::vector<Hit> hits(rays.size());
    tracer.intersect(rays, hits);

    Glance glance;
    std::vector<float> distances;
    for (size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i].found()) continue;
        distances.push_back(hits[i].t);
        glance.hits.push_back(hits[i]);
    }
    glance.distance = glm::length(subject.centre() - look.eye);
    if (distances.empty()) return glance;
    const auto median = distances.begin() + (std::ptrdiff_t)(distances.size() / 2);
    std::nth_element(distances.begin(), median, distances.end());
    glance.distance = *median;
    return glance;
}

/// Where a light stands: beside and above the eye, a tenth of the distance away, if it reaches most
/// of what is seen from there; else at the eye.
glm::dvec3 lightPlace(const Subject& subject, const Look& look, const Glance& glance,
                      Tracer& tracer) {
    const Framing framing = subject.framing(look.direction);
    const glm::dvec3 place = look.eye + 0.1 * glance.distance * (framing.right - framing.down);
    std::vector<Ray> rays;
    for (const Hit& hit : glance.hits) {
        const Triangle& t = subject.geometry.triangles[hit.primitive];
        const glm::vec3 point = interpolate(t.a, t.b, t.c, hit.u, hit.v);
        Ray ray;
        ray.origin = offsetOrigin(t, hit.u, hit.v, glm::vec3(place) - point);
        ray.direction = glm::vec3(place) - ray.origin;
        ray.skip = hit.primitive;
        rays.push_back(ray);
    }
    const std::vector<float> maxT(rays.size(), 1.0f);
    std::vector<uint8_t> occluded(rays.size());
    tracer.occluded(rays, maxT, occluded);
    const size_t dark = (size_t) std::count(occluded.begin(), occluded.end(), 1);
    return 2 * dark > occluded.size() ? look.eye : place;
}

/// A light that brings white paint at \p distance to a radiance of a third: with the background's,
/// and what is nearer, it stays below white.
Spotlight lightFor(const Camera& camera, glm::vec3 position, double distance) {
    Spotlight light;
    light.position = position;
    light.target = camera.target;
    light.aperture = 160.0f;
    light.penumbra = 120.0f;
    // Irradiance at the distance d is flux / (2 pi (1 - cos 80 degrees)) / d^2; white paint turns
    // it into radiance by 1 / pi.
    light.flux =
        roundedFlux(2.0 / 3.0 * std::numbers::pi * (1.0 - std::cos(80.0 * std::numbers::pi / 180)) *
                    std::numbers::pi * distance * distance);
    return light;
}

/// Puts a camera at \p eye with a target at \p distance, world space, apart in float.
void place(Camera& camera, glm::dvec3 eye, glm::dvec3 direction, double distance,
           const CameraHints& hints) {
    camera.eye = hints.eye.value_or(glm::vec3(eye));
    camera.target = hints.target.value_or(glm::vec3(eye + distance * direction));
    if (hints.eye && hints.target) return;
    for (double away = distance > 0.0 ? distance : 1.0; camera.eye == camera.target; away *= 2.0)
        if (hints.eye)
            camera.target = glm::vec3(eye + away * direction);
        else
            camera.eye = glm::vec3(eye - away * direction);
}

} // namespace

Standpoint chooseStandpoint(const Mesh& mesh, Tracer& tracer, const CameraHints& hints) {
    // One structure, around the middle of the box, serves all rays.
    glm::dvec3 low(std::numeric_limits<double>::max());
    glm::dvec3 high(std::numeric_limits<double>::lowest());
    for (const Corners& corners : mesh.triangles)
        for (uint32_t index : corners) {
            low = glm::min(low, glm::dvec3(mesh.positions[index]));
            high = glm::max(high, glm::dvec3(mesh.positions[index]));
        }
    Camera middle;
    middle.eye = glm::vec3(0.5 * (low + high));
    middle.target = middle.eye;
    const FrameGeometry geometry = makeFrameGeometry(mesh, middle, ViewMode::full);
    GridSettings settings;
    settings.width = settings.height = settings.viewSize = 512;
    tracer.build(geometry, middle, settings);

    Subject subject(mesh, geometry, hints);
    const Look look = chooseLook(subject, tracer);
    const Glance glance = glanceAt(subject, look, tracer);
    Standpoint result;
    result.camera.up = hints.up;
    result.camera.verticalFov = subject.verticalFov;
    const double distance = glance.distance / (double) geometry.frame.scale;
    place(result.camera, subject.toWorld(look.eye), glm::normalize(look.direction), distance,
          hints);
    glm::vec3 lamp(subject.toWorld(lightPlace(subject, look, glance, tracer)));
    if (lamp == result.camera.target) lamp = result.camera.eye; // a point far from the origin
    result.light = lightFor(result.camera, lamp, distance);
    return result;
}

} // namespace dirt
