// core/trace/intersect.h in GLSL: whether a ray hits a triangle, decided exactly, by the same
// operations in the same order. The bounds are derived there and in ray_filter.h.

#include "include/arithmetic.glsl"
#include "include/determinants.glsl"
#include "include/rays.glsl"
#include "include/triangles.glsl"
#include "shared/margins.h"

dvec3 crossProduct(dvec3 a, dvec3 b) {
    precise dvec3 n = dvec3(a.y * b.z - b.y * a.z, a.z * b.x - b.z * a.x, a.x * b.y - b.x * a.y);
    return n;
}

double dotProduct64(dvec3 a, dvec3 b) {
    precise dvec3 terms = a * b;
    precise double sum = terms.x + terms.y + terms.z;
    return sum;
}

double maxNorm(dvec3 v) {
    return max(max(abs(v.x), abs(v.y)), abs(v.z));
}

double oneNorm(dvec3 v) {
    precise double sum = abs(v.x) + abs(v.y) + abs(v.z);
    return sum;
}

// ------------------------------------------------------------------- RayFilter, in float

struct RayFilter {
    ivec3 axes; // z: that of the direction's largest component
    vec2 slope;
    float lateralError;
};

RayFilter makeFilter(Ray ray) {
    vec3 d = abs(ray.direction);
    RayFilter sieve;
    int z = d.x > d.y ? (d.x > d.z ? 0 : 2) : (d.y > d.z ? 1 : 2);
    sieve.axes = ivec3((z + 1) % 3, (z + 2) % 3, z);
    // Division may be off by 2.5 ulp (GLSL) rather than by 0.5: 4 u N more in the shear, which makes
    // core's 30 u N L below 48; so the bound takes 16 u N where core takes 8.
    sieve.slope = vec2(ray.direction[sieve.axes.x], ray.direction[sieve.axes.y]) /
                   ray.direction[z];
    vec3 o = abs(ray.origin);
    float distance = 2.0 + max(max(o.x, o.y), o.z);
    sieve.lateralError = distance < 1.0e12 ? distance * (2.0 * kLateralError) : 3.0e38;
    return sieve;
}

bool sameSide(vec3 x, float error) {
    return min(min(x.x, x.y), x.z) > error || max(max(x.x, x.y), x.z) < -error;
}

/// True only if the exact line does not meet the closed triangle.
bool certainlyMisses(RayFilter sieve, Ray ray, Triangle triangle) {
    vec3 a = triangle.a - ray.origin, b = triangle.b - ray.origin, c = triangle.c - ray.origin;
    ivec3 i = sieve.axes;
    vec3 depth = vec3(a[i.z], b[i.z], c[i.z]);
    precise vec3 x = vec3(a[i.x], b[i.x], c[i.x]) - sieve.slope.x * depth;
    if (sameSide(x, sieve.lateralError)) return true;
    precise vec3 y = vec3(a[i.y], b[i.y], c[i.y]) - sieve.slope.y * depth;
    if (sameSide(y, sieve.lateralError)) return true;
    precise vec3 edges = x.yzx * y.zxy - y.yzx * x.zxy;
    vec3 size = max(abs(x), abs(y));
    float largest = max(max(size.x, size.y), size.z);
    float error = largest * (4.0 * sieve.lateralError);
    return max(max(edges.x, edges.y), edges.z) > error &&
           min(min(edges.x, edges.y), edges.z) < -error;
}

// ------------------------------------------------------------------- the decision, in double

/// Determinants that double may leave in doubt: the edges' (weights of a, b and c), numerator and
/// denominator of t.
const int kNumerator = 3, kDenominator = 4;
const uint kEdges = 7u;

double determinantExact(int which, Ray ray, vec3 corners[3]) {
    TripleProducts sum;
    if (which == kNumerator)
        setPlaneDeterminant(sum, ray.origin, corners[0], corners[1], corners[2]);
    else if (which == kDenominator)
        setDirectionDeterminant(sum, ray.direction, corners[0], corners[1], corners[2]);
    else
        setEdgeDeterminant(sum, ray.origin, ray.direction, corners[(which + 1) % 3],
                           corners[(which + 2) % 3]);
    double value = exactValue(sum);
    return which == kNumerator ? -value : value;
}

/// Whether the exact ray (t >= 0) meets the closed triangle, which of a ray from the eye must not
/// hold the eye. Does not look at ray.skip.
/// As all lanes wait for the one that is in doubt, there is one place where they do.
/// \p weights: the edge determinants, with exact signs, hit or not.
bool intersect(Ray ray, Triangle triangle, out TriangleHit hit, out dvec3 weights) {
    hit = TriangleHit(0.0, 0.0, 0.0);
    weights = dvec3(0.0LF);
    if (triangle.a == triangle.b || triangle.b == triangle.c || triangle.c == triangle.a)
        return false;
    vec3 corners[3] = vec3[3](triangle.a, triangle.b, triangle.c);
    dvec3 o = dvec3(ray.origin), d = dvec3(ray.direction);
    double directionNorm = oneNorm(d);

    // Edge determinants. bound: of each one's error.
    dvec3 to[3];
    double norms[3];
    for (int i = 0; i < 3; ++i) {
        precise dvec3 difference = dvec3(corners[i]) - o;
        to[i] = difference;
        norms[i] = maxNorm(difference);
    }
    precise double scale = kEdgeError * directionNorm;
    uint doubtful = 0u;
    double bound = 0.0LF;
    for (int i = 0; i < 3; ++i) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        weights[i] = dotProduct64(d, crossProduct(to[j], to[k]));
        precise double area = norms[j] * norms[k];
        precise double own = scale * norms[j] * norms[k];
        if (abs(weights[i]) <= own) doubtful |= 1u << i;
        bound = max(bound, area);
    }
    bound = scale * bound;

    // Numerator and denominator of t, each with a relative error below 2^-29.
    precise dvec3 ab = dvec3(corners[1]) - dvec3(corners[0]);
    precise dvec3 ac = dvec3(corners[2]) - dvec3(corners[0]);
    precise dvec3 toA = dvec3(corners[0]) - o;
    dvec3 normal = crossProduct(ab, ac);
    double numerator = dotProduct64(normal, toA), denominator = dotProduct64(normal, d);
    precise double area = kPlaneDoubt * maxNorm(ab) * maxNorm(ac);
    uint unsureT = (abs(numerator) <= area * oneNorm(toA) ? 1u << kNumerator : 0u) |
                   (abs(denominator) <= area * directionNorm ? 1u << kDenominator : 0u);

    int known = 0; // 1: the signs of the edges' determinants agree, 2: t is not negative
    do {
        if (doubtful != 0u) {
            int which = findLSB(doubtful);
            doubtful &= doubtful - 1u;
            double value = determinantExact(which, ray, corners);
            if (which == kNumerator)
                numerator = value;
            else if (which == kDenominator)
                denominator = value;
            else
                weights[which] = value;
        }
        if (doubtful == 0u && known == 0) {
            bool positive = weights.x > 0.0LF || weights.y > 0.0LF || weights.z > 0.0LF;
            bool negative = weights.x < 0.0LF || weights.y < 0.0LF || weights.z < 0.0LF;
            if (positive == negative) return false;
            doubtful = unsureT;
            known = 1;
        }
        if (doubtful == 0u && known == 1) {
            if (numerator == 0.0LF && ray.origin == vec3(0.0)) return false; // it holds the eye
            if (numerator != 0.0LF && (numerator < 0.0LF) != (denominator < 0.0LF)) return false;
            precise double sum = weights.x + weights.y + weights.z;
            if (abs(sum) < kSureWeights * bound) doubtful = kEdges;
            known = 2;
        }
    } while (doubtful != 0u);

    precise double quotient = numerator / denominator;
    double t = abs(quotient);
    hit.t = t < double(kSmallestNormal) ? 0.0 : float(min(t, double(kLargest)));
    precise double total = weights.x + weights.y + weights.z;
    precise dvec2 barycentric = weights.yz / total;
    hit.u = flushed(float(barycentric.x));
    hit.v = flushed(float(barycentric.y));
    return true;
}

bool intersect(Ray ray, Triangle triangle, out TriangleHit hit) {
    dvec3 weights;
    return intersect(ray, triangle, hit, weights);
}
