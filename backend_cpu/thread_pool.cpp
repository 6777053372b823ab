#include "backend_cpu/thread_pool.h"

#include <algorithm>
#include <utility>

namespace dirt {

std::thread ThreadPool::startThread(std::function<void()> run) {
    return std::thread(std::move(run));
}

ThreadPool::ThreadPool(unsigned threads, const Start& start) {
    if (threads == 0) threads = std::max(1u, std::thread::hardware_concurrency());
    workers_.reserve(threads - 1);
    try {
        while (this->threads() < threads) workers_.push_back(start([this] { work(); }));
    } catch (const std::exception&) { // no more processes or memory are allowed
        missing_ = threads - this->threads();
    }
}

ThreadPool::~ThreadPool() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    start_.notify_all();
    for (std::thread& worker : workers_) worker.join();
}

void ThreadPool::runPieces(size_t count, size_t grain, const Piece& piece) {
    if (count == 0) return;
    {
        const std::lock_guard lock(mutex_);
        loop_.count = count;
        loop_.grain = std::max<size_t>(grain, 1);
        loop_.piece = &piece;
        loop_.next = 0;
        loop_.error = nullptr;
        busy_ = workers_.size();
        ++generation_;
    }
    start_.notify_all();
    takePart();
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return busy_ == 0; });
    if (loop_.error) std::rethrow_exception(loop_.error);
}

void ThreadPool::work() {
    uint64_t seen = 0;
    for (;;) {
        {
            std::unique_lock lock(mutex_);
            start_.wait(lock, [&] { return stopping_ || generation_ != seen; });
            if (stopping_) return;
            seen = generation_;
        }
        takePart();
        const std::lock_guard lock(mutex_);
        if (--busy_ == 0) done_.notify_one();
    }
}

void ThreadPool::takePart() {
    for (;;) {
        const size_t begin = loop_.next.fetch_add(loop_.grain);
        if (begin >= loop_.count) return;
        try {
            (*loop_.piece)(begin, std::min(begin + loop_.grain, loop_.count));
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!loop_.error) loop_.error = std::current_exception();
            loop_.next = loop_.count; // the rest is not wanted any more
        }
    }
}

} // namespace dirt
