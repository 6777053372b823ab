// core/trace/offset.h in GLSL: where a ray that leaves a surface begins, by the same operations.

#include "include/sides.glsl"

/// Normal of a triangle, scaled so that its largest |component| is 1; zero if there is no area.
dvec3 scaledNormal(Triangle t) {
    dvec3 a = dvec3(t.a);
    precise dvec3 ab = dvec3(t.b) - a, ac = dvec3(t.c) - a;
    dvec3 normal = crossProduct(ab, ac);
    // The components' error is below 2^-50 of the norms; a needle's normal is all error.
    precise double needle = kNeedle * maxNorm(ab) * maxNorm(ac);
    if (maxNorm(normal) <= needle)
        for (int i = 0; i < 3; ++i) {
            vec3 axis = vec3(i == 0, i == 1, i == 2);
            normal[i] = directionDeterminantExact(axis, t.a, t.b, t.c);
        }
    double length = maxNorm(normal);
    if (!(length > 0.0LF)) return normal;
    precise dvec3 scaled = normal / length;
    return scaled;
}

/// The surface point at (u, v), beyond its rounding error on the side that the direction points to.
vec3 offsetOrigin(Triangle t, float u, float v, vec3 direction) {
    precise dvec3 point = dvec3(t.a) * (1.0LF - double(u) - double(v)) + dvec3(t.b) * double(u) +
                          dvec3(t.c) * double(v);
    dvec3 normal = scaledNormal(t);
    if (normal == dvec3(0.0LF)) return vec3(point);

    int side = directionSide(direction, t) < 0 ? -1 : 1;
    normal *= double(side);
    precise double size = kOffsetStep * oneNorm(point);
    double distance = max(size, double(7.52316384526264e-37)); // 2^-120: beside the origin
    for (int i = 0; i < 64; ++i) {
        precise dvec3 moved = point + normal * distance;
        vec3 origin = vec3(moved);
        if (planeSide(origin, t) == side) return origin;
        distance *= 2.0LF;
    }
    return vec3(point);
}
