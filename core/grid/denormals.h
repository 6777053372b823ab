#pragma once

#if defined(__x86_64__) || defined(_M_X64)
#include <immintrin.h>
#endif

#include <cfloat>
#include <cmath>

namespace dirt {

/// Flushes denormals to zero while it lives, as GPUs do (G7). The geometry's scale keeps away from
/// them; where one arises all the same, every backend has to see the same zero.
class FlushDenormals {
public:
#if defined(__x86_64__) || defined(_M_X64)
    FlushDenormals() : saved_(_mm_getcsr()) {
        _mm_setcsr(saved_ | kFlushToZero | kDenormalsAreZero);
    }
    ~FlushDenormals() {
        _mm_setcsr(saved_);
    }

private:
    static constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040;
    unsigned saved_;
#else
    FlushDenormals() {}
    ~FlushDenormals() {}
#endif

public:
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;
};

/// \p x, or zero where it is denormal; for code that must not depend on the mode above.
inline float flushed(float x) {
    return std::fabs(x) < FLT_MIN ? 0.0f : x;
}

} // namespace dirt
