// Which rays are traced, which hit one keeps, how far its search goes on, and under which tile the
// hit is filed (T3).
#ifndef DIRT_SHARED_HIT_RULES_H
#define DIRT_SHARED_HIT_RULES_H

#include "shaders/shared/layouts.h"
#ifndef DIRT_NO_DOUBLES
#include "shaders/shared/margins.h"
#endif
#include "shaders/shared/rounding.h"

DIRT_SHARED_BEGIN

/// Neither infinite nor NaN. By the bits, as a compiler may reason that there is no NaN.
DIRT_FUNCTION bool hasFiniteBits(float x) {
    return (floatBitsToUint(x) & 0x7f800000u) != 0x7f800000u;
}

/// Whether a ray meets anything at all: it is finite, and has a direction.
DIRT_FUNCTION bool isTraceable(vec3 origin, vec3 direction) {
    bool finite = true;
    for (int i = 0; i < 3; ++i)
        finite = finite && hasFiniteBits(origin[i]) && hasFiniteBits(direction[i]);
    return finite && direction != vec3(0.0f);
}

#ifndef DIRT_NO_DOUBLES

/// What is beyond t when all that lies before it has been seen: no candidate whose computed t is
/// at most \p t has an exact t above this, nor one that flushing to zero may hide.
DIRT_FUNCTION double upperBound(float t) {
    DIRT_PRECISE double bound = double(t) * (1.0 + kFinality) + double(kSmallestNormal);
    return bound;
}

#endif

/// Whether a hit takes the place of the best one: nearer, or at equal t of a lower id.
DIRT_FUNCTION bool isNearer(float t, uint id, float bestT, uint bestId) {
    return bestId == kNoPrimitive || t < bestT || (t == bestT && id < bestId);
}

#ifndef DIRT_NO_DOUBLES

/// Whether the exact t of a hit may lie between two parameters.
DIRT_FUNCTION bool mayHold(double begin, double end, float t) {
    DIRT_PRECISE double error = double(t) * double(kRelativeErrorT) + double(kSmallestNormal);
    DIRT_PRECISE double late = double(t) + error;
    DIRT_PRECISE double early = double(t) - error;
    return begin <= late && early <= end;
}

#endif

DIRT_SHARED_END

#endif
