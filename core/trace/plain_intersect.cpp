#include "core/trace/plain_intersect.h"

#include "core/base/denormals.h"

#include <cfloat>
#include <cmath>

namespace dirt {

bool plainIntersect(const Ray& ray, const Triangle& triangle, TriangleHit& out) {
    const glm::vec3& o = ray.origin;
    const glm::vec3& d = ray.direction;
    const float dx = std::abs(d.x), dy = std::abs(d.y), dz = std::abs(d.z);
    const int z = dx > dy ? (dx > dz ? 0 : 2) : (dy > dz ? 1 : 2);
    const int x = (z + 1) % 3, y = (z + 2) % 3;
    const float slopeX = d[x] / d[z], slopeY = d[y] / d[z];

    const glm::vec3 a = triangle.a - o, b = triangle.b - o, c = triangle.c - o;
    const float ax = a[x] - slopeX * a[z], ay = a[y] - slopeY * a[z];
    const float bx = b[x] - slopeX * b[z], by = b[y] - slopeY * b[z];
    const float cx = c[x] - slopeX * c[z], cy = c[y] - slopeY * c[z];
    const float u = bx * cy - by * cx;
    const float v = cx * ay - cy * ax;
    const float w = ax * by - ay * bx;
    if ((u < 0.0f || v < 0.0f || w < 0.0f) && (u > 0.0f || v > 0.0f || w > 0.0f)) return false;
    const float sum = u + v + w;
    if (sum == 0.0f) return false;
    const float t = (u * a[z] + v * b[z] + w * c[z]) / (sum * d[z]);
    if (!(t >= 0.0f && t <= FLT_MAX)) return false;
    out.t = flushed(t);
    out.u = flushed(v / sum);
    out.v = flushed(w / sum);
    return true;
}

} // namespace dirt
