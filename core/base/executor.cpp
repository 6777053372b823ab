#include "core/base/executor.h"

#include "core/base/denormals.h"

namespace dirt {

void Executor::forRange(size_t count, size_t grain, const Piece& piece) {
    // What captures no more than a reference fits into a std::function without allocation.
    runPieces(count, grain, [&piece](size_t begin, size_t end) {
        const FlushDenormals flush;
        piece(begin, end);
    });
}

void SerialExecutor::runPieces(size_t count, size_t grain, const Piece& piece) {
    for (size_t begin = 0; begin < count; begin += grain)
        piece(begin, begin + grain < count ? begin + grain : count);
}

} // namespace dirt
