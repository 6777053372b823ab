#include "core/check/adjudicate_visibility.h"

#include "core/path/camera_rays.h"
#include "core/verify/exact.h"

#include <utility>

namespace dirt {
namespace {

/// One over the distance within which a sample is near something, in pixels.
const Dyadic kPerDistance(128.0);

/// Whether sqrt(x^2 + y^2) <= w / 128, for w > 0.
bool isNear(const Dyadic& x, const Dyadic& y, const Dyadic& w) {
    const Dyadic reach = kPerDistance * kPerDistance * (x * x + y * y);
    return w.sign() > 0 && !(w * w < reach);
}

/// The image plane around the sample of a pixel, in pixels: a point of the grid frame is seen at
/// (x, y) / w from the sample if w > 0. The axes are those of the exact ray that the pixel has.
class SamplePlane {
public:
    SamplePlane(const Camera& camera, const GridSettings& settings, glm::vec2 offset,
                size_t pixel) {
        const CameraRays rays(camera, settings.width, settings.height, settings.mode);
        const auto width = (size_t) settings.width;
        ray = rays.through((float) (pixel % width) + offset.x, (float) (pixel / width) + offset.y);
        // Directions are affine in the pixel. Their differences over the whole image, rounded once
        // or twice, give the step of a pixel to some 2^-20: nothing, as a measure of distances.
        const glm::dvec3 corner(rays.through(0.0f, 0.0f).direction);
        const glm::dvec3 right =
            (glm::dvec3(rays.through((float) settings.width, 0.0f).direction) - corner) /
            (double) settings.width;
        const glm::dvec3 down =
            (glm::dvec3(rays.through(0.0f, (float) settings.height).direction) - corner) /
            (double) settings.height;
        centre_ = DyadicVector(glm::dvec3(ray.direction));
        right_ = DyadicVector(right);
        down_ = DyadicVector(down);
        // By Cramer's rule p = x right + y down + w centre, times the determinant.
        toX_ = cross(down_, centre_);
        toY_ = cross(centre_, right_);
        toW_ = cross(right_, down_);
        negative_ = dot(toW_, centre_).sign() < 0;
    }

    struct Point {
        Dyadic x, y, w;
    };
    Point project(glm::vec3 p) const {
        const DyadicVector v{glm::dvec3(p)};
        const Point seen{dot(toX_, v), dot(toY_, v), dot(toW_, v)};
        return negative_ ? Point{-seen.x, -seen.y, -seen.w} : seen;
    }

    /// Whether the line a + x right + y down = 0, for a linear function of directions that is
    /// \p normal . direction, passes near the sample.
    bool isNearZeroOf(const DyadicVector& normal) const {
        const Dyadic value = dot(normal, centre_);
        const Dyadic x = dot(normal, right_), y = dot(normal, down_);
        return !(x * x + y * y < kPerDistance * kPerDistance * value * value);
    }

    Ray ray;

private:
    DyadicVector centre_, right_, down_;
    DyadicVector toX_, toY_, toW_;
    bool negative_;
};

/// Whether what is seen of an edge passes near the sample. At p = a + s (b - a) the square of the
/// distance is at most 1/128^2 where q(s) = 128^2 (x^2 + y^2) - w^2 <= 0. Two sheets of that cone
/// meet in the eye alone, so a parabola q that opens upwards is not above zero on one side of w = 0
/// only; one that opens downwards has its least values at the ends.
bool isNearEdge(const SamplePlane::Point& a, const SamplePlane::Point& b) {
    if (isNear(a.x, a.y, a.w) || isNear(b.x, b.y, b.w)) return true;
    const Dyadic dx = b.x - a.x, dy = b.y - a.y, dw = b.w - a.w;
    const Dyadic scale = kPerDistance * kPerDistance;
    const Dyadic two(2.0);
    const Dyadic square = scale * (dx * dx + dy * dy) - dw * dw;
    const Dyadic linear = two * (scale * (a.x * dx + a.y * dy) - a.w * dw);
    const Dyadic constant = scale * (a.x * a.x + a.y * a.y) - a.w * a.w;
    if (square.sign() <= 0 || linear.sign() >= 0 || !(-linear < two * square)) return false;
    // Least at s = -linear / (2 square), between the ends.
    if ((linear * linear - two * two * square * constant).sign() < 0) return false;
    return (two * square * a.w - linear * dw).sign() > 0;
}

bool isNearAnyEdge(const SamplePlane& plane, const Triangle& triangle) {
    const SamplePlane::Point a = plane.project(triangle.a), b = plane.project(triangle.b),
                             c = plane.project(triangle.c);
    return isNearEdge(a, b) || isNearEdge(b, c) || isNearEdge(c, a);
}

/// Whether two triangles that the sample's ray hits are equally far near the sample. From the eye,
/// a plane n . p = h is hit at t = h / (n . direction); two are at the same t where
/// (h1 n2 - h2 n1) . direction = 0.
bool areTied(const SamplePlane& plane, const Triangle& first, const Triangle& second) {
    if (!intersectExactly(plane.ray, first) || !intersectExactly(plane.ray, second)) return false;
    const auto normalOf = [](const Triangle& t) {
        const DyadicVector a{glm::dvec3(t.a)};
        return cross(DyadicVector(glm::dvec3(t.b)) - a, DyadicVector(glm::dvec3(t.c)) - a);
    };
    const DyadicVector n1 = normalOf(first), n2 = normalOf(second);
    const Dyadic h1 = dot(n1, DyadicVector(glm::dvec3(first.a)));
    const Dyadic h2 = dot(n2, DyadicVector(glm::dvec3(second.a)));
    return plane.isNearZeroOf(
        {h1 * n2.x - h2 * n1.x, h1 * n2.y - h2 * n1.y, h1 * n2.z - h2 * n1.z});
}

} // namespace

VisibilityJudge::VisibilityJudge(const FrameGeometry& geometry, const Camera& camera,
                                 const GridSettings& settings, glm::vec2 offset)
    : geometry_(geometry), camera_(camera), settings_(settings), offset_(offset) {}

bool VisibilityJudge::mayConfuse(size_t pixel, uint32_t a, uint32_t b) const {
    const SamplePlane plane(camera_, settings_, offset_, pixel);
    const size_t count = geometry_.triangles.size();
    for (const uint32_t id : {a, b}) {
        if (id == kNoPrimitive) continue;
        if (id >= count) return false;
        if (isNearAnyEdge(plane, geometry_.triangles[id])) return true;
    }
    return a != kNoPrimitive && b != kNoPrimitive &&
           areTied(plane, geometry_.triangles[a], geometry_.triangles[b]);
}

} // namespace dirt
