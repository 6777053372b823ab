// core/grid/exact_sum.h in GLSL: sums of doubles without any error.

/// x . (y × z): relative error at most 2^-50, exact sign.
double tripleProductExact(vec3 x, vec3 y, vec3 z) {
    float products[18] = float[18](x.x, y.y, z.z, -x.x, y.z, z.y, //
                                   x.y, y.z, z.x, -x.y, y.x, z.z, //
                                   x.z, y.x, z.y, -x.z, y.y, z.x);
    double parts[12]; // nonoverlapping, of increasing magnitude
    int count = 0;
    for (int addend = 0; addend < 12; ++addend) {
        // The product of two floats is exact in double; split into halves of 26 bits (Dekker,
        // Veltkamp), each half times the third float is exact as well.
        int i = addend / 2 * 3;
        precise double xy = double(products[i]) * double(products[i + 1]);
        precise double splitter = 134217729.0LF * xy; // 2^27 + 1
        precise double high = splitter - (splitter - xy);
        precise double low = xy - high;
        precise double term = (addend % 2 == 0 ? high : low) * double(products[i + 2]);
        int kept = 0;
        for (int k = 0; k < count; ++k) { // TWO-SUM
            precise double sum = parts[k] + term;
            precise double virtualTerm = sum - parts[k];
            precise double error = (parts[k] - (sum - virtualTerm)) + (term - virtualTerm);
            if (error != 0.0LF) parts[kept++] = error;
            term = sum;
        }
        if (term != 0.0LF) parts[kept++] = term;
        count = kept;
    }
    precise double total = 0.0LF;
    for (int k = 0; k < count; ++k) total = total + parts[k];
    return total;
}
