#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace dirt {

/// The exact sum of doubles, held as a nonoverlapping expansion of increasing magnitude
/// (Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
/// Predicates", 1997, GROW-EXPANSION with zero elimination).
class ExactSum {
public:
    /// Adds x y z exactly. The product of two floats is exact in double; split into halves of 26
    /// bits, each half times the third float is exact as well.
    void addProduct(float x, float y, float z) {
        const double xy = (double) x * y;
        const double splitter = 134217729.0 * xy; // 2^27 + 1 (Dekker, Veltkamp)
        const double high = splitter - (splitter - xy);
        add(high * z);
        add((xy - high) * z);
    }

    void add(double x) {
        int kept = 0;
        for (int i = 0; i < count_; ++i) {
            // TWO-SUM
            const double sum = parts_[i] + x;
            const double virtualX = sum - parts_[i];
            const double error = (parts_[i] - (sum - virtualX)) + (x - virtualX);
            if (error != 0.0) parts_[kept++] = error;
            x = sum;
        }
        if (x != 0.0) parts_[kept++] = x;
        count_ = kept;
    }

    /// Relative error at most 2^-52; exact sign. The largest part outweighs the rest.
    double value() const {
        double sum = 0.0;
        for (int i = 0; i < count_; ++i) sum += parts_[i];
        return sum;
    }

private:
    // Nonoverlapping parts are at least a bit apart, and products of three floats span 2^-447 to
    // 2^384; but each addProduct adds at most two parts, and no determinant has more than 24.
    std::array<double, 48> parts_{};
    int count_ = 0;
};

/// Adds x . (y × z) to \p sum.
inline void addTripleProduct(ExactSum& sum, glm::vec3 x, glm::vec3 y, glm::vec3 z) {
    sum.addProduct(x.x, y.y, z.z);
    sum.addProduct(-x.x, y.z, z.y);
    sum.addProduct(x.y, y.z, z.x);
    sum.addProduct(-x.y, y.x, z.z);
    sum.addProduct(x.z, y.x, z.y);
    sum.addProduct(-x.z, y.y, z.x);
}

/// x . (y × z): relative error at most 2^-50, exact sign.
inline double tripleProductExact(glm::vec3 x, glm::vec3 y, glm::vec3 z) {
    ExactSum sum;
    addTripleProduct(sum, x, y, z);
    return sum.value();
}

} // namespace dirt
