// core/trace/plain_intersect.h in GLSL: the float test of --precision fast.

#include "include/intersect.glsl"

bool plainIntersect(Ray ray, Triangle triangle, out TriangleHit hit) {
    hit = TriangleHit(0.0, 0.0, 0.0);
    vec3 size = abs(ray.direction);
    int z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    int x = (z + 1) % 3, y = (z + 2) % 3;
    precise float slopeX = ray.direction[x] / ray.direction[z];
    precise float slopeY = ray.direction[y] / ray.direction[z];

    precise vec3 a = triangle.a - ray.origin;
    precise vec3 b = triangle.b - ray.origin;
    precise vec3 c = triangle.c - ray.origin;
    precise vec3 xs = vec3(a[x], b[x], c[x]) - slopeX * vec3(a[z], b[z], c[z]);
    precise vec3 ys = vec3(a[y], b[y], c[y]) - slopeY * vec3(a[z], b[z], c[z]);
    precise vec3 edges = xs.yzx * ys.zxy - ys.yzx * xs.zxy;
    if (any(lessThan(edges, vec3(0.0))) && any(greaterThan(edges, vec3(0.0)))) return false;
    precise float sum = edges.x + edges.y + edges.z;
    if (sum == 0.0) return false;
    precise float t =
        (edges.x * a[z] + edges.y * b[z] + edges.z * c[z]) / (sum * ray.direction[z]);
    if (!(t >= 0.0 && t <= kLargest)) return false;
    hit.t = flushed(t);
    precise vec2 weights = edges.yz / sum;
    hit.u = flushed(weights.x);
    hit.v = flushed(weights.y);
    return true;
}
