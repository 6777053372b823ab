// Every margin of grid, rays and light grid, once: what rounding may cost, with room. Where one is
// derived stands beside it; what is lost without it, docs/testing.md says.
#ifndef DIRT_SHARED_MARGINS_H
#define DIRT_SHARED_MARGINS_H

#include "shaders/shared/language.h"

// 2^-n for n <= 60, exactly.
#define DIRT_TWO_TO_MINUS(n) (1.0f / float(1 << ((n) / 2)) / float(1 << ((n) - (n) / 2)))

DIRT_SHARED_BEGIN

// ---------------------------------------------------------------- what a tile lists

/// Width of the guard band that construction aims at, as a fraction of a tile. It must lie between
/// what every tile has to list (1/512, G1) and what none may list (1/64, G2), with room on both
/// sides for rounding: coverage.cpp derives how much.
const double kGuardBand = 1.0f / 128.0f;

/// n . v in double, n a cross product of floats rounded once: where it exceeds this part of its
/// terms' magnitudes, of which it is off by 2.5 * 2^-53 at most, it has the exact sign and a
/// relative error of 2.5 * 2^-27. Below, exact sums decide (coverage.cpp).
const double kSignDoubt = DIRT_TWO_TO_MINUS(26);

/// A depth found by the clip is good for 2^-24 (clip.cpp). That it is moved by four times as much
/// is part of what lists are, to the bit; G2 allows four times more.
const double kDepthMargin = DIRT_TWO_TO_MINUS(22);

// ---------------------------------------------------------------- hits

/// err(t) = kRelativeErrorT * t (T4): hits whose computed t are in one order have exact t in the
/// same order, or apart by less. A hit's t is the exact value with a relative error of at most
/// 2^-28, rounded once to float: 2^-24 + 2^-28 each, 2^-23 (1 + 2^-4) for two, here rounded up to
/// 2^-23 (1 + 2^-3). Results below FLT_MIN become zero.
const float kRelativeErrorT = 1.125f * DIRT_TWO_TO_MINUS(23);

/// How far behind the best hit, relative to its t, a search goes on: the error of one hit,
/// 2^-24 + 2^-28, rounded up (hit_rules.h).
const double kFinality = 1.125f * DIRT_TWO_TO_MINUS(24);

/// How far inside the view's border, relative to t, a ray in single mode ends: twice err(t)
/// (view_cone.h). The error of one hit would do; this is part of what such a view shows.
const double kConeInset = 2.25f * DIRT_TWO_TO_MINUS(23);

/// Error of the determinant of an edge or a side, of the product of three norms: 14 * 2^-53
/// (intersect.cpp).
const double kEdgeError = DIRT_TWO_TO_MINUS(49);

/// The plane's determinants: the same error where the value is above this part of the norms is
/// 2^-29 of it, which makes the 2^-28 of t.
const double kPlaneDoubt = DIRT_TWO_TO_MINUS(20);

/// By how much the sum of the weights has to exceed the error of one for the barycentric weights
/// to be good for 2^-23: u is off by (1 - u) of one error and u of two more, which is two at most,
/// and by a rounding of 2^-25.
const double kSureWeights = 1.0f / DIRT_TWO_TO_MINUS(25);

/// The normal of a thinner triangle, relative to its edges, is found exactly (offset.cpp).
const double kNeedle = DIRT_TWO_TO_MINUS(30);

/// First step off a surface, of the point's 1-norm (offset.cpp).
const double kOffsetStep = DIRT_TWO_TO_MINUS(23);

// ---------------------------------------------------------------- the filter before a decision

/// Of a lateral coordinate, of N: 5 u, u = 2^-24; four times this bounds the determinants of two,
/// which need 30 u of N and the largest (ray_filter.h).
const float kLateralError = DIRT_TWO_TO_MINUS(21);

// ---------------------------------------------------------------- the walk

/// Parameters at which borders are crossed, and their comparison: 7 * 2^-53 each, 5 of them by a
/// division that GLSL promises to 2.5 ulp (view_ray.h).
const double kCrossingSlack = DIRT_TWO_TO_MINUS(49);

/// Which border comes first, of the terms' magnitudes: m has one rounding a component, two products
/// and their sum one each, where the whole cancels 2 * 2^-53; view_walk.h shows what more costs.
const double kCornerDoubt = DIRT_TWO_TO_MINUS(51);

/// Depths of a ray at borders: 7 * 2^-53, as above, and the rounding of what they are moved to.
const double kDepthSlack = DIRT_TWO_TO_MINUS(50);

#ifdef __cplusplus

// ---------------------------------------------------------------- backend_cpu: walk and leaves

/// Parameters and depths of SIMD's walk: 4 * 2^-53, and the rounding of what they are moved to;
/// 2^-24, and the rounding to float (tile_walk-inl.h). The part of |o| that the depth of a ray has
/// to keep for that (tracer.cpp).
const double kVisitSlack = DIRT_TWO_TO_MINUS(50);
const double kVisitDepthSlack = DIRT_TWO_TO_MINUS(23);
const double kNearestWalked = DIRT_TWO_TO_MINUS(26);

/// The parameters of a visit as floats: one rounding of 2^-24, and one of a double
/// (leaf_test-inl.h).
const double kPartSlack = DIRT_TWO_TO_MINUS(23);

/// Planes of boxes, and the least component of a direction, of the largest (leaf_test-inl.h).
const float kBoxPad = DIRT_TWO_TO_MINUS(21);
const float kLeastDirection = DIRT_TWO_TO_MINUS(40);

/// The ends of a cell, of the tile's far depth: seven roundings of 2^-24 (leaf_boxes.cpp).
const float kCellSlack = DIRT_TWO_TO_MINUS(21);

/// A component of a triangle's normal, of its two products: 3 * 2^-53 (without_area.cpp).
const double kThinDoubt = DIRT_TWO_TO_MINUS(51);

// ---------------------------------------------------------------- backend_cpu: the light grid

/// Places of the guard besides those that grow with the distance: 3.5 (light_raster.h).
const double kLightPlaces = 4.0;

/// Nothing listed is nearer than this part of the reach: what comes nearer is tested by all rays.
const float kLightNearest = DIRT_TWO_TO_MINUS(11);

/// So all that rays meet is within 2^11 + 4 places, some 2^-12 of slope, of where they
/// are looked up. Triangles that stay nearly twice as far within a face are in no other's lists.
const double kLightRim = DIRT_TWO_TO_MINUS(11);

/// Depths, off by 2^-24, and rounded to float, stay below what they bound. A point of a ray is at
/// most (1 + 2^-24) as deep as its origin, whose depth has two roundings.
const double kLightBelow = DIRT_TWO_TO_MINUS(22);
const float kLightBeyond = DIRT_TWO_TO_MINUS(22);

/// Of the cone's angle and slopes. Wider than what the rounding of axis and angle, 2^-22 each, may
/// cost, slopes twice that: rays beside the rectangles would be traced in the ordinary way.
const double kLightConeSlack = DIRT_TWO_TO_MINUS(19);

/// Errors of a LightTriangle in double (light_raster.h): 24 * 2^-53 of the squared size for its
/// determinant, and for three components of an edge's normal; 4 * 2^-53 of the normal's 1-norm.
const double kLightError = DIRT_TWO_TO_MINUS(48);
const double kLightNormalError = DIRT_TWO_TO_MINUS(50);

/// An edge bounds rows, and a plane bounds depths, where what divides exceeds this part of the
/// squared size: then errors are below half a place, and below 2^-24 of the depth.
const double kLightEdgeClear = DIRT_TWO_TO_MINUS(24);
const double kLightDepthClear = DIRT_TWO_TO_MINUS(24);

/// A record of planes (light_setup-inl.h): rounding to float; what double adds to the own plane.
const double kLightRecord = DIRT_TWO_TO_MINUS(24);
const double kLightOwnError = DIRT_TWO_TO_MINUS(48);
const double kLightOwnRounding = DIRT_TWO_TO_MINUS(51);

#endif

DIRT_SHARED_END

#endif
