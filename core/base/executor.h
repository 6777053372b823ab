#pragma once

#include <cstddef>
#include <functional>

namespace dirt {

/// Runs a loop's pieces. Algorithms in core and the backends are written over this interface, so
/// that each has the serial form as its oracle.
class Executor {
public:
    /// Indices [begin, end) of a loop.
    using Piece = std::function<void(size_t begin, size_t end)>;

    virtual ~Executor() = default;

    /// Calls \p piece(begin, end) for pieces of at most \p grain indices that cover [0, count), in
    /// any order and on any thread; the pieces depend on count and grain only. Denormals are
    /// flushed while one runs (G7). Returns when all are done; rethrows the first exception.
    void forRange(size_t count, size_t grain, const Piece& piece);

    /// Threads that may run at once.
    virtual unsigned threads() const = 0;

private:
    /// forRange, but for denormals.
    virtual void runPieces(size_t count, size_t grain, const Piece& piece) = 0;
};

/// One piece after the other, on the caller's thread.
class SerialExecutor final : public Executor {
public:
    unsigned threads() const override { return 1; }

private:
    void runPieces(size_t count, size_t grain, const Piece& piece) override;
};

} // namespace dirt
