// What G7 asks of a stage's arithmetic. The host computes the same and compares the bits.

/// Products, sums and differences of floats; a product that is added must be rounded first; the
/// sum of a double and a float rounds to nearest when it becomes a float.
uvec4 testFloats(vec3 v) {
    precise float product = v.x * v.y;
    precise float difference = v.x - v.z;
    precise float sum = product + v.z;
    precise float rounded = float(double(v.x) * double(v.y) + double(v.z));
    return uvec4(floatBitsToUint(product), floatBitsToUint(difference), floatBitsToUint(sum),
                 floatBitsToUint(rounded));
}

/// The same of doubles: the product of two floats is exact; its product with a third, a sum and a
/// quotient are rounded.
uvec4 testDoubles(vec3 v) {
    precise double product = double(v.x) * double(v.y);
    precise double cubed = product * double(v.z) * double(v.x);
    precise double sum = cubed + double(v.y);
    precise double quotient = sum / double(v.z);
    return uvec4(unpackDouble2x32(product), unpackDouble2x32(quotient));
}
