// How a surface scatters light: a diffuse lobe under a microfacet lobe with Schlick's Fresnel.
// Directions point away from the surface and have unit length. The functions of the local frame
// have the shading normal at (0, 0, 1).
//
//   f(v, l) = Kd (1 - metallic) / pi (1 - F(n.v)) (1 - F(n.l)) + F(h.v) D(h) G2(v, l) / (4 n.v n.l)
//   F(c) = F0 + (1 - F0)(1 - c)^5, F0 = reflectance mix(1, Kd, metallic)
//
// A surface whose reflectance is 0 has no microfacet lobe at all: it is Lambert's, and F is 0.
#ifndef DIRT_SHARED_BSDF_H
#define DIRT_SHARED_BSDF_H

#include "shaders/shared/microfacet.h"

DIRT_SHARED_BEGIN

/// Surfaces of less roughness are mirrors, whose lobe is a single direction: no light sample finds
/// it. A half vector formed from two directions of float components is off by up to 2^-22, and D
/// relatively by 2 (tan / alpha) 2^-22 / alpha: below 2^-10 where tan is up to 4 alpha.
const float kMirrorRoughness = 0.001953125f; // 2^-9

/// What scatters at a point.
struct Lobes {
    vec3 diffuse;      // Kd (1 - metallic)
    float reflectance; // 0: no microfacets
    vec3 specular;     // F0
    float roughness;   // the microfacets' alpha
    uint model;
};

DIRT_FUNCTION Lobes makeLobes(vec3 kd, float reflectance, float metallic, float roughness,
                              uint model) {
    Lobes lobes;
    DIRT_PRECISE float dielectric = 1.0f - metallic;
    DIRT_PRECISE vec3 diffuse = kd * dielectric;
    DIRT_PRECISE vec3 specular = (kd * metallic + vec3(dielectric)) * reflectance;
    lobes.diffuse = diffuse;
    lobes.reflectance = reflectance;
    lobes.specular =
        vec3(leastOf(specular.x, 1.0f), leastOf(specular.y, 1.0f), leastOf(specular.z, 1.0f));
    lobes.roughness = roughness;
    lobes.model = model;
    return lobes;
}

DIRT_FUNCTION vec3 fresnel(Lobes lobes, float cosine) {
    if (!(lobes.reflectance > 0.0f)) return vec3(0.0f);
    DIRT_PRECISE float w = largestOf(1.0f - cosine, 0.0f);
    DIRT_PRECISE float w2 = w * w;
    DIRT_PRECISE float w5 = w2 * w2 * w;
    DIRT_PRECISE vec3 f = lobes.specular + (vec3(1.0f) - lobes.specular) * w5;
    return f;
}

DIRT_FUNCTION bool isMirror(Lobes lobes) {
    return lobes.roughness < kMirrorRoughness;
}

/// With which probability a direction is chosen by the microfacets: in the proportion of what the
/// lobes would reflect of a light from everywhere, or nearly so.
DIRT_FUNCTION float specularChance(Lobes lobes, float cosine) {
    if (!(lobes.reflectance > 0.0f)) return 0.0f;
    vec3 f = fresnel(lobes, cosine);
    DIRT_PRECISE vec3 rest = lobes.diffuse * (vec3(1.0f) - f);
    float specular = largestOf(f.x, largestOf(f.y, f.z));
    float diffuse = largestOf(rest.x, largestOf(rest.y, rest.z));
    if (!(diffuse > 0.0f)) return 1.0f;
    DIRT_PRECISE float chance = specular / (specular + diffuse);
    return chance;
}

DIRT_FUNCTION vec3 diffuseTimesCosine(Lobes lobes, vec3 v, vec3 l) {
    vec3 atV = fresnel(lobes, v.z);
    vec3 atL = fresnel(lobes, l.z);
    DIRT_PRECISE vec3 through = (vec3(1.0f) - atV) * (vec3(1.0f) - atL);
    DIRT_PRECISE vec3 f = lobes.diffuse * through * (kOneOverPi * l.z);
    return f;
}

/// D / (4 n.v), to which both f cos and the density of directions are proportional.
DIRT_FUNCTION float facetFactor(Lobes lobes, vec3 v, vec3 m) {
    DIRT_PRECISE float factor = facetDensity(lobes.model, lobes.roughness, m) / (4.0f * v.z);
    return factor;
}

DIRT_FUNCTION vec3 specularTimesCosine(Lobes lobes, vec3 v, vec3 l, vec3 m) {
    float open = facetMaskingShadowing(lobes.model, lobes.roughness, v, l, m);
    DIRT_PRECISE vec3 f = fresnel(lobes, dotProduct(v, m)) * (open * facetFactor(lobes, v, m));
    return f;
}

DIRT_FUNCTION float specularPdf(Lobes lobes, vec3 v, vec3 m) {
    float seen = facetMasking(lobes.model, lobes.roughness, v, m);
    DIRT_PRECISE float pdf = seen * facetFactor(lobes, v, m);
    return pdf;
}

/// f(v, l) l.z in the local frame, for v.z > 0 and l.z > 0; without a mirror's lobe.
DIRT_FUNCTION vec3 bsdfTimesCosine(Lobes lobes, vec3 v, vec3 l) {
    vec3 f = diffuseTimesCosine(lobes, v, l);
    if (!(lobes.reflectance > 0.0f) || isMirror(lobes)) return f;
    DIRT_PRECISE vec3 both = v + l;
    DIRT_PRECISE vec3 sum = f + specularTimesCosine(lobes, v, l, unitVector(both));
    return sum;
}

/// The density with which sampleBsdf chooses l; without a mirror's direction.
DIRT_FUNCTION float bsdfPdf(Lobes lobes, vec3 v, vec3 l) {
    float chance = specularChance(lobes, v.z);
    DIRT_PRECISE float pdf = (1.0f - chance) * (kOneOverPi * l.z);
    if (!(chance > 0.0f) || isMirror(lobes)) return pdf;
    DIRT_PRECISE vec3 both = v + l;
    DIRT_PRECISE float sum = pdf + chance * specularPdf(lobes, v, unitVector(both));
    return sum;
}

/// Nothing: the light is absorbed.
DIRT_FUNCTION Scattering noScattering() {
    Scattering none;
    none.direction = vec3(0.0f);
    none.pdf = 0.0f;
    none.weight = vec3(0.0f);
    return none;
}

/// f cos over the density of both lobes, where the facet between \p v and \p l is known.
DIRT_FUNCTION Scattering scatteringTo(Lobes lobes, vec3 v, vec3 l, vec3 m) {
    float chance = specularChance(lobes, v.z);
    DIRT_PRECISE float pdf = (1.0f - chance) * (kOneOverPi * l.z);
    DIRT_PRECISE vec3 f = diffuseTimesCosine(lobes, v, l);
    if (chance > 0.0f && !isMirror(lobes)) {
        pdf = pdf + chance * specularPdf(lobes, v, m);
        f = f + specularTimesCosine(lobes, v, l, m);
    }
    if (!(pdf > 0.0f)) return noScattering();
    DIRT_PRECISE vec3 weight = f / pdf;
    Scattering result;
    result.direction = l;
    result.pdf = pdf;
    result.weight = weight;
    return result;
}

/// A direction from which light comes that is seen from \p v, in the local frame, v.z > 0. \p lobe
/// chooses between the lobes, \p u1 to \p u3 the direction; all in [0, 1). The density of a
/// mirror's direction, which has none, is 0.
DIRT_FUNCTION Scattering sampleBsdf(Lobes lobes, vec3 v, float lobe, float u1, float u2, float u3) {
    float chance = specularChance(lobes, v.z);
    if (!(lobe < chance)) {
        vec3 diffuse = cosineHemisphere(u1, u2);
        DIRT_PRECISE vec3 both = v + diffuse;
        return scatteringTo(lobes, v, diffuse, unitVector(both));
    }
    if (isMirror(lobes)) {
        DIRT_PRECISE vec3 weight = fresnel(lobes, v.z) / chance;
        Scattering mirrored;
        mirrored.direction = vec3(-v.x, -v.y, v.z);
        mirrored.pdf = 0.0f;
        mirrored.weight = weight;
        return mirrored;
    }
    vec3 m = visibleNormal(lobes.model, lobes.roughness, v, u1, u2, u3);
    DIRT_PRECISE float twice = 2.0f * dotProduct(v, m);
    DIRT_PRECISE vec3 l = m * twice - v;
    if (!(twice > 0.0f && l.z > 0.0f)) return noScattering();
    return scatteringTo(lobes, v, l, m);
}

DIRT_SHARED_END

#endif
