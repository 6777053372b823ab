// Distributions of microfacet normals, their masking, and the choice of visible normals. All are
// isotropic and in the frame of the macroscopic normal (0, 0, 1); alpha is the width.
//
// With t = tan^2 of a facet's angle and c its cosine, the densities D over solid angle are
//   beckmann, cooktorrance   exp(-t / alpha^2) / (pi alpha^2 c^4)
//   ggx                      1 / (pi alpha^2 c^4 (1 + t / alpha^2)^2)
//   phong                    c^e / (pi alpha^2), e = 2 / alpha^2 - 2
// beckmann and ggx are masked as E. Heitz has it (Understanding the Masking-Shadowing Function,
// JCGT 3(2), 2014): Smith's function, height-correlated. cooktorrance and phong have the V-cavities
// of R. Cook and K. Torrance and of J. Blinn, which conserve energy with any distribution. In both
// G1 normalizes: the visible facets' projected area is that of the surface, so that
// G1(v, m) D(m) (v . m) / v.z is a density of m.
#ifndef DIRT_SHARED_MICROFACET_H
#define DIRT_SHARED_MICROFACET_H

#include "shaders/shared/error_function.h"
#include "shaders/shared/sampling.h"

DIRT_SHARED_BEGIN

const uint kBeckmann = 0u;
const uint kGgx = 1u;
const uint kCookTorrance = 2u;
const uint kPhong = 3u;

DIRT_FUNCTION float leastOf(float a, float b) {
    return a < b ? a : b;
}
DIRT_FUNCTION float largestOf(float a, float b) {
    return a > b ? a : b;
}

/// D(m) for a unit vector with m.z > 0.
DIRT_FUNCTION float facetDensity(uint model, float alpha, vec3 m) {
    DIRT_PRECISE float c2 = m.z * m.z;
    DIRT_PRECISE float t = (m.x * m.x + m.y * m.y) / c2;
    DIRT_PRECISE float a2 = alpha * alpha;
    DIRT_PRECISE float peak = kOneOverPi / a2;
    DIRT_PRECISE float ratio = t / a2;
    if (model == kGgx) {
        DIRT_PRECISE float root = c2 * (1.0f + ratio);
        DIRT_PRECISE float density = peak / (root * root);
        return density;
    }
    if (model == kPhong) {
        // c^e = (1 + t)^(1 - 1/alpha^2)
        DIRT_PRECISE float exponent = -(logOnePlus(t) / a2);
        DIRT_PRECISE float density = peak * exponential(exponent) / c2;
        return density;
    }
    DIRT_PRECISE float density = peak * exponential(-ratio) / (c2 * c2);
    return density;
}

/// Smith's Lambda of a direction above the surface: G1 = 1 / (1 + Lambda).
DIRT_FUNCTION float smithLambda(uint model, float alpha, vec3 v) {
    DIRT_PRECISE float sine = sqrt(v.x * v.x + v.y * v.y);
    DIRT_PRECISE float slope = alpha * sine / v.z;
    if (model == kGgx) {
        DIRT_PRECISE float lambda = 0.5f * (sqrt(1.0f + slope * slope) - 1.0f);
        return lambda;
    }
    // 1 / slope = a; Lambda = (exp(-a^2) / (a sqrt(pi)) - erfc(a)) / 2, below 1e-12 from a = 5 on.
    if (!(slope > 0.2f)) return 0.0f;
    DIRT_PRECISE float a = 1.0f / slope;
    DIRT_PRECISE float scaled = 0.5641896f * slope - scaledErrorComplement(a);
    DIRT_PRECISE float lambda = 0.5f * exponential(-(a * a)) * scaled;
    return lambda > 0.0f ? lambda : 0.0f;
}

/// The V-cavity's shadow towards \p v: 2 (n . m)(n . v) / (v . m), at most 1.
DIRT_FUNCTION float cavityMasking(vec3 v, vec3 m) {
    DIRT_PRECISE float open = 2.0f * m.z * v.z;
    float cosine = dotProduct(v, m);
    if (!(cosine > 0.0f)) return 0.0f;
    if (!(open < cosine)) return 1.0f;
    DIRT_PRECISE float part = open / cosine;
    return part;
}

DIRT_FUNCTION bool hasCavities(uint model) {
    return model == kCookTorrance || model == kPhong;
}

/// G1: the part of the facets of normal \p m that is seen from \p v.
DIRT_FUNCTION float facetMasking(uint model, float alpha, vec3 v, vec3 m) {
    if (hasCavities(model)) return cavityMasking(v, m);
    DIRT_PRECISE float part = 1.0f / (1.0f + smithLambda(model, alpha, v));
    return part;
}

/// G2: the part that is seen from \p v and from \p l.
DIRT_FUNCTION float facetMaskingShadowing(uint model, float alpha, vec3 v, vec3 l, vec3 m) {
    if (hasCavities(model)) return leastOf(cavityMasking(v, m), cavityMasking(l, m));
    DIRT_PRECISE float lambdas = smithLambda(model, alpha, v) + smithLambda(model, alpha, l);
    DIRT_PRECISE float part = 1.0f / (1.0f + lambdas);
    return part;
}

/// One slope of Beckmann's facets of alpha = 1 that are seen at an angle of cosine \p c and sine
/// \p s, along that direction: density proportional to (c - s x) exp(-x^2) where positive. Inverts
/// the distribution, c sqrt(pi)/2 erfc(-x) + s exp(-x^2)/2, by Newton's method in a bracket. Ten
/// steps leave an error of at most 6e-6 in the distribution, at its end, and far less elsewhere.
DIRT_FUNCTION float visibleSlope(float c, float s, float u) {
    float low = -5.0f;
    float high = 5.0f;
    if (c < high * s) {
        DIRT_PRECISE float end = c / s;
        high = end;
    }
    DIRT_PRECISE float atHigh = exponential(-(high * high));
    DIRT_PRECISE float whole = 0.8862269f * c * errorComplement(-high, atHigh) + 0.5f * s * atHigh;
    DIRT_PRECISE float wanted = u * whole;

    // S. Winitzki's approximation of the inverse error function, moved and narrowed.
    DIRT_PRECISE float z = 2.0f * u - 1.0f;
    DIRT_PRECISE float product = (1.0f - z) * (1.0f + z);
    DIRT_PRECISE float w = -naturalLog(largestOf(product, 1e-7f));
    DIRT_PRECISE float b = 4.3307467f - 0.5f * w;
    DIRT_PRECISE float square = sqrt(b * b + w * 6.8027211f) - b;
    DIRT_PRECISE float gaussian = sqrt(largestOf(square, 0.0f));
    if (z < 0.0f) gaussian = -gaussian;
    DIRT_PRECISE float x = gaussian * (1.0f - 0.35f * s) - 0.75f * s;
    DIRT_PRECISE float middle = 0.5f * (low + high);
    if (!(x > low && x < high)) x = middle;

    for (int i = 0; i < 10; ++i) {
        DIRT_PRECISE float weight = exponential(-(x * x));
        DIRT_PRECISE float below = 0.8862269f * c * errorComplement(-x, weight);
        DIRT_PRECISE float excess = below + 0.5f * s * weight - wanted;
        if (excess > 0.0f)
            high = x;
        else
            low = x;
        DIRT_PRECISE float growth = (c - s * x) * weight;
        DIRT_PRECISE float next = 0.5f * (low + high);
        if (growth > 0.0f) {
            DIRT_PRECISE float newton = x - excess / growth;
            if (newton >= low && newton <= high) next = newton;
        }
        x = next;
    }
    return x;
}

/// A unit vector along (x, y, 1).
DIRT_FUNCTION vec3 normalOfSlopes(float x, float y) {
    DIRT_PRECISE float scale = 1.0f / sqrt(x * x + y * y + 1.0f);
    DIRT_PRECISE vec3 normal = vec3(x * scale, y * scale, scale);
    return normal;
}

DIRT_FUNCTION vec3 visibleBeckmann(float alpha, vec3 v, float u1, float u2, float u3) {
    DIRT_PRECISE float lateral = sqrt(v.x * v.x + v.y * v.y);
    DIRT_PRECISE float stretched = alpha * lateral;
    DIRT_PRECISE float scale = 1.0f / sqrt(stretched * stretched + v.z * v.z);
    DIRT_PRECISE float c = v.z * scale;
    DIRT_PRECISE float s = stretched * scale;
    DIRT_PRECISE vec2 towards = vec2(1.0f, 0.0f);
    if (lateral > 0.0f) towards = vec2(v.x / lateral, v.y / lateral);
    float along = visibleSlope(c, s, u1);
    // Across, a Gaussian of variance 1/2: one coordinate of a Box-Muller pair.
    float sine;
    float cosine;
    sinCosTwoPi(u3, sine, cosine);
    DIRT_PRECISE float across = sqrt(-naturalLog(1.0f - u2)) * cosine;
    DIRT_PRECISE float x = -alpha * (along * towards.x - across * towards.y);
    DIRT_PRECISE float y = -alpha * (along * towards.y + across * towards.x);
    return normalOfSlopes(x, y);
}

/// E. Heitz, Sampling the GGX Distribution of Visible Normals, JCGT 7(4), 2018.
DIRT_FUNCTION vec3 visibleGgx(float alpha, vec3 v, float u1, float u2) {
    DIRT_PRECISE vec3 stretched = vec3(alpha * v.x, alpha * v.y, v.z);
    vec3 w = unitVector(stretched);
    DIRT_PRECISE float lateral = sqrt(w.x * w.x + w.y * w.y);
    DIRT_PRECISE vec2 side = vec2(1.0f, 0.0f);
    if (lateral > 0.0f) side = vec2(-(w.y / lateral), w.x / lateral);
    // (side, 0) and w × (side, 0) span the disc; its far half is seen foreshortened.
    float sine;
    float cosine;
    sinCosTwoPi(u2, sine, cosine);
    DIRT_PRECISE float radius = sqrt(u1);
    DIRT_PRECISE float p = radius * cosine;
    DIRT_PRECISE float seen = 0.5f * (1.0f + w.z);
    DIRT_PRECISE float rim = sqrt(largestOf(1.0f - p * p, 0.0f));
    DIRT_PRECISE float q = (1.0f - seen) * rim + seen * (radius * sine);
    DIRT_PRECISE float r = sqrt(largestOf(1.0f - p * p - q * q, 0.0f));
    DIRT_PRECISE float x = p * side.x - q * w.z * side.y + r * w.x;
    DIRT_PRECISE float y = p * side.y + q * w.z * side.x + r * w.y;
    DIRT_PRECISE float z = q * (w.x * side.y - w.y * side.x) + r * w.z;
    if (!(z > 0.0f)) return vec3(0.0f);
    DIRT_PRECISE vec3 normal = vec3(alpha * x, alpha * y, z);
    return unitVector(normal);
}

/// A facet of the whole surface, seen or not, of density D(m) m.z; of the two that make its
/// cavity, the one that \p v sees, or either in the proportion in which it sees them.
DIRT_FUNCTION vec3 visibleInCavity(uint model, float alpha, vec3 v, float u1, float u2, float u3) {
    DIRT_PRECISE float t = -(alpha * alpha * naturalLog(1.0f - u1));
    if (model == kPhong) t = exponentialMinusOne(t);
    float sine;
    float cosine;
    sinCosTwoPi(u2, sine, cosine);
    DIRT_PRECISE float slope = sqrt(t);
    vec3 m = normalOfSlopes(slope * cosine, slope * sine);
    vec3 opposite = vec3(-m.x, -m.y, m.z);
    float seen = largestOf(dotProduct(v, m), 0.0f);
    float other = largestOf(dotProduct(v, opposite), 0.0f);
    DIRT_PRECISE float threshold = u3 * (seen + other);
    return threshold < seen ? m : opposite;
}

/// A facet's normal as seen from the unit vector \p v, v.z > 0, of density G1 D (v . m) / v.z; from
/// three numbers of [0, 1). Zero where rounding leaves none.
DIRT_FUNCTION vec3 visibleNormal(uint model, float alpha, vec3 v, float u1, float u2, float u3) {
    if (hasCavities(model)) return visibleInCavity(model, alpha, v, u1, u2, u3);
    if (model == kGgx) return visibleGgx(alpha, v, u1, u2);
    return visibleBeckmann(alpha, v, u1, u2, u3);
}

DIRT_SHARED_END

#endif
