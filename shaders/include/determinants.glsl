// core/trace/determinant.h in GLSL: exact determinants of floats, as sums of triple products.

/// x . (y × z) of the same place in all three, one after the other.
struct TripleProducts {
    vec3 x[4], y[4], z[4];
    int count;
};

// Half of the places of a sum's parts: compilers unroll loops of 32 rounds and no more, and then
// all indices are constants. Places in memory cost more than the sum.
const int kHalf = 24;

/// Adds a term to parts of increasing magnitude, which move down by one place; the lowest, which is
/// returned, out of this half. \p term: what is left for the place above.
double addTo(inout double parts[kHalf], inout double term) {
    double lowest = 0.0LF;
    for (int p = 0; p < kHalf; ++p) { // TWO-SUM
        double part = parts[p];
        precise double total = part + term;
        precise double virtualTerm = total - part;
        precise double error = (part - (total - virtualTerm)) + (term - virtualTerm);
        if (p == 0)
            lowest = error;
        else
            parts[p - 1] = error;
        term = total;
    }
    return lowest;
}

/// The sum: relative error at most 2^-50, exact sign. The same parts in the same order as ExactSum
/// of core/base/exact_sum.h, the largest in the last place; zeros elsewhere, which change nothing.
/// Of 48 terms, the last finds the first place empty.
double exactValue(TripleProducts sum) {
    double low[kHalf], high[kHalf]; // nonoverlapping, of increasing magnitude
    for (int p = 0; p < kHalf; ++p) {
        low[p] = 0.0LF;
        high[p] = 0.0LF;
    }
    vec3 x = sum.x[0], y = sum.y[0], z = sum.z[0];
    for (int at = 0; at < 12 * sum.count; ++at) {
        // x_i y_j z_k and -x_i y_k z_j; i is 0 as the axes take turns.
        bool negative = (at & 2) != 0;
        precise double xy = double(negative ? -x.x : x.x) * double(negative ? y.z : y.y);
        // The product of two floats is exact in double; split into halves of 26 bits (Dekker,
        // Veltkamp), each half times the third float is exact as well.
        precise double splitter = 134217729.0LF * xy; // 2^27 + 1
        precise double upper = splitter - (splitter - xy);
        precise double lower = xy - upper;
        precise double term = ((at & 1) == 0 ? upper : lower) * double(negative ? z.y : z.z);
        addTo(low, term);
        double moved = addTo(high, term);
        low[kHalf - 1] = moved;
        high[kHalf - 1] = term;
        if ((at & 3) != 3) continue;
        x = x.yzx;
        y = y.yzx;
        z = z.yzx;
        for (int i = 1; i < 4; ++i)
            if (at + 1 == 12 * i) {
                x = sum.x[i];
                y = sum.y[i];
                z = sum.z[i];
            }
    }
    precise double value = 0.0LF;
    for (int p = 0; p < kHalf; ++p) value = value + low[p];
    for (int p = 0; p < kHalf; ++p) value = value + high[p];
    return value;
}

void setTripleProduct(inout TripleProducts sum, int i, vec3 x, vec3 y, vec3 z) {
    sum.x[i] = x;
    sum.y[i] = y;
    sum.z[i] = z;
}

/// d . ((b - o) × (c - o))
void setEdgeDeterminant(out TripleProducts sum, vec3 o, vec3 d, vec3 b, vec3 c) {
    sum.count = 3;
    setTripleProduct(sum, 0, d, b, c);
    setTripleProduct(sum, 1, d, o, b);
    setTripleProduct(sum, 2, d, c, o);
}

/// (p - a) . ((b - a) × (c - a))
void setPlaneDeterminant(out TripleProducts sum, vec3 p, vec3 a, vec3 b, vec3 c) {
    sum.count = 4;
    setTripleProduct(sum, 0, p, a, b);
    setTripleProduct(sum, 1, p, b, c);
    setTripleProduct(sum, 2, p, c, a);
    setTripleProduct(sum, 3, -a, b, c);
}

/// d . ((b - a) × (c - a))
void setDirectionDeterminant(out TripleProducts sum, vec3 d, vec3 a, vec3 b, vec3 c) {
    sum.count = 3;
    setTripleProduct(sum, 0, d, a, b);
    setTripleProduct(sum, 1, d, b, c);
    setTripleProduct(sum, 2, d, c, a);
}

double planeDeterminantExact(vec3 p, vec3 a, vec3 b, vec3 c) {
    TripleProducts sum;
    setPlaneDeterminant(sum, p, a, b, c);
    return exactValue(sum);
}

double directionDeterminantExact(vec3 d, vec3 a, vec3 b, vec3 c) {
    TripleProducts sum;
    setDirectionDeterminant(sum, d, a, b, c);
    return exactValue(sum);
}
