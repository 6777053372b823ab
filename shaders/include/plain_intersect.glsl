// core/trace/plain_intersect.h in GLSL, where a ray's part is done once: the float test of
// --precision fast.

#include "include/rays.glsl"
#include "include/triangles.glsl"
#include "shared/rounding.h"

/// Brings points to where the ray runs along one axis: its products with a point relative to the
/// ray's origin are the two coordinates beside the ray, and t.
struct Shear {
    vec3 x, y, t;
};

Shear shearOf(Ray ray) {
    vec3 d = ray.direction, size = abs(d);
    vec3 z = size.x > size.y ? (size.x > size.z ? vec3(1, 0, 0) : vec3(0, 0, 1))
                             : (size.y > size.z ? vec3(0, 1, 0) : vec3(0, 0, 1));
    vec3 x = z.zxy, y = z.yzx;
    float depth = dot(d, z);
    return Shear(x - dot(d, x) / depth * z, y - dot(d, y) / depth * z, z / depth);
}

bool plainIntersect(Shear shear, vec3 origin, Triangle triangle, out TriangleHit hit) {
    hit = TriangleHit(0.0, 0.0, 0.0);
    mat3 corners = mat3(triangle.a - origin, triangle.b - origin, triangle.c - origin);
    precise vec3 x = shear.x * corners, y = shear.y * corners;
    precise vec3 edges = x.yzx * y.zxy - y.yzx * x.zxy;
    if (any(lessThan(edges, vec3(0.0))) && any(greaterThan(edges, vec3(0.0)))) return false;
    precise float sum = edges.x + edges.y + edges.z;
    if (sum == 0.0) return false;
    precise float t = dot(edges, shear.t * corners) / sum;
    if (!(t >= 0.0 && t <= kLargest)) return false;
    hit = TriangleHit(flushed(t), flushed(edges.y / sum), flushed(edges.z / sum));
    return true;
}
