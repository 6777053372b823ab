// The shadow map of a spotlight: what a texel sees, which texels a triangle may cover, and how much
// of the light the map lets through to a point.
#ifndef DIRT_SHARED_SHADOW_MAP_H
#define DIRT_SHARED_SHADOW_MAP_H

#include "shaders/shared/spotlight.h"

DIRT_SHARED_BEGIN

/// A square perspective map around a spotlight's axis, in the grid frame (std140). Texel (0, 0) is
/// at the lowest slopes along right and up.
struct ShadowMap {
    float extent DIRT_DEFAULT(0.0f);   // slope of the frustum's sides
    float step DIRT_DEFAULT(0.0f);     // slope from one texel to the next
    float nearest DIRT_DEFAULT(0.0f);  // depths between which things cast
    float farthest DIRT_DEFAULT(0.0f); //
    float bias DIRT_DEFAULT(0.0f);     // depth by which a caster must be nearer
    float softness DIRT_DEFAULT(0.0f); // width over which a shadow's edge is blurred
    uint resolution DIRT_DEFAULT(0u);  // texels along a side
    uint unused DIRT_DEFAULT(0u);
};

/// Depth of a texel in which nothing casts.
const float kNothingCasts = 3.402823466e+38f;

/// The filter looks at so many cells of texels along a side, and at two that it cuts.
const float kFilterCells = 16.0f;

#ifdef __cplusplus
/// The depths of a map, row by row.
struct ShadowTexels {
    const float* depths = nullptr;
    uint resolution = 0;
};
inline float shadowTexel(ShadowTexels texels, int x, int y) {
    return texels.depths[(size_t) y * texels.resolution + (size_t) x];
}
#else
#define ShadowTexels sampler2D
float shadowTexel(sampler2D texels, int x, int y) {
    return texelFetch(texels, ivec2(x, y), 0).x;
}
#endif

/// Direction of the ray from the light through a texel's centre. Its parameter is the depth along
/// the light's axis.
DIRT_FUNCTION vec3 shadowRayDirection(GridSpotlight light, ShadowMap map, uint x, uint y) {
    DIRT_PRECISE float sx = (float(x) + 0.5f) * map.step - map.extent;
    DIRT_PRECISE float sy = (float(y) + 0.5f) * map.step - map.extent;
    DIRT_PRECISE vec3 direction = light.right * sx + light.up * sy + light.axis;
    return direction;
}

/// Whether what lies at depth \p t casts.
DIRT_FUNCTION bool castsShadow(ShadowMap map, float t) {
    return t > map.nearest && t <= map.farthest;
}

DIRT_FUNCTION double shadowDot(dvec3 a, vec3 b) {
    DIRT_PRECISE double sum = a.x * double(b.x) + a.y * double(b.y) + a.z * double(b.z);
    return sum;
}

/// \p point along the light's right, up and axis.
DIRT_FUNCTION dvec3 asLightSees(GridSpotlight light, vec3 point) {
    DIRT_PRECISE dvec3 p = dvec3(point) - dvec3(light.position);
    return dvec3(shadowDot(p, light.right), shadowDot(p, light.up), shadowDot(p, light.axis));
}

/// First or last texel whose centre has the \p slope, by \p rounding of 0 or 1 downwards or up;
/// beyond the map the one beside it.
DIRT_FUNCTION int shadowTexelAt(ShadowMap map, double slope, int rounding) {
    DIRT_PRECISE double place = (slope + double(map.extent)) / double(map.step) - double(0.5f);
    double most = double(float(map.resolution));
    if (!(place > double(-1.0f))) return -1;
    if (place > most) place = most;
    return rounding == 0 ? int(floor(place)) : -int(floor(-place));
}

/// Texels [x, z] x [y, w] that hold all whose ray may meet the triangle \p a, \p b, \p c. False:
/// there are none.
///
/// With u = 2^-24 and slopes of at most S, a direction of shadowRayDirection is off by less than
/// 16 u (1 + 2 S) a component (its slope by 3 u S, then two roundings), and the light's axes are at
/// right angles to 4 u. So its slopes, measured by asLightSees, differ from the nominal ones by
/// less than 2^-17 (1 + S)^2; what double adds is far below.
DIRT_FUNCTION bool shadowFootprint(GridSpotlight light, ShadowMap map, vec3 a, vec3 b, vec3 c,
                                   DIRT_OUT(ivec4) texels) {
    dvec3 p[3];
    p[0] = asLightSees(light, a);
    p[1] = asLightSees(light, b);
    p[2] = asLightSees(light, c);
    double one = double(1.0f);
    double extent = double(map.extent);
    DIRT_PRECISE double margin = (one + extent) * (one + extent) * double(7.62939453125e-6f);
    DIRT_PRECISE double rim = extent + margin;
    texels = ivec4(0, 0, -1, -1);
    int beyond[5]; // corners beyond the sides of the frustum, and behind the light
    for (int i = 0; i < 5; ++i) beyond[i] = 0;
    dvec3 low = dvec3(rim);   // of the slopes; z is not used
    dvec3 high = dvec3(-rim); //
    bool before = true;       // all corners are clearly before the light
    for (int i = 0; i < 3; ++i) {
        double size = abs(p[i].x) + abs(p[i].y) + abs(p[i].z);
        DIRT_PRECISE double clear = size * double(9.094947017729282e-13f) * (one + extent); // 2^-40
        DIRT_PRECISE double side = p[i].z * rim;
        if (p[i].x - side > clear) ++beyond[0];
        if (-p[i].x - side > clear) ++beyond[1];
        if (p[i].y - side > clear) ++beyond[2];
        if (-p[i].y - side > clear) ++beyond[3];
        if (p[i].z < -clear) ++beyond[4];
        if (!(p[i].z > size * double(9.5367431640625e-7f))) { // 2^-20
            before = false;
            continue;
        }
        DIRT_PRECISE double sx = p[i].x / p[i].z;
        DIRT_PRECISE double sy = p[i].y / p[i].z;
        if (sx < low.x) low.x = sx;
        if (sy < low.y) low.y = sy;
        if (sx > high.x) high.x = sx;
        if (sy > high.y) high.y = sy;
    }
    for (int i = 0; i < 5; ++i)
        if (beyond[i] == 3) return false;
    int last = int(map.resolution) - 1;
    texels = ivec4(0, 0, last, last);
    if (!before) return true; // it may be anywhere
    int x0 = shadowTexelAt(map, low.x - margin, 1), x1 = shadowTexelAt(map, high.x + margin, 0);
    int y0 = shadowTexelAt(map, low.y - margin, 1), y1 = shadowTexelAt(map, high.y + margin, 0);
    texels = ivec4(x0 < 0 ? 0 : x0, y0 < 0 ? 0 : y0, x1 > last ? last : x1, y1 > last ? last : y1);
    return texels.x <= texels.z && texels.y <= texels.w;
}

/// Part of the light that its map lets through to a \p point on a surface of unit \p normal, 0 to
/// 1: percentage-closer filtering over a square that is softness wide at the point's depth, and one
/// texel at least, weighted by area.
///
/// Each texel's depth is compared with that of the point's own plane there, less the bias, so that
/// a plane does not cast on itself however wide the filter is or however much it leans. That plane
/// is taken for less steep where within the filter it would be nearer or farther by half.
DIRT_FUNCTION float openToLight(ShadowTexels texels, GridSpotlight light, ShadowMap map, vec3 point,
                                vec3 normal) {
    DIRT_PRECISE vec3 p = point - light.position;
    float depth = dotProduct(p, light.axis);
    if (!(depth > 0.0f)) return 1.0f; // beside the map, and the cone
    DIRT_PRECISE float inverse = 1.0f / depth;
    DIRT_PRECISE float sx = dotProduct(p, light.right) * inverse;
    DIRT_PRECISE float sy = dotProduct(p, light.up) * inverse;
    if (!(abs(sx) <= map.extent && abs(sy) <= map.extent)) return 1.0f;
    DIRT_PRECISE float x = (sx + map.extent) / map.step; // in texels
    DIRT_PRECISE float y = (sy + map.extent) / map.step;
    DIRT_PRECISE float softness = map.softness * inverse / map.step;
    float width = softness < 1.0f ? 1.0f : softness;
    float most = float(map.resolution);
    if (width > most) width = most;

    // 1 / depth of a plane is linear in the slopes: it changes by n / (n.p) a slope.
    DIRT_PRECISE float nx = dotProduct(normal, light.right) * map.step;
    DIRT_PRECISE float ny = dotProduct(normal, light.up) * map.step;
    float height = dotProduct(normal, p);
    DIRT_PRECISE float change = (abs(nx) + abs(ny)) * (0.5f * width + 1.0f); // within the filter
    DIRT_PRECISE float allowed = 0.5f * inverse * abs(height);
    DIRT_PRECISE float perHeight =
        change > allowed ? (height < 0.0f ? -0.5f : 0.5f) * inverse / change : 1.0f / height;
    DIRT_PRECISE float dx = nx * perHeight;
    DIRT_PRECISE float dy = ny * perHeight;

    int cell = 1 + int(floor(width / kFilterCells)); // texels along a cell
    float size = float(cell);
    DIRT_PRECISE float left = (x - 0.5f * width) / size;
    DIRT_PRECISE float right = (x + 0.5f * width) / size;
    DIRT_PRECISE float low = (y - 0.5f * width) / size;
    DIRT_PRECISE float high = (y + 0.5f * width) / size;
    int last = int(map.resolution) - 1;
    float open = 0.0f;
    float sum = 0.0f;
    for (int j = int(floor(low)); float(j) < high; ++j) {
        int row = j * cell + cell / 2;
        row = row < 0 ? 0 : row > last ? last : row;
        float above = float(j + 1) < high ? float(j + 1) : high;
        float below = float(j) > low ? float(j) : low;
        DIRT_PRECISE float atRow = inverse + (float(row) + 0.5f - y) * dy;
        for (int i = int(floor(left)); float(i) < right; ++i) {
            int column = i * cell + cell / 2;
            column = column < 0 ? 0 : column > last ? last : column;
            float to = float(i + 1) < right ? float(i + 1) : right;
            float from = float(i) > left ? float(i) : left;
            DIRT_PRECISE float weight = (to - from) * (above - below);
            DIRT_PRECISE float plane = atRow + (float(column) + 0.5f - x) * dx; // 1 / its depth
            DIRT_PRECISE float nearer = (shadowTexel(texels, column, row) + map.bias) * plane;
            DIRT_PRECISE float all = sum + weight;
            DIRT_PRECISE float lit = open + weight;
            sum = all;
            if (!(nearer < 1.0f)) open = lit;
        }
    }
    DIRT_PRECISE float part = open / sum;
    return part;
}

DIRT_SHARED_END

#ifdef __cplusplus

namespace dirt {
static_assert(sizeof(ShadowMap) == 32);
} // namespace dirt

#endif

#endif
