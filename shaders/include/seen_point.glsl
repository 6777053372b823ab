// What a pixel sees of a triangle that the hardware's rasterizer has given it.

#include "include/intersect.glsl"

/// Whether the eye may lie in the triangle's plane: its determinant is below the error in double
/// (kEdgeError is that of any d . (B x C), here of the corner a).
bool isEdgeOn(Triangle triangle) {
    dvec3 a = dvec3(triangle.a);
    precise dvec3 ab = dvec3(triangle.b) - a;
    precise dvec3 ac = dvec3(triangle.c) - a;
    precise double bound = kEdgeError * oneNorm(a) * maxNorm(ab) * maxNorm(ac);
    return abs(dotProduct64(a, crossProduct(ab, ac))) <= bound;
}

/// Where the ray meets the triangle, by the exact decision. Where it does not, as the rasterizer's
/// pixel is up to 1/128 off, the point of the triangle beside it: outside the edges that it has
/// passed the weights are zero. False where the triangle is edge-on.
bool seenPoint(Ray ray, Triangle triangle, out TriangleHit hit) {
    dvec3 weights;
    if (intersect(ray, triangle, hit, weights)) return true;
    if (isEdgeOn(triangle)) return false;
    precise double sum = weights.x + weights.y + weights.z;
    if (sum < 0.0LF) weights = -weights;
    weights = max(weights, dvec3(0.0LF));
    precise double inside = weights.x + weights.y + weights.z;
    if (!(inside > 0.0LF)) return false;
    precise dvec3 part = weights / inside;
    precise dvec3 point =
        dvec3(triangle.a) * part.x + dvec3(triangle.b) * part.y + dvec3(triangle.c) * part.z;
    dvec3 direction = dvec3(ray.direction);
    precise double t = dotProduct64(point, direction) / dotProduct64(direction, direction);
    if (!(t > 0.0LF)) return false;
    hit = TriangleHit(float(t), flushed(float(part.y)), flushed(float(part.z)));
    return true;
}

/// The pixel's ray as the search would see it.
Ray primaryRay(vec3 direction) {
    for (int i = 0; i < 3; ++i) direction[i] = flushed(direction[i]);
    return Ray(vec3(0.0), direction, kNoPrimitive);
}
