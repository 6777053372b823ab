#ifndef DIRT_SHARED_EXPONENTIAL_H
#define DIRT_SHARED_EXPONENTIAL_H

#include "shaders/shared/language.h"

DIRT_SHARED_BEGIN

/// Natural logarithm of a normal, positive x, error below 0.9 ulp; exact at 1. Like Cephes' logf:
/// x = 2^e (1 + f) with 1 + f in [sqrt(1/2), sqrt(2)), log(1 + f) = f - f^2/2 + f^3 P(f), P
/// minimax.
DIRT_FUNCTION float naturalLog(float x) {
    const uint kSqrtHalf = 0x3f3504f3u;
    // The subtraction may wrap: the shift of the signed difference rounds e downwards.
    int e = int(floatBitsToUint(x) - kSqrtHalf) >> 23;
    DIRT_PRECISE float f = uintBitsToFloat(floatBitsToUint(x) - (uint(e) << 23u)) - 1.0f;
    DIRT_PRECISE float p = 0.06915539503097534f;
    p = p * f - 0.11789864301681519f;
    p = p * f + 0.11872926354408264f;
    p = p * f - 0.12384334951639175f;
    p = p * f + 0.14218664169311523f;
    p = p * f - 0.16669252514839172f;
    p = p * f + 0.20002226531505585f;
    p = p * f - 0.24999986588954926f;
    p = p * f + 0.3333331048488617f;
    DIRT_PRECISE float z = f * f;
    // ln 2 = 0.693359375 - 2.12194440e-4: e times the first part is exact.
    DIRT_PRECISE float tail = f * z * p + float(e) * -2.12194440e-4f;
    DIRT_PRECISE float head = f + (tail - 0.5f * z);
    return head + float(e) * 0.693359375f;
}

/// 2^x with an error below 1.2 ulp for x in [-125, 127]; 0 below, the largest float above.
DIRT_FUNCTION float powerOfTwo(float x) {
    if (x < -125.0f) return 0.0f;
    if (x > 127.0f) return 3.40282347e38f;
    DIRT_PRECISE float whole = floor(x + 0.5f);
    DIRT_PRECISE float f = x - whole;
    DIRT_PRECISE float p = 1.547629949e-4f;
    p = p * f + 1.340026967227459e-3f;
    p = p * f + 9.618003852665424e-3f;
    p = p * f + 0.055503278970718384f;
    p = p * f + 0.24022650718688965f;
    p = p * f + 0.6931471824645996f;
    p = p * f + 1.0f;
    return p * uintBitsToFloat(uint(int(whole) + 127) << 23u);
}

/// x^y for x in (0, 1] and y >= 0, with a relative error of at most 2^-22 (1 + y |log2 x|).
DIRT_FUNCTION float unitPower(float x, float y) {
    DIRT_PRECISE float exponent = y * (naturalLog(x) * 1.4426950216293335f);
    return powerOfTwo(exponent);
}

/// e^x with a relative error below 2^-22 (1 + |x|); 0 below -86, the largest float above 88.
DIRT_FUNCTION float exponential(float x) {
    DIRT_PRECISE float exponent = x * 1.4426950216293335f;
    return powerOfTwo(exponent);
}

/// log(1 + x) for x >= 0, to a few ulp for tiny x as well: what is lost in 1 + x cancels in the
/// quotient (W. Kahan).
DIRT_FUNCTION float logOnePlus(float x) {
    DIRT_PRECISE float sum = 1.0f + x;
    DIRT_PRECISE float rounded = sum - 1.0f;
    if (rounded == 0.0f) return x;
    DIRT_PRECISE float result = naturalLog(sum) * (x / rounded);
    return result;
}

/// e^x - 1 for x >= 0, to a few ulp for tiny x as well, in the same way.
DIRT_FUNCTION float exponentialMinusOne(float x) {
    float power = exponential(x);
    DIRT_PRECISE float difference = power - 1.0f;
    if (difference == 0.0f) return x;
    if (x > 16.0f) return difference;
    DIRT_PRECISE float result = difference * (x / naturalLog(power));
    return result;
}

DIRT_SHARED_END

#endif
