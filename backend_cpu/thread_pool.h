#pragma once

#include "core/base/executor.h"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace dirt {

/// A fixed set of threads that share the pieces of one loop at a time; the caller is one of them. A
/// loop is not to be run from inside a piece.
class ThreadPool final : public Executor {
public:
    /// Makes a thread; throws where there cannot be one more.
    using Start = std::function<std::thread(std::function<void()>)>;

    /// \p threads at least 1; 0 takes as many as the machine has. Where one cannot be made, those
    /// there are do the work.
    explicit ThreadPool(unsigned threads = 0, const Start& start = startThread);
    ~ThreadPool() override;
    ThreadPool(const ThreadPool&) = delete;
    ThreadPool& operator=(const ThreadPool&) = delete;

    unsigned threads() const override { return (unsigned) workers_.size() + 1; }
    /// How many threads could not be made.
    unsigned missing() const { return missing_; }

private:
    struct Loop {
        size_t count = 0, grain = 1;
        const Piece* piece = nullptr;
        std::atomic<size_t> next{0};
        std::exception_ptr error;
    };
    void runPieces(size_t count, size_t grain, const Piece& piece) override;
    static std::thread startThread(std::function<void()> run);
    void work();
    void takePart();

    std::vector<std::thread> workers_;
    unsigned missing_ = 0;
    std::mutex mutex_;
    std::condition_variable start_, done_;
    Loop loop_;
    uint64_t generation_ = 0; ///< counts loops, so that a worker takes part in each once
    size_t busy_ = 0;         ///< workers that have not finished the current loop
    bool stopping_ = false;
};

} // namespace dirt
