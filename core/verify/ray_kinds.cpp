#include "core/verify/ray_kinds.h"

#include "core/base/denormals.h"
#include "core/trace/offset.h"
#include "core/verify/aim.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

namespace dirt {

namespace {

constexpr std::array<std::string_view, kRayKinds.size()> kNames{
    "primary", "diffuse", "vertex", "edge", "axis", "grazing", "plane", "border", "wild"};

/// Unit vectors along and across a triangle, and its normal.
struct TriangleFrame {
    glm::dvec3 along, across, normal;
};

/// None for triangles so thin (a millionth of their edges' product) that double arithmetic would
/// not give the normal to 2^-52 / 1e-6 < 1e-9 rad.
std::optional<TriangleFrame> triangleFrame(const Triangle& t) {
    const glm::dvec3 e1 = glm::dvec3(t.b) - glm::dvec3(t.a), e2 = glm::dvec3(t.c) - glm::dvec3(t.a);
    const glm::dvec3 normal = glm::cross(e1, e2);
    const double area = glm::length(normal);
    if (!(area > 1e-6 * glm::length(e1) * glm::length(e2))) return std::nullopt;
    const glm::dvec3 along = e1 / glm::length(e1), up = normal / area;
    return TriangleFrame{along, glm::cross(up, along), up};
}

glm::dvec3 pointOnTriangle(const Triangle& t, RayRandom& random) {
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
    return glm::dvec3(t.a) * (1.0 - u - v) + glm::dvec3(t.b) * u + glm::dvec3(t.c) * v;
}

Ray towards(glm::vec3 origin, glm::vec3 target) {
    return {origin, target - origin, kNoPrimitive};
}

} // namespace

std::string_view rayKindName(RayKind kind) {
    return kNames[(size_t) kind];
}

std::optional<RayKind> rayKindByName(std::string_view name) {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return (RayKind) (found - kNames.begin());
}

std::string rayKindNames() {
    std::string names;
    for (const std::string_view name : kNames) names.append(names.empty() ? "" : ",").append(name);
    return names;
}

Ray withoutDenormals(Ray ray) {
    for (int i = 0; i < 3; i++) {
        if (flushed(ray.origin[i]) == 0.0f) ray.origin[i] *= 0.0f;
        if (flushed(ray.direction[i]) == 0.0f) ray.direction[i] *= 0.0f;
    }
    return ray;
}

RaySource::RaySource(const FrameGeometry& geometry, const Camera& camera,
                     const GridSettings& settings, uint32_t seed, std::vector<uint32_t> focus)
    : geometry_(geometry), seed_(seed), focus_(std::move(focus)),
      lo_(std::numeric_limits<float>::max()), hi_(-std::numeric_limits<float>::max()),
      views_(makeViews(settings, camera)), basis_(cameraBasis(camera)) {
    for (const Triangle& t : geometry.triangles) {
        lo_ = glm::min(lo_, glm::min(t.a, glm::min(t.b, t.c)));
        hi_ = glm::max(hi_, glm::max(t.a, glm::max(t.b, t.c)));
    }
    if (settings.mode == ViewMode::single) view_ = views_[0];
    tanY_ = std::tan(camera.verticalFov * (std::numbers::pi / 360.0));
    tanX_ = tanY_ * settings.width / settings.height;
}

bool RaySource::inside(glm::vec3 p) const {
    if (!view_) return true;
    // Products of floats are exact in double.
    const double w = p.z;
    return w >= 0.0 && p.x >= view_->s.front() * w && p.x <= view_->s.back() * w &&
           p.y >= view_->t.front() * w && p.y <= view_->t.back() * w;
}

glm::vec3 RaySource::pointInBox(RayRandom& random) const {
    glm::vec3 p;
    for (int i = 0; i < 3; i++)
        p[i] = (float) (lo_[i] + random.uniform() * ((double) hi_[i] - lo_[i]));
    return p;
}

const Triangle& RaySource::anyTriangle(RayRandom& random) const {
    if (!focus_.empty() && random.below(2))
        return geometry_.triangles[focus_[random.below(focus_.size())]];
    return geometry_.triangles[random.below(geometry_.triangles.size())];
}

glm::vec3 RaySource::anyVertex(RayRandom& random) const {
    const Triangle& t = anyTriangle(random);
    const uint32_t corner = random.below(3);
    return corner == 0 ? t.a : corner == 1 ? t.b : t.c;
}

Ray RaySource::primary(uint32_t index) const {
    RayRandom random = this->random(RayKind::primary, index);
    const double x = (2.0 * random.uniform() - 1.0) * tanX_;
    const double y = (2.0 * random.uniform() - 1.0) * tanY_;
    if (view_) { // the grid frame is the camera's
        const float s = std::clamp((float) x, view_->s.front(), view_->s.back());
        const float t = std::clamp((float) y, view_->t.front(), view_->t.back());
        return withoutDenormals({glm::vec3(0.0f), {s, t, 1.0f}, kNoPrimitive});
    }
    const glm::dvec3 direction =
        glm::dvec3(basis_.right) * x + glm::dvec3(basis_.down) * y + glm::dvec3(basis_.forward);
    return withoutDenormals({glm::vec3(0.0f), glm::vec3(direction), kNoPrimitive});
}

std::optional<Ray> RaySource::diffuse(uint32_t index, const Hit& hit) const {
    const Triangle& triangle = geometry_.triangles[hit.primitive];
    auto frame = triangleFrame(triangle);
    if (!frame) return std::nullopt;
    if (glm::dot(frame->normal, glm::dvec3(primary(index).direction)) > 0.0)
        frame->normal = -frame->normal;

    RayRandom random = this->random(RayKind::diffuse, index);
    const double radius2 = random.uniform(), angle = 2.0 * std::numbers::pi * random.uniform();
    const glm::vec3 direction(
        std::sqrt(1.0 - radius2) * frame->normal +
        std::sqrt(radius2) * (std::cos(angle) * frame->along + std::sin(angle) * frame->across));
    return withoutDenormals(
        {offsetOrigin(triangle, hit.u, hit.v, direction), direction, hit.primitive});
}

Ray RaySource::vertex(uint32_t index) const {
    RayRandom random = this->random(RayKind::vertex, index);
    Ray ray;
    for (int attempt = 0; attempt < kTries; attempt++) {
        const glm::vec3 target = anyVertex(random), origin = pointInBox(random);
        std::optional<Ray> exact;
        if (index % 2 == 0) exact = aimAtPoint(origin, target);
        ray = exact ? *exact : towards(origin, target);
        if (inside(ray.origin) && inside(target)) break;
    }
    return withoutDenormals(ray);
}

Ray RaySource::edge(uint32_t index) const {
    RayRandom random = this->random(RayKind::edge, index);
    Ray ray;
    for (int attempt = 0; attempt < kTries; attempt++) {
        const Triangle& triangle = anyTriangle(random);
        const glm::vec3 vertices[3] = {triangle.a, triangle.b, triangle.c};
        const uint32_t first = random.below(3);
        const glm::vec3 a = vertices[first], b = vertices[(first + 1) % 3];
        const glm::vec3 origin = pointInBox(random);
        const double along = random.uniform();
        const glm::vec3 target(glm::dvec3(a) + along * (glm::dvec3(b) - glm::dvec3(a)));

        std::optional<Ray> exact;
        if (index % 2 == 0)
            exact = aimAtEdge(origin, a, b, 1 + (int) random.below(3), 1 + (int) random.below(3));
        ray = exact ? *exact : towards(origin, target);
        if (inside(ray.origin) && inside(target)) break;
    }
    return withoutDenormals(ray);
}

Ray RaySource::axis(uint32_t index) const {
    RayRandom random = this->random(RayKind::axis, index);
    Ray ray;
    const uint32_t direction = random.below(6);
    const int along = (int) direction / 2;
    // Zeros of both signs: they must not matter.
    for (int i = 0; i < 3; i++) ray.direction[i] = random.below(2) ? 0.0f : -0.0f;
    ray.direction[along] = direction % 2 ? -1.0f : 1.0f;
    for (int attempt = 0; attempt < kTries; attempt++) {
        ray.origin = pointInBox(random);
        if (index % 4 == 2) {
            const glm::vec3 target = anyVertex(random);
            ray.origin[(along + 1) % 3] = target[(along + 1) % 3];
            ray.origin[(along + 2) % 3] = target[(along + 2) % 3];
        } else if (index % 4 == 3) {
            for (int i = 0; i < 3; i++) ray.origin[i] = anyVertex(random)[i];
        }
        if (inside(ray.origin)) break;
    }
    return withoutDenormals(ray);
}

Ray RaySource::grazing(uint32_t index) const {
    // A unit direction rounded to float turns by at most 2^-24 rad, a normal errs by 1e-9 rad:
    // together below 1e-7.
    constexpr double kAngle = 1e-4 - 1e-7;
    RayRandom random = this->random(RayKind::grazing, index);
    Ray ray;
    for (int attempt = 0; attempt < kTries; attempt++) {
        const Triangle& triangle = anyTriangle(random);
        const glm::dvec3 target = pointOnTriangle(triangle, random);
        const double turn = 2.0 * std::numbers::pi * random.uniform();
        const double distance = 1.0 + 2.0 * random.uniform();
        // Mostly small angles: the fourth power spreads them over many magnitudes.
        const double tilt = kAngle * std::pow(random.uniform(), 4.0) * (random.below(2) ? 1 : -1);
        const auto frame = triangleFrame(triangle);
        if (!frame) continue;
        const glm::dvec3 inPlane = std::cos(turn) * frame->along + std::sin(turn) * frame->across;
        const glm::dvec3 direction = std::cos(tilt) * inPlane + std::sin(tilt) * frame->normal;
        const double longest = std::max({glm::distance(glm::dvec3(triangle.a), {triangle.b}),
                                         glm::distance(glm::dvec3(triangle.b), {triangle.c}),
                                         glm::distance(glm::dvec3(triangle.c), {triangle.a})});
        ray = {glm::vec3(target - distance * longest * direction), glm::vec3(direction),
               kNoPrimitive};
        if (inside(ray.origin) && inside(glm::vec3(target))) break;
    }
    return withoutDenormals(ray);
}

Ray RaySource::make(RayKind kind, uint32_t index) const {
    switch (kind) {
    case RayKind::primary:
        return primary(index);
    case RayKind::vertex:
        return vertex(index);
    case RayKind::edge:
        return edge(index);
    case RayKind::axis:
        return axis(index);
    case RayKind::grazing:
        return grazing(index);
    case RayKind::plane:
        return plane(index);
    case RayKind::border:
        return border(index);
    case RayKind::wild:
        return wild(index);
    case RayKind::diffuse:
        break;
    }
    return {};
}

} // namespace dirt
