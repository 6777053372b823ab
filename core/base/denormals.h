#pragma once

#include "shaders/shared/rounding.h"

#if defined(__x86_64__) || defined(_M_X64)
#include <xmmintrin.h>
#endif

namespace dirt {

/// Sets whether denormals are flushed to zero while it lives.
template <bool Flush>
class DenormalMode {
public:
#if defined(__x86_64__) || defined(_M_X64)
    DenormalMode() : saved_(_mm_getcsr()) {
        constexpr unsigned kFlushToZero = 0x8000, kDenormalsAreZero = 0x0040;
        constexpr unsigned kBoth = kFlushToZero | kDenormalsAreZero;
        _mm_setcsr(Flush ? saved_ | kBoth : saved_ & ~kBoth);
    }
    ~DenormalMode() {
        _mm_setcsr(saved_);
    }

private:
    unsigned saved_;
#else
    DenormalMode() {}
    ~DenormalMode() {}
#endif

public:
    DenormalMode(const DenormalMode&) = delete;
    DenormalMode& operator=(const DenormalMode&) = delete;
};

/// As GPUs do (G7). The geometry's scale keeps away from denormals; where one arises all the same,
/// every backend has to see the same zero.
using FlushDenormals = DenormalMode<true>;

/// For what comes before the scale.
using KeepDenormals = DenormalMode<false>;

} // namespace dirt
