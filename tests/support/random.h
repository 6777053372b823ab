#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <initializer_list>

namespace dirt::test {

/// Whether the long forms run: DIRT_TEST_FULL=1 in the environment.
inline bool fullTests() {
    const char* value = std::getenv("DIRT_TEST_FULL");
    return value && value[0] == '1';
}

/// How many cases a randomised test runs: \p cut in the suite, \p full in the long form.
inline int cases(int cut, int full) {
    return fullTests() ? full : cut;
}

/// A small reproducible generator (SplitMix64): the same cases on every machine, which
/// std::uniform_real_distribution does not promise.
class Random {
public:
    explicit Random(uint64_t seed) : state(seed) {}

    uint64_t bits() {
        uint64_t z = state += 0x9e3779b97f4a7c15ull;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
        return z ^ (z >> 31);
    }
    /// In [0, 1).
    double uniform() { return (double) (bits() >> 11) * 0x1p-53; }
    double uniform(double lo, double hi) { return lo + (hi - lo) * uniform(); }
    /// In [0, n).
    int below(int n) { return (int) (bits() % (uint64_t) n); }
    /// In [lo, hi], both included.
    int range(int lo, int hi) { return lo + below(hi - lo + 1); }
    bool chance(double probability) { return uniform() < probability; }
    double sign() { return bits() & 1 ? 1.0 : -1.0; }
    /// +-10^U(lo, hi).
    double wide(double lo, double hi) { return sign() * std::pow(10.0, uniform(lo, hi)); }
    /// A power of two with an exponent in [lo, hi].
    double powerOfTwo(int lo, int hi) { return std::ldexp(1.0, range(lo, hi)); }
    template <class T>
    T pick(std::initializer_list<T> values) {
        return values.begin()[below((int) values.size())];
    }

private:
    uint64_t state;
};

} // namespace dirt::test
