// planeSide and directionSide of core/trace/determinant.h in GLSL.

#include "include/intersect.glsl"

/// Sign of v . (x × y), or 0 where double leaves it in doubt.
int certainSign(dvec3 v, dvec3 x, dvec3 y) {
    double value = dotProduct64(v, crossProduct(x, y));
    precise double bound = kEdgeError * oneNorm(v) * maxNorm(x) * maxNorm(y);
    return abs(value) > bound ? signOf(value) : 0;
}

/// Exact sign: the side of the triangle's plane on which p lies.
int planeSide(vec3 p, Triangle t) {
    dvec3 a = dvec3(t.a);
    precise dvec3 ap = dvec3(p) - a, ab = dvec3(t.b) - a, ac = dvec3(t.c) - a;
    int side = certainSign(ap, ab, ac);
    return side != 0 ? side : signOf(planeDeterminantExact(p, t.a, t.b, t.c));
}

/// The same for a direction.
int directionSide(vec3 d, Triangle t) {
    dvec3 a = dvec3(t.a);
    precise dvec3 ab = dvec3(t.b) - a, ac = dvec3(t.c) - a;
    int side = certainSign(dvec3(d), ab, ac);
    return side != 0 ? side : signOf(directionDeterminantExact(d, t.a, t.b, t.c));
}
