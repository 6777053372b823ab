// core/base/exact_sum.h in GLSL: sums of doubles without any error.

const int kMostAddends = 12;

/// Nonoverlapping parts of increasing magnitude, the largest in the last place; zeros elsewhere,
/// which change nothing. So all indices are constants: places in memory cost more than the sum.
struct ExactSum {
    double parts[kMostAddends];
};

void add(inout ExactSum sum, double addend) {
    precise double term = addend;
    for (int i = 0; i < kMostAddends; ++i) { // TWO-SUM
        double part = sum.parts[i];
        precise double total = part + term;
        precise double virtualTerm = total - part;
        precise double error = (part - (total - virtualTerm)) + (term - virtualTerm);
        if (i > 0) sum.parts[i - 1] = error; // the first place is empty before the last addend
        term = total;
    }
    sum.parts[kMostAddends - 1] = term;
}

/// Adds x y z. The product of two floats is exact in double; split into halves of 26 bits (Dekker,
/// Veltkamp), each half times the third float is exact as well.
void addProduct(inout ExactSum sum, float x, float y, float z) {
    precise double xy = double(x) * double(y);
    precise double splitter = 134217729.0LF * xy; // 2^27 + 1
    precise double high = splitter - (splitter - xy);
    precise double low = xy - high;
    precise double highTerm = high * double(z);
    precise double lowTerm = low * double(z);
    add(sum, highTerm);
    add(sum, lowTerm);
}

/// x . (y × z): relative error at most 2^-50, exact sign.
double tripleProductExact(vec3 x, vec3 y, vec3 z) {
    ExactSum sum;
    for (int i = 0; i < kMostAddends; ++i) sum.parts[i] = 0.0LF;
    for (int i = 0; i < 3; ++i) {
        addProduct(sum, x.x, y.y, z.z);
        addProduct(sum, -x.x, y.z, z.y);
        x = x.yzx;
        y = y.yzx;
        z = z.yzx;
    }
    precise double total = 0.0LF;
    for (int i = 0; i < kMostAddends; ++i) total = total + sum.parts[i];
    return total;
}
