#pragma once

#include <cstddef>
#include <functional>

namespace dirt {

/// Runs a loop's pieces. Algorithms in core and the backends are written over this interface, so
/// that each has the serial form as its oracle.
class Executor {
public:
    virtual ~Executor() = default;

    /// Calls \p body(begin, end) for pieces of at most \p grain indices that cover [0, count), in
    /// any order and on any thread; the pieces depend on count and grain only. Returns when all
    /// are done; rethrows the first exception.
    virtual void forRange(size_t count, size_t grain,
                          const std::function<void(size_t begin, size_t end)>& body) = 0;

    /// Threads that may run at once.
    virtual unsigned threads() const = 0;
};

/// One piece after the other, on the caller's thread.
class SerialExecutor final : public Executor {
public:
    void forRange(size_t count, size_t grain,
                  const std::function<void(size_t, size_t)>& body) override {
        for (size_t begin = 0; begin < count; begin += grain)
            body(begin, begin + grain < count ? begin + grain : count);
    }
    unsigned threads() const override { return 1; }
};

} // namespace dirt
