#include "core/frame/auto_camera.h"

#include "core/frame/viewpoints.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace dirt {

namespace {

constexpr int kColumns = 12, kRows = 6; ///< rays of one coarse image
constexpr size_t kRays = kColumns * kRows;

// What makes a place worth standing at, and a view worth looking at. Taste, tried on interiors,
// outdoor scenes, foliage and single objects; only the picture that opens depends on them.
constexpr double kLeastHits = 0.2;    ///< of the rays, in every direction from an inside place
constexpr double kMostBehind = 0.6;   ///< of the hits, on the back of triangles: in a solid
constexpr double kStandingRoom = 0.1; ///< 10 % quantile of distances, of the scene's height
constexpr double kComfortable = 1.0;  ///< distance at which a hit counts a quarter, of the height

constexpr double kFromOutside = 0.5; ///< what such a view counts: of a room it shows the shell

/// What the rays of one coarse image found.
struct Glance {
    size_t hits = 0, behind = 0;
    std::vector<double> depths;        ///< distances of the hits; world space
    std::vector<glm::dvec3> alongAxis; ///< of each: column, row, and its depth along the view

    void add(const Glance& other) {
        hits += other.hits;
        behind += other.behind;
        depths.insert(depths.end(), other.depths.begin(), other.depths.end());
        alongAxis.insert(alongAxis.end(), other.alongAxis.begin(), other.alongAxis.end());
    }
    double quantile(double q) const {
        std::vector<double> sorted = depths;
        const auto nth = sorted.begin() + (std::ptrdiff_t)(q * (double) (sorted.size() - 1));
        std::nth_element(sorted.begin(), nth, sorted.end());
        return *nth;
    }
};

Glance glanceOf(std::span<const Ray> rays, std::span<const Hit> hits, glm::dvec3 direction,
                const FrameGeometry& geometry) {
    Glance glance;
    for (size_t i = 0; i < rays.size(); ++i) {
        if (!hits[i].found()) continue;
        const Triangle& t = geometry.triangles[hits[i].primitive];
        const glm::vec3 normal = glm::cross(t.b - t.a, t.c - t.a);
        ++glance.hits;
        if (glm::dot(normal, rays[i].direction) > 0.0f) ++glance.behind;
        const double depth = hits[i].t / (double) geometry.frame.scale;
        glance.depths.push_back(depth);
        glance.alongAxis.push_back({(double) (i % kColumns), (double) (i / kColumns),
                                    depth * glm::dot(glm::dvec3(rays[i].direction), direction)});
    }
    return glance;
}

/// How far a hit's depth counts, by its distance relative to the scene's height.
double weightOf(double relative) {
    const double half = relative / (relative + kComfortable);
    return half * half;
}

/// How far the hits' depths are, in octaves, from those of the one plane that fits them best: a
/// wall seen at a slant is no view, however deep it goes. Of a plane 1 / depth is linear in the
/// image; the fit is by relative differences, each with its weight.
double spreadBesidePlane(const Glance& glance, std::span<const double> weights) {
    glm::dmat3 products(0.0);
    glm::dvec3 sums(0.0);
    double all = 0.0;
    for (size_t i = 0; i < weights.size(); ++i) {
        const glm::dvec3& p = glance.alongAxis[i];
        const glm::dvec3 row = glm::dvec3(p.x, p.y, 1.0) * p.z;
        products += glm::outerProduct(row, row) * weights[i];
        sums += row * weights[i];
        all += weights[i];
    }
    // So that few hits, or those of one line, have a plane, too.
    const double trace = products[0][0] + products[1][1] + products[2][2];
    for (int i = 0; i < 3; ++i) products[i][i] += 1e-9 * trace;
    const glm::dvec3 plane = glm::inverse(products) * sums;
    double squares = 0.0;
    for (size_t i = 0; i < weights.size(); ++i) {
        const glm::dvec3& p = glance.alongAxis[i];
        const double ratio = p.z * (plane.x * p.x + plane.y * p.y + plane.z);
        const double octaves = std::log2(std::clamp(ratio, 1.0 / 16.0, 16.0));
        squares += weights[i] * octaves * octaves;
    }
    return std::sqrt(squares / all);
}

/// Fraction of rays that hit, near ones for less, times the spread of their depth in octaves, as
/// far as one plane does not explain it.
double scoreOf(const Glance& glance, double height) {
    std::vector<double> weights;
    double seen = 0.0, sum = 0.0, squares = 0.0;
    for (double depth : glance.depths) {
        const double relative = std::max(depth / height, 1e-6);
        const double weight = weightOf(relative), octaves = std::log2(relative);
        weights.push_back(weight);
        seen += weight;
        sum += weight * octaves;
        squares += weight * octaves * octaves;
    }
    if (seen == 0.0) return 0.0;
    const double mean = sum / seen;
    const double spread = std::min(std::sqrt(std::max(0.0, squares / seen - mean * mean)),
                                   spreadBesidePlane(glance, weights));
    const double front = 1.0 - (double) glance.behind / (double) glance.hits;
    return seen / (double) kRays * front * (0.5 + spread);
}

/// Whether one can stand at an inside place, given what is seen from it in each direction.
bool isInhabitable(std::span<const Glance> glances, double height) {
    Glance all;
    for (const Glance& glance : glances) {
        if ((double) glance.hits < kLeastHits * (double) kRays) return false;
        all.add(glance);
    }
    return (double) all.behind < kMostBehind * (double) all.hits &&
           all.quantile(0.1) > kStandingRoom * height;
}

/// Rays through a coarse image, in the grid frame.
void appendRays(const Viewpoint& place, glm::dvec3 direction, const CameraHints& hints,
                const GridFrame& frame, std::vector<Ray>& rays) {
    const glm::dvec3 right = glm::normalize(glm::cross(direction, glm::dvec3(hints.up)));
    const glm::dvec3 up = glm::cross(right, direction);
    const double tall = std::tan(hints.verticalFov * std::numbers::pi / 360.0);
    const double wide = tall * hints.aspect;
    for (int row = 0; row < kRows; ++row)
        for (int column = 0; column < kColumns; ++column) {
            const double x = wide * ((2 * column + 1) / (double) kColumns - 1.0);
            const double y = tall * (1.0 - (2 * row + 1) / (double) kRows);
            const glm::dvec3 d = glm::normalize(direction + x * right + y * up);
            Ray ray;
            ray.origin = frame.toGrid(glm::vec3(place.eye));
            ray.direction = frame.directionToGrid(glm::vec3(d));
            rays.push_back(ray);
        }
}

/// A light beside and above the eye that brings white paint at \p distance to a radiance of a
/// third: with the background's, and what is nearer, it stays below white.
Spotlight lightFor(const Camera& camera, double distance) {
    const CameraBasis basis = cameraBasis(camera);
    Spotlight light;
    light.position = camera.eye + (float) (0.1 * distance) * (basis.right - basis.down);
    light.target = camera.target;
    light.aperture = 160.0f;
    light.penumbra = 120.0f;
    // Irradiance at the distance d is flux / (2 pi (1 - cos 80 degrees)) / d^2; white paint turns
    // it into radiance by 1 / pi.
    light.flux =
        (float) (2.0 / 3.0 * std::numbers::pi * (1.0 - std::cos(80.0 * std::numbers::pi / 180)) *
                 std::numbers::pi * distance * distance);
    return light;
}

} // namespace

Standpoint chooseStandpoint(const Mesh& mesh, Tracer& tracer, const CameraHints& hints) {
    const SceneExtent extent = extentOf(mesh, hints.up);
    const std::vector<Viewpoint> places = viewpoints(extent, hints);

    // One structure, around the middle of the box, serves the rays of all places.
    Camera middle;
    middle.eye = glm::vec3(extent.world(extent.centre()));
    middle.target = middle.eye + glm::vec3(extent.forward);
    middle.up = hints.up;
    const FrameGeometry geometry = makeFrameGeometry(mesh, middle, ViewMode::full);
    GridSettings settings;
    settings.width = settings.height = settings.viewSize = 512;
    tracer.build(geometry, middle, settings);

    std::vector<Ray> rays;
    for (const Viewpoint& place : places)
        for (glm::dvec3 direction : place.directions)
            appendRays(place, direction, hints, geometry.frame, rays);
    std::vector<Hit> hits(rays.size());
    tracer.intersect(rays, hits);

    const double height = std::max(extent.least(), 1e-30);
    glm::dvec3 eye = places.back().eye, direction = places.back().directions.back();
    double best = 0.0, distance = glm::length(extent.world(extent.centre()) - eye);
    size_t first = 0;
    for (const Viewpoint& place : places) {
        std::vector<Glance> glances;
        for (size_t i = 0; i < place.directions.size(); ++i, first += kRays)
            glances.push_back(glanceOf(std::span(rays).subspan(first, kRays),
                                       std::span(hits).subspan(first, kRays), place.directions[i],
                                       geometry));
        if (place.inside && !isInhabitable(glances, height)) continue;
        for (size_t i = 0; i < glances.size(); ++i) {
            const double score = scoreOf(glances[i], height) * (place.inside ? 1.0 : kFromOutside);
            if (score <= best) continue;
            best = score;
            eye = place.eye;
            direction = place.directions[i];
            distance = glances[i].quantile(0.5);
        }
    }

    Standpoint result;
    result.camera.eye = glm::vec3(eye);
    result.camera.target = hints.target.value_or(glm::vec3(eye + distance * direction));
    result.camera.up = hints.up;
    result.camera.verticalFov = hints.verticalFov;
    result.light = lightFor(result.camera, distance);
    return result;
}

} // namespace dirt
