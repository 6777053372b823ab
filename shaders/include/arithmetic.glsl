// Floats without denormals, whether or not the stage flushes them (G7), and outward rounding.

const float kSmallestNormal = 1.17549435e-38;
const float kLargest = 3.40282347e38;

/// x, or zero where it is denormal.
float flushed(float x) {
    return abs(x) < kSmallestNormal ? 0.0 : x;
}

/// The largest float that is not above x >= 0; zero in place of a denormal.
float roundDown(double x) {
    if (x < double(kSmallestNormal)) return 0.0;
    if (x >= double(kLargest)) return kLargest;
    precise float f = float(x);
    return double(f) > x ? uintBitsToFloat(floatBitsToUint(f) - 1u) : f;
}

/// The smallest float that is not below x >= 0, the largest at most; the smallest normal one in
/// place of a denormal.
float roundUp(double x) {
    if (x <= 0.0LF) return 0.0;
    if (x <= double(kSmallestNormal)) return kSmallestNormal;
    if (x >= double(kLargest)) return kLargest;
    precise float f = float(x);
    return double(f) < x ? uintBitsToFloat(floatBitsToUint(f) + 1u) : f;
}

/// v times a power of two that brings its largest |component| into [0.5, 1), without denormals.
/// The components are 0 or normal, and so is the scale.
vec3 scaledToUnit(dvec3 v) {
    double largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (largest == 0.0LF) return vec3(0.0);
    uint exponent = (unpackDouble2x32(largest).y >> 20) & 0x7ffu; // 2^(exponent - 1022) > largest
    double scale = packDouble2x32(uvec2(0u, (2045u - exponent) << 20));
    precise vec3 unit = vec3(v * scale);
    return vec3(flushed(unit.x), flushed(unit.y), flushed(unit.z));
}
