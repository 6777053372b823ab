#ifndef DIRT_SHARED_TRIGONOMETRY_H
#define DIRT_SHARED_TRIGONOMETRY_H

#include "shaders/shared/language.h"

DIRT_SHARED_BEGIN

/// sin(2 pi u) and cos(2 pi u) for u in [0, 1]. Each has an error below 1.7 ulp, and none
/// where u is a multiple of 1/4. The reduction to r in [-1/2, 1/2] quarter turns is exact; the
/// polynomials are minimax (Remez) for sin and cos of (pi/2) r.
DIRT_FUNCTION void sinCosTwoPi(float u, DIRT_OUT(float) sine, DIRT_OUT(float) cosine) {
    DIRT_PRECISE float quarters = 4.0f * u;
    DIRT_PRECISE float nearest = floor(quarters + 0.5f);
    DIRT_PRECISE float r = quarters - nearest;
    DIRT_PRECISE float z = r * r;
    // pi/2 = 1.57079637 - 4.37113883e-8: the second part is added where it still counts.
    DIRT_PRECISE float s =
        r * 1.5707963705062866f +
        r * (z * (-0.6459636688232422f + z * (0.07968158274888992f + z * -0.004605310037732124f)) -
             4.371138828673793e-8f);
    DIRT_PRECISE float c =
        1.0f +
        z * (-1.2337005138397217f +
             z * (0.25366923213005066f + z * (-0.02086028829216957f + z * 0.0009040216682478786f)));
    int quadrant = int(nearest) & 3;
    bool swapped = (quadrant & 1) != 0;
    sine = swapped ? c : s;
    cosine = swapped ? s : c;
    if (quadrant >= 2) sine = -sine;
    if (quadrant == 1 || quadrant == 2) cosine = -cosine;
}

DIRT_SHARED_END

#endif
