#include "bench/bandwidth.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <vector>

namespace dirt {

double measureBandwidth(Executor& executor) {
    constexpr size_t kBytes = size_t(96) << 20; // far more than caches hold
    constexpr size_t kPiece = size_t(1) << 20;
    constexpr int kRounds = 7;
    std::vector<char> from(kBytes, 1), to(kBytes, 2);
    double best = 0.0;
    for (int round = 0; round < kRounds; ++round) {
        const auto start = std::chrono::steady_clock::now();
        executor.forRange(kBytes, kPiece, [&](size_t begin, size_t end) {
            std::memcpy(to.data() + begin, from.data() + begin, end - begin);
        });
        const std::chrono::duration<double, std::milli> passed =
            std::chrono::steady_clock::now() - start;
        best = std::max(best, 2.0 * (double) kBytes / passed.count());
        from.swap(to);
    }
    return best;
}

} // namespace dirt
