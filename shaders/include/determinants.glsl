// core/trace/determinant.h in GLSL: exact determinants of floats, as sums of triple products.

/// Vectors x, y, z of up to four triple products x . (y × z).
struct TripleProducts {
    vec3 factors[12];
    int count; // of vectors
};

void addTripleProduct(inout TripleProducts sum, vec3 x, vec3 y, vec3 z) {
    sum.factors[sum.count++] = x;
    sum.factors[sum.count++] = y;
    sum.factors[sum.count++] = z;
}

/// The sum: relative error at most 2^-50, exact sign. The same parts in the same order as ExactSum
/// of core/grid/exact_sum.h.
double exactValue(TripleProducts sum) {
    double parts[48]; // nonoverlapping, of increasing magnitude
    int count = 0;
    for (int at = 0; at < sum.count; at += 3)
        for (int addend = 0; addend < 12; ++addend) {
            // x_i y_j z_k and -x_i y_k z_j for i = 0, 1, 2
            int product = addend / 2, i = product / 2;
            bool negative = product % 2 == 1;
            int j = (i + (negative ? 2 : 1)) % 3, k = (i + (negative ? 1 : 2)) % 3;
            float x = sum.factors[at][i];
            precise double xy =
                double(negative ? -x : x) * double(sum.factors[at + 1][j]);
            // The product of two floats is exact in double; split into halves of 26 bits (Dekker,
            // Veltkamp), each half times the third float is exact as well.
            precise double splitter = 134217729.0LF * xy; // 2^27 + 1
            precise double high = splitter - (splitter - xy);
            precise double low = xy - high;
            precise double term =
                (addend % 2 == 0 ? high : low) * double(sum.factors[at + 2][k]);
            int kept = 0;
            for (int p = 0; p < count; ++p) { // TWO-SUM
                precise double total = parts[p] + term;
                precise double virtualTerm = total - parts[p];
                precise double error = (parts[p] - (total - virtualTerm)) + (term - virtualTerm);
                if (error != 0.0LF) parts[kept++] = error;
                term = total;
            }
            if (term != 0.0LF) parts[kept++] = term;
            count = kept;
        }
    precise double value = 0.0LF;
    for (int p = 0; p < count; ++p) value = value + parts[p];
    return value;
}

/// d . ((b - o) × (c - o))
void addEdgeDeterminant(inout TripleProducts sum, vec3 o, vec3 d, vec3 b, vec3 c) {
    addTripleProduct(sum, d, b, c);
    addTripleProduct(sum, d, o, b);
    addTripleProduct(sum, d, c, o);
}

/// (p - a) . ((b - a) × (c - a))
void addPlaneDeterminant(inout TripleProducts sum, vec3 p, vec3 a, vec3 b, vec3 c) {
    addTripleProduct(sum, p, a, b);
    addTripleProduct(sum, p, b, c);
    addTripleProduct(sum, p, c, a);
    addTripleProduct(sum, -a, b, c);
}

/// d . ((b - a) × (c - a))
void addDirectionDeterminant(inout TripleProducts sum, vec3 d, vec3 a, vec3 b, vec3 c) {
    addTripleProduct(sum, d, a, b);
    addTripleProduct(sum, d, b, c);
    addTripleProduct(sum, d, c, a);
}

double planeDeterminantExact(vec3 p, vec3 a, vec3 b, vec3 c) {
    TripleProducts sum;
    sum.count = 0;
    addPlaneDeterminant(sum, p, a, b, c);
    return exactValue(sum);
}

double directionDeterminantExact(vec3 d, vec3 a, vec3 b, vec3 c) {
    TripleProducts sum;
    sum.count = 0;
    addDirectionDeterminant(sum, d, a, b, c);
    return exactValue(sum);
}
